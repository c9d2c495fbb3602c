import { expect } from '@esm-bundle/chai';
import { polarTapsOf } from '../../../src/radar/gpu/polar-taps.ts';
import { composePictureShader, gatheredPicture } from '../../../src/renderer/device/compose-picture.ts';
import type { ShaderTexts } from '../../../src/renderer/device/compose-stage.ts';
import { compileProgram } from '../../../src/renderer/device/program.ts';
import { interpolatedPicture } from '../../../src/renderer/passes/between-drawing.ts';
import { composeRay, listSamplers, maxSamplers, programKey } from '../../../src/renderer/ray/compose-ray.ts';
import type { RayProgram } from '../../../src/renderer/ray/compose-ray.ts';
import { composeStudyShader } from '../../../src/renderer/study.ts';
import { loadX3dom } from '../../../src/x3d/load-x3dom.ts';
import { coverPairs, listPairs, listRows } from '../../helpers/covering-array.ts';
import type { Row } from '../../helpers/covering-array.ts';
import { createGl, releaseGl } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { listDemoRays, listLevels, listRays, nameLevel, plainRay, programOf } from '../../helpers/ray-modules.ts';
import type { Level } from '../../helpers/ray-modules.ts';
import { remember } from '../../helpers/remember.ts';

/** What x3dom puts into a ComposedShader's texts before it compiles them. */
interface Injector {
  injectVRPartsVS(text: string): string;
  injectVRPartsFS(text: string): string;
}

/** Compile a ray's program as x3dom does. @returns the samplers that its text declares */
async function compile({ gl }: TestGl, program: RayProgram): Promise<string[]> {
  const x3dom = (await loadX3dom()) as unknown as { shader: { ComposedShader: { prototype: Injector } } };
  const injector = x3dom.shader.ComposedShader.prototype;
  const { vertex, fragment } = composeRay(program);
  const texts = { vertex: injector.injectVRPartsVS(vertex), fragment: injector.injectVRPartsFS(fragment) };
  expect(texts.fragment, 'x3dom found main()').to.contain('isVR').and.to.contain('FRAGMENT_COLOR = ');
  compileOne(gl, texts, programKey(program));
  return [...`${vertex}${fragment}`.matchAll(/^uniform sampler(?:2D|3D) (\w+);/gm)].map(([, name]) => name);
}

function compileOne(gl: TestGl['gl'], texts: ShaderTexts, name: string): void {
  try {
    gl.deleteProgram(compileProgram(gl, texts));
  } catch (error) {
    throw new Error(`${name}: ${String((error as Error).cause)}`, { cause: error });
  }
}

const raysOf = remember(listRays);

