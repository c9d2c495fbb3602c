import { expect } from '@esm-bundle/chai';
import spanTable from '../../../shaders/chunks/classify/span-table.glsl?raw';
import countSubstepsChunk from '../../../shaders/chunks/classify/count-substeps.glsl?raw';
import transferFunction from '../../../shaders/chunks/classify/transfer-function.glsl?raw';
import { buildSubstepTable } from '../../../src/optics/transfer/substep-table.ts';
import type { SubstepTable } from '../../../src/optics/transfer/substep-table.ts';
import { attenuate, countSubsteps, maxSubsteps } from '../../../src/optics/rays/segment.ts';
import {
  buildPreintegrationTable,
  integrateForTable,
  tableMeans,
} from '../../../src/optics/transfer/preintegration-table.ts';
import type { PreintegrationTable } from '../../../src/optics/transfer/preintegration-table.ts';
import type { Premultiplied, TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { sampleStruct } from '../../../src/renderer/ray/generate-chains.ts';
import { transferFunctionText } from '../../../src/renderer/ray/modules/transfer-function.ts';
import { cuttingSteps, uploadSubstepTable } from '../../../src/renderer/ray/substep-part.ts';
import { uploadTable } from '../../../src/renderer/textures/table-textures.ts';
import type { Uniforms } from '../../../src/renderer/device/inputs.ts';
import { smooth } from '../../helpers/emission.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** As in `smooth`, shares of the domain are data values. */
const jumps: TransferFunction = [
  { value: 0, color: [1, 0, 0], opacity: 0.7 },
  { value: 0, color: [0, 0, 1], opacity: 0.02 },
  { value: 0.6, color: [0, 0, 1], opacity: 0.02 },
  { value: 0.6, color: [1, 0, 0], opacity: 0.5 },
  { value: 1, color: [1, 0, 0], opacity: 0.5 },
  { value: 1, color: [0, 1, 0], opacity: 0.9 },
];
const opaque: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 1, color: [1, 1, 1], opacity: 1 },
];

function uniformsOf(table: PreintegrationTable): Uniforms {
  return {
    uTableSize: [table.columns, table.rows],
    uTableFirst: table.first,
    uTableLast: table.last,
    uMaxSubsteps: maxSubsteps,
  };
}

/** Spans of all widths: of none, narrow, wide, ascending, descending, half and wholly outside, touching the ends. */
function spans(): [number, number][] {
  const random = randomNumbers(41);
  const list: [number, number][] = [
    [0, 0],
    [1, 1],
    [0, 1],
    [1, 0],
    [-0.5, -0.5],
    [1.5, 1.5],
    [-3, 0],
    [1, 4],
    [-1e30, 1e30],
    [0.5, 1e9],
    [-1e9, 0.2],
  ];
  for (let i = 0; i < 900; i++) {
    const from = random() * 1.6 - 0.3;
    const width = 10 ** (random() * 6 - 5) * (random() < 0.5 ? -1 : 1);
    list.push([from, i % 5 === 0 ? from : from + width]);
  }
  return list.map(([from, to]) => [Math.fround(from), Math.fround(to)]);
}

/** The largest difference of two lists of colours, relative to the expected number where that is above 1. */
function worstOf(got: number[][], expected: Premultiplied[]): number {
  return Math.max(
    ...expected.flatMap((mean, i) => mean.map((x, c) => Math.abs(got[i][c] - x) / Math.max(1, Math.abs(x)))),
  );
}

