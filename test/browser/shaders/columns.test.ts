import { expect } from '@esm-bundle/chai';
import columnMeans from '../../../shaders/chunks/classify/column-means.glsl?raw';
import values from '../../../shaders/chunks/field/values.glsl?raw';
import { cutColumns, meanOverColumns } from '../../../src/optics/transfer/columns.ts';
import { domainOf } from '../../../src/optics/transfer/emission.ts';
import { attenuate } from '../../../src/optics/rays/segment.ts';
import { mapShares } from '../../../src/optics/transfer/share-map.ts';
import { placeThreshold } from '../../../src/optics/transfer/threshold.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { sampleStruct } from '../../../src/renderer/ray/generate-chains.ts';
import { createColumns } from '../../../src/renderer/ray/modules/columns.ts';
import type { FieldModule, RayFrame } from '../../../src/renderer/ray/ray-module.ts';
import { valueUniforms } from '../../../src/renderer/ray/uniforms.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { plainOptics } from '../../helpers/picture.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const functions: Record<string, TransferFunction> = {
  'found by bins': [
    { value: 0, color: [1, 0, 0], opacity: 0.7 },
    { value: 0, color: [0, 0, 1], opacity: 0.02 },
    { value: 0.6, color: [0, 0, 1], opacity: 0.2 },
    { value: 0.6, color: [1, 0, 0], opacity: 0 },
    { value: 0.61, color: [1, 0, 0], opacity: 0.9 },
    { value: 1, color: [1, 1, 0], opacity: 0 },
  ],
  'found by search': [
    { value: 0, color: [0, 0, 1], opacity: 0 },
    { value: 0.3, color: [1, 0, 0], opacity: 0.5 },
    { value: 0.3000003, color: [1, 0, 1], opacity: 0.1 },
    { value: 0.5, color: [0, 1, 1], opacity: 1 },
    { value: 1, color: [1, 0, 0], opacity: 0.5 },
  ],
};

/** Two samples, the mean between them, and what the second one emits. */
const both = `
vec4 meanBetween(vec2 stored) {
  Sample front;
  Sample back;
  front.stored = stored.x;
  back.stored = stored.y;
  front.value = toShare(stored.x);
  back.value = toShare(stored.y);
  return meanOfSamples(columnsField(vec3(0.0), front), columnsField(vec3(0.0), back));
}
`;

for (const version of [1, 2] as const) {
  describe(`columns in WebGL ${version}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    for (const [name, transferFunction] of Object.entries(functions)) {
      it(`${name} give the twin's means, and the twin's emission`, () => {
        const volume = { ...syntheticVolume({ dimensions: [9, 9, 9], kind: 'float32' }), range: [-0.3, 1.3] as const };
        const field = { name: 'cartesian', storedScale: 1, defines: { TEXTURE_3D: 1 } } as unknown as FieldModule;
        const frame = {
          volume,
          field,
          optics: { ...plainOptics, transferFunction },
          domain: domainOf(transferFunction),
        } as unknown as RayFrame;
        const made = createColumns(test.gl);
        const [module] = made.modulesFor(frame);
        expect(module.defines.COLUMN_BINS).to.equal(name === 'found by bins' ? 1 : 0);
        const { uniforms, units } = module.inputs(frame);
        const random = randomNumbers(76);
        const a = Array.from({ length: 1500 }, (_, i) => {
          const from = i % 9 === 0 ? transferFunction[i % transferFunction.length].value : random() * 1.6 - 0.3;
          return [from, i % 5 === 0 ? from : from + (random() - 0.5) * 10 ** (-6 * random()), 0, 0].map(Math.fround);
        });
        const run = (result: string): number[][] =>
          runChunk(test, {
            defines: { ...module.defines, NO_DATA: 0 },
            chunks: [values, sampleStruct([module]), ...module.chunks, columnMeans, both],
            uniforms: { ...uniforms, ...valueUniforms(frame) },
            units,
            a,
            result,
          });
        const { from, scale } = mapShares({ ...volume, storedScale: 1 }, [0, 1]);
        const columns = cutColumns(transferFunction, (value) =>
          placeThreshold({ ...volume, storedScale: 1, whole: false }, { from, scale }, value),
        );
        const shareOf = (stored: number): number => Math.fround(Math.fround(stored - from) * scale);
        const [means, emissions] = [run('meanBetween(a.xy)'), run('emissionAt(toShare(a.x))')];
        a.forEach(([x, y], i) => {
          const expected = attenuate(meanOverColumns(columns, shareOf(x), shareOf(y)), 0.3);
          attenuate(means[i] as [number, number, number, number], 0.3).forEach((channel, c) =>
            expect(255 * channel, `mean of ${x} to ${y}`).to.be.closeTo(255 * expected[c], 0.2),
          );
          // By the way of shares, which round: but for jumps and the pole, where that may be the other side.
          if (i % 9 === 0 || Math.abs(x - 0.5) < 1e-3) return;
          const point = attenuate(meanOverColumns(columns, shareOf(x), shareOf(x)), 0.3);
          attenuate(emissions[i] as [number, number, number, number], 0.3).forEach((channel, c) =>
            expect(255 * channel, `at ${x}`).to.be.closeTo(255 * point[c], 0.2),
          );
        });
        made.dispose();
      });
    }
  });
}
