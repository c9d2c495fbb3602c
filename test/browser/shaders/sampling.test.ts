import { expect } from '@esm-bundle/chai';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { finishUpload } from '../../../src/renderer/textures/fill-texture.ts';
import {
  cartesianProvider,
  cartesianText,
  loadCartesianChunks,
} from '../../../src/renderer/ray/modules/cartesian-field.ts';
import { createGl, releaseGl } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { sampleOnGpu } from '../../helpers/sample-field.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions: Vector3 = [7, 5, 11];

/** Points all over the cube: inside, at voxel centres, on faces, edges and corners. */
function points(): Vector3[] {
  const random = randomNumbers(10);
  const inside = Array.from({ length: 300 }, (): Vector3 => [random(), random(), random()]);
  const centers = Array.from(
    { length: 60 },
    (): Vector3 => dimensions.map((n) => (Math.floor(random() * n) + 0.5) / n) as unknown as Vector3,
  );
  const faces = inside
    .slice(0, 60)
    .map((p, i) => p.map((x, axis) => (axis === i % 3 ? (i >> 2) % 2 : x)) as unknown as Vector3);
  const corners = Array.from({ length: 8 }, (_, c): Vector3 => [c & 1, (c >> 1) & 1, c >> 2]);
  return [...inside, ...centers, ...faces, ...corners].map((p) => p.map(Math.fround) as unknown as Vector3);
}

function withSamples(volume: Volume, change: (value: number, at: number) => number): Volume {
  const samples = volume.samples.map(change);
  return { ...volume, samples, hasNoData: samples.some(Number.isNaN) };
}

await loadCartesianChunks();

/** Stored values that the shader reads from a volume; NaN for no data. */
function sample(test: TestGl, volume: Volume, at: Vector3[], filterInShader: boolean): number[] {
  const { gl, device } = test;
  const field = finishUpload(
    cartesianProvider.upload(
      gl,
      volume,
      filterInShader ? { ...device, floatLinear: false, twoByteLinear: false } : device,
    ),
  );
  if (!filterInShader) return sampleOnGpu(test, volume, field, at);
  const text = cartesianText({
    texture3d: test.version === 2,
    twoBytes: volume.samples instanceof Uint16Array,
    noData: volume.hasNoData,
    filterInShader,
  });
  const { uniforms, units } = field.inputs();
  const nearest = units.map((unit) => ({ ...unit, minFilter: gl.NEAREST, magFilter: gl.NEAREST }));
  return sampleOnGpu(
    test,
    volume,
    { ...field, ...text, stage: 'field', inputs: () => ({ uniforms, units: nearest }) },
    at,
  );
}

function worst(got: number[], volume: Volume, at: Vector3[]): number {
  return Math.max(
    ...at.map((p, i) => {
      const expected = interpolate(volume.samples, volume.grid.dimensions, p);
      if (Number.isNaN(expected) || Number.isNaN(got[i]))
        return Number.isNaN(expected) === Number.isNaN(got[i]) ? 0 : Infinity;
      return Math.abs(got[i] - expected);
    }),
  );
}

for (const version of [1, 2] as const) {
  describe(`sampling a ${version === 1 ? 'mosaic in WebGL 1' : '3D texture in WebGL 2'}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    // Stored units. In the shader: float32 on coordinates of up to a hundred texels (1e-5 of a voxel) times the largest
    // difference of neighbours. By the device's filter: its weights have at least 8 bits, 1/512 of a difference an axis.
    for (const [kind, full, filtered] of [
      ['uint8', 255, 1.5],
      ['uint16', 65535, 400],
      ['float32', 1, 0.006],
    ] as const) {
      for (const filterInShader of [true, false]) {
        it(`${kind} ${filterInShader ? 'by eight fetches' : "by the device's filter"} is the twin's interpolation`, () => {
          const random = randomNumbers(11);
          const noise = () => random();
          const volume = syntheticVolume({ dimensions, kind, field: noise });
          const at = points();
          const got = worst(sample(test, volume, at, filterInShader), volume, at);
          expect(got).to.be.below(filterInShader ? full * 1e-5 : filtered);
        });
      }
    }

    it('reads nothing of other tiles: dark slices between bright ones stay dark, to the rim', () => {
      // Every slice but one holds the largest value; around and on that one, within its slice's centre plane, all is 0.
      for (const kind of ['uint8', 'uint16', 'float32'] as const) {
        for (const dark of [0, 1, 4, 5, 10]) {
          const volume = syntheticVolume({
            dimensions,
            kind,
            field: (_x, _y, z) => (Math.floor(z * 11) === dark ? 0 : 1),
          });
          const z = Math.fround((dark + 0.5) / 11);
          const at = points().map(([x, y]): Vector3 => [x, y, z]);
          for (const filterInShader of [true, false]) {
            const got =
              Math.max(...sample(test, volume, at, filterInShader)) / { uint8: 255, uint16: 65535, float32: 1 }[kind];
            // A z that float32 rounds: 1e-6 of a slice.
            expect(got, `${kind}, slice ${dark}`).to.be.below(1e-5);
          }
        }
      }
    });

    it('keeps extreme floats: neighbours of 1e30 leave the others alone', () => {
      const volume = withSamples(syntheticVolume({ dimensions, kind: 'float32' }), (value, i) =>
        i % 7 === 0 ? 1e30 : value,
      );
      const at = points().filter(([x]) => x * 7 > 1.5 && x * 7 < 6.49);
      expect(at.length).to.be.above(100);
      expect(worst(sample(test, volume, at, true), volume, at)).to.be.below(1e-4);
    });

    it('leaves out voxels without data as the twin does', () => {
      const random = randomNumbers(12);
      const volume = withSamples(syntheticVolume({ dimensions, kind: 'float32' }), (value) =>
        random() < 0.3 ? NaN : value,
      );
      // Where the valid weights come within rounding of the half, either answer is right.
      const weights = withSamples(volume, (value) => (Number.isNaN(value) ? 0 : 1));
      const at = points().filter((p) => Math.abs(interpolate(weights.samples, dimensions, p) - 0.5) > 1e-5);
      const expected = at.map((p) => interpolate(volume.samples, dimensions, p));
      expect(expected.filter(Number.isNaN).length).to.be.above(50);
      expect(expected.filter((x) => !Number.isNaN(x)).length).to.be.above(150);
      expect(worst(sample(test, volume, at, true), volume, at)).to.be.below(1e-5);
    });

    it('holds the layout for one slice, one row and one voxel', () => {
      for (const few of [
        [9, 4, 1],
        [1, 6, 5],
        [4, 1, 3],
        [1, 1, 1],
      ] as Vector3[]) {
        const volume = syntheticVolume({ dimensions: few, kind: 'uint8' });
        for (const filterInShader of [true, false]) {
          expect(worst(sample(test, volume, points(), filterInShader), volume, points()), few.join('x')).to.be.below(
            0.75,
          );
        }
      }
    });
  });
}