for (const version of [1, 2] as const) {
  describe(`segments in WebGL ${version}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    function run(
      table: PreintegrationTable,
      point: { result: string; a: number[][]; substeps?: SubstepTable },
    ): number[][] {
      return runChunk(test, {
        defines: { ...transferFunctionText.defines, ...cuttingSteps.defines, NO_DATA: 0 },
        chunks: [sampleStruct([]), countSubstepsChunk, transferFunction, spanTable],
        uniforms: uniformsOf(table),
        units: [
          uploadTable(test.gl, table, null),
          ...(point.substeps ? [uploadSubstepTable(test.gl, point.substeps, null)] : []),
        ],
        ...point,
      });
    }

    it("meanOverSpan is the twin's of the same table", function () {
      if (!test.device.floatLinear) this.skip();
      const a = spans().map(([from, to]) => [from, to, 0, 0]);
      for (const [name, stops] of [
        ['smooth', smooth],
        ['jumps', jumps],
        ['opaque', opaque],
      ] as const) {
        const table = buildPreintegrationTable(stops);
        const means = tableMeans(table);
        const got = run(table, { result: 'meanOverSpan(a.x, a.y)', a });
        const worst = worstOf(
          got,
          a.map(([from, to]) => means.mean(from, to)),
        );
        console.log(`WebGL ${version}, ${name}: mean off by ${worst.toExponential(1)}`);
        // Coordinates of 2,048 columns in float32 are off by 1e-4 of a column, a device's weights by 1/512 of one. The
        // neighbours differ by up to the height of a jump (2.3 here), or of the last column before opacity 1 (13).
        expect(worst, name).to.be.below((name === 'opaque' ? 13 : 2.3) / 256);
        expect(got.flat().every(Number.isFinite)).to.equal(true);
      }
    });

    it("attenuate is the twin's from depths of 1e-30 to 1e30", () => {
      const a: number[][] = [];
      for (let exponent = -30; exponent <= 30; exponent++) a.push([0.9, 0.3, 0.6, exponent]);
      const table = buildPreintegrationTable(smooth);
      const got = run(table, { result: 'attenuate(vec4(a.xyz, 0.6), pow(10.0, a.w))', a });
      a.forEach(([red, green, blue, exponent], i) => {
        const expected = attenuate([red, green, blue, 0.6], 10 ** exponent);
        for (let c = 0; c < 4; c++) {
          // pow() and exp() of float32, relative, down to the least numbers that it holds well.
          expect(got[i][c], `depth 1e${exponent}, channel ${c}`).to.be.closeTo(expected[c], 1e-4 * expected[c] + 1e-37);
        }
      });
    });

    it("countSubsteps is the twin's of the same table", () => {
      const random = randomNumbers(43);
      for (const stops of [smooth, jumps, opaque]) {
        const table = buildPreintegrationTable(stops);
        for (const voxelRatio of [0, 1e-6, 1e-2, 0.3, 40, 1e30]) {
          const substeps = buildSubstepTable(integrateForTable(stops), voxelRatio);
          const a = spans().map(([from, to]) => [from, to, Math.fround(random()), 0]);
          const got = run(table, { result: 'vec4(countSubsteps(a.x, a.y, a.z))', a, substeps });
          const off = a.filter(([from, to, visible], i) => got[i][0] !== countSubsteps(substeps, [from, to], visible));
          // Half way between two texels, and next to where the count goes up by one, rounding may choose either.
          expect(off.length / a.length, `${voxelRatio}: ${off.slice(0, 3).join('; ')}`).to.be.below(0.005);
          expect(Math.max(...got.map(([count]) => count))).to.be.at.most(maxSubsteps);
        }
      }
    });

    it('attenuate makes nothing of no depth, and no number of none', () => {
      const table = buildPreintegrationTable(smooth);
      const a = [
        [0, 0, 0, 0],
        [0, 0, 0, 1],
        [1, 1, 1, 0],
      ];
      const got = run(table, { result: 'attenuate(vec4(a.xyz, a.x), a.w)', a });
      expect(got).to.deep.equal([
        [0, 0, 0, 0],
        [0, 0, 0, 0],
        [0, 0, 0, 0],
      ]);
    });

    it('opacity 1 stays 1, opacity 0 stays 0, over any length', () => {
      const table = buildPreintegrationTable([
        { value: 0, color: [1, 0.5, 0], opacity: 0 },
        { value: 1, color: [1, 0.5, 0], opacity: 0 },
        { value: 1, color: [1, 0.5, 0], opacity: 1 },
      ]);
      const a = [
        [1, 1, 0.01, 0],
        [2, 5, 0.3, 0],
        [7, 7, 1e6, 0],
        [0.2, 0.9, 1e6, 0],
        [-3, 0.5, 10, 0],
      ];
      const got = run(table, { result: 'attenuate(meanOverSpan(a.x, a.y), a.z)', a });
      expect(got.slice(0, 3)).to.deep.equal([
        [1, 0.5, 0, 1],
        [1, 0.5, 0, 1],
        [1, 0.5, 0, 1],
      ]);
      expect(got.slice(3)).to.deep.equal([
        [0, 0, 0, 0],
        [0, 0, 0, 0],
      ]);
    });
  });
}
