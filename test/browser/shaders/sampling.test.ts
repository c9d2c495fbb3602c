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
import { fetchEach } from '../../../src/renderer/ray/modules/columns.ts';
import type { FieldModule } from '../../../src/renderer/ray/ray-module.ts';
import { weighTexels } from '../../../src/renderer/ray/modules/weighed-texels.ts';
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

/** With the range of its samples, for slope 1 and intercept 0. */
function ranged(volume: Volume): Volume {
  const values = Array.from(volume.samples).filter((value) => !Number.isNaN(value));
  return { ...volume, range: [Math.min(...values), Math.max(...values)] };
}

const upload = ({ gl, device }: TestGl, volume: Volume): FieldModule =>
  finishUpload(cartesianProvider.upload(gl, volume, device));

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

    // Of the largest difference of neighbours: the filter's weights have at least 8 bits.
    for (const [name, low, span, whole] of [
      ['floats', -3, 7, false],
      ['whole numbers of 12 bits', -1024, 4095, true],
      ['whole numbers of 16 bits', -32768, 65535, true],
      ['whole numbers of 17 bits', 5, 131071, true],
    ] as const) {
      it(`leaves out voxels without data by the device's filter: ${name}`, () => {
        const random = randomNumbers(13);
        const number = (share: number): number => low + (whole ? Math.round(span * share) : Math.fround(span * share));
        const volume = ranged(
          withSamples(syntheticVolume({ dimensions, kind: 'float32' }), () =>
            random() < 0.3 ? NaN : number(random() < 0.1 ? Math.round(random()) : random()),
          ),
        );
        const field = upload(test, volume);
        expect(field.defines).to.include({ WEIGHED: 1, FILTER_IN_SHADER: 0 });
        const isPacked = test.version === 2 && whole && span < 65536;
        // A mosaic has a few texels more than there are voxels.
        expect(Math.floor(field.bytes / volume.samples.length)).to.equal(isPacked ? 4 : 8);
        // A filter of 8 bits may take either side of a half.
        const weights = withSamples(volume, (value) => (Number.isNaN(value) ? 0 : 1));
        const at = points().filter((p) => Math.abs(interpolate(weights.samples, dimensions, p) - 0.5) > 0.01);
        expect(at.length).to.be.above(300);
        expect(worst(sampleOnGpu(test, volume, field, at), volume, at) / span).to.be.below(0.012);
        // Where any transfer function has jumps, WebGL 1 fetches each voxel of the same texture.
        const [each = field] = fetchEach(test.gl, field);
        if (test.version === 1) expect(each).not.to.equal(field);
        const fetched = worst(sampleOnGpu(test, volume, each as typeof field, at), volume, at) / span;
        expect(fetched).to.be.below(test.version === 1 ? 1e-5 : 0.012);
        field.dispose();
      });
    }

    it('keeps a constant next to voxels without data, whatever its weights are', () => {
      for (const constant of [0, 1, 1234, -777, 0.1]) {
        const random = randomNumbers(14);
        const volume = ranged(
          withSamples(syntheticVolume({ dimensions, kind: 'float32' }), () => (random() < 0.3 ? NaN : constant)),
        );
        const got = sample(test, volume, points(), false).filter((value) => !Number.isNaN(value));
        expect(got.length).to.be.above(300);
        const off = Math.max(...got.map((value) => Math.abs(value - Math.fround(constant))));
        expect(off).to.be.at.most(3e-7 * Math.abs(constant));
      }
    });

    it('fetches each voxel where the device filters no floats, or where there are too many for pairs of floats', () => {
      const volume = withSamples(syntheticVolume({ dimensions, kind: 'float32' }), (value, i) =>
        i % 5 === 0 ? NaN : value,
      );
      const unfiltered = finishUpload(
        cartesianProvider.upload(test.gl, volume, { ...test.device, floatLinear: false, twoByteLinear: false }),
      );
      expect(unfiltered.defines).to.include({ FILTER_IN_SHADER: 1 });
      expect(unfiltered.defines).not.to.have.property('WEIGHED');
      expect(worst(sampleOnGpu(test, volume, unfiltered, points()), volume, points())).to.be.below(1e-5);
      unfiltered.dispose();
      const samples = { length: 2 ** 25 + 1, byteLength: 2 ** 27 + 4, 0: 0.5 };
      const many = { ...volume, samples: samples as unknown as Float32Array<ArrayBuffer> };
      expect(finishUpload(weighTexels(test.gl, many, test.device))).to.equal(null);
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