for (const version of [1, 2] as const) {
  const webgl2 = version === 2;
  describe(`the programs of rays in WebGL ${version}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    for (const [place, levels] of Object.entries(listLevels(webgl2))) {
      for (const level of levels.filter((one) => one !== null)) {
        it(`compile with ${nameLevel(level)} and little else`, async () => {
          const polar = listLevels(webgl2).field.find((field) => field?.name === 'polar')!;
          const { columns, classify, labels, overlay, points, shade, overlayAppearance, light, gather } =
            listLevels(webgl2);
          const companions: Record<string, Row<Level>> = {
            slices: { field: polar },
            columns: { classify: classify[1] },
            columnMeans: { columns: columns[1] },
            labels: level.defines.LABELS_HIDE ? { gather: gather[1] } : { shade: shade[1] },
            labelAppearances: { labels: labels[1] },
            overlay: {
              overlayAppearance: overlayAppearance[1],
              ...('SECOND_MOMENT' in level.defines && { field: polar }),
            },
            overlayAppearance: { overlay: overlay[1] },
            points: { light: light[1] },
            ambient: { points: points[1], light: light[1] },
            ...Object.fromEntries(
              ['lit', 'styled', 'surfaces', 'jumps'].map((name) => [
                name,
                { points: points[1], ...(level.chunks.includes(polarTapsOf.chunk) && { field: polar }) },
              ]),
            ),
          };
          const more = companions[level.name] ?? {};
          const program = programOf(webgl2, { ...plainRay(webgl2), ...more, [place]: level });
          expect(await compile(test, program), 'it reads the samplers that it says').to.have.members(
            listSamplers(program),
          );
        });
      }
    }

    it('compile with each pair of modules that can meet', async () => {
      const rows = coverPairs(raysOf(webgl2), nameLevel);
      console.log(`WebGL ${version}: ${rows.length} programs for all pairs of ${raysOf(webgl2).length} rays`);
      for (const [i, row] of rows.entries()) await compile(test, programOf(webgl2, row, i % 2 === 1));
    });

    it('compile with what the demos use', async () => {
      for (const row of listDemoRays(webgl2))
        for (const substeps of [false, true]) await compile(test, programOf(webgl2, row, substeps));
    });

    it(`read ${maxSamplers(webgl2)} samplers at most, whatever meets`, () => {
      const counts = raysOf(webgl2).map((row) => listSamplers(programOf(webgl2, row)).length);
      expect(Math.max(...counts)).to.be.within(6, maxSamplers(webgl2));
    });

    it('are others where their modules or options are others', () => {
      const rays = raysOf(webgl2);
      const keys = [false, true].flatMap((substeps) => rays.map((row) => programKey(programOf(webgl2, row, substeps))));
      expect(new Set(keys).size).to.equal(2 * rays.length);
    });

    it('of pictures from pictures compile', () => {
      for (const chunks of [interpolatedPicture, gatheredPicture])
        compileOne(test.gl, composePictureShader(chunks, webgl2), 'a picture');
    });

    it('that the compiler does not take are refused with its words', () => {
      const { vertex, fragment } = composeRay(programOf(webgl2, plainRay(webgl2)));
      expect(() => compileProgram(test.gl, { vertex, fragment: fragment.replace('float total', 'vec3 total') }))
        .to.throw()
        .with.property('code', 'webgl/shader');
    });
  });
}

describe('composing rays', () => {
  const plain = programOf(true, plainRay(true));

  it('takes one field, one classify and one gather module, and no more samplers than are guaranteed', () => {
    const without = (stage: string): RayProgram => ({
      ...plain,
      modules: plain.modules.filter((module) => module.stage !== stage),
    });
    for (const stage of ['field', 'classify', 'gather']) {
      expect(() => composeRay(without(stage))).to.throw(TypeError, `the stage ${stage} got 0 modules; expected 1`);
      const twice = plain.modules.filter((module) => module.stage === stage);
      expect(() => composeRay({ ...plain, modules: [...plain.modules, ...twice] })).to.throw(
        TypeError,
        `the stage ${stage} got 2 modules`,
      );
    }
    const thirsty = {
      name: 'thirsty',
      stage: 'shade',
      defines: {},
      chunks: [],
      samplers: ['uOne', 'uTwo', 'uThree', 'uFour', 'uFive'],
    } as const;
    const plain1 = programOf(false, plainRay(false), true);
    expect(() => composeRay({ ...plain1, modules: [...plain1.modules, thirsty] })).to.throw(
      TypeError,
      'got 10 samplers',
    );
  });

  it('puts into a program what its modules need and nothing else', () => {
    const [depth] = listLevels(true).depth.filter((level) => level !== null);
    expect(composeRay(plain).fragment).not.to.contain('uSceneDepth');
    expect(composeRay({ ...plain, adaptive: false, modules: [...plain.modules, depth] }).fragment).to.contain(
      'uniform sampler2D uSceneDepth',
    );
    expect(composeRay(plain).vertex).to.contain('uHalfPicture');
    expect(composeRay({ ...plain, adaptive: false }).vertex, "some devices can't").not.to.contain('uniform sampler2D');
  });

  it('makes the other programs of the study and the benchmark', () => {
    const test = createGl(2);
    for (const program of ['printed', 'plain', 'shipped', 'shown', 'fetched'] as const)
      compileOne(test.gl, composeStudyShader(program, plain), program);
    expect(test.gl.getError()).to.equal(0);
    releaseGl(test);
  });
});

describe('a covering array', () => {
  const factors = { a: ['1', '2', '3'], b: ['1', '2'], c: ['1', '2', '3', '4'], d: ['1', '2'] };
  const isLegal = (row: Readonly<Record<string, string>>): boolean =>
    !(row.a === '1' && row.c === '4') && !(row.b === '2' && row.d === '2');
  const name = (level: string): string => level;

  it('has every pair of levels that is legal, in few rows, and none that is not', () => {
    const rows = coverPairs(listRows(factors, isLegal), name);
    expect(rows.every(isLegal)).to.equal(true);
    // By another way: each two levels, and whether anything legal has both.
    const names = Object.keys(factors) as (keyof typeof factors)[];
    let pairs = 0;
    for (const [i, x] of names.entries()) {
      for (const y of names.slice(i + 1)) {
        for (const u of factors[x]) {
          for (const v of factors[y]) {
            const isPossible = listRows(factors, isLegal).some((row) => row[x] === u && row[y] === v);
            expect(
              rows.some((row) => row[x] === u && row[y] === v),
              `${x}${u} ${y}${v}`,
            ).to.equal(isPossible);
            pairs += Number(isPossible);
          }
        }
      }
    }
    expect(pairs)
      .to.equal(new Set(listRows(factors, isLegal).flatMap((row) => listPairs(row, name))).size)
      .and.to.equal(42);
    expect(rows.length, 'of 29').to.be.within(12, 15);
  });
});
