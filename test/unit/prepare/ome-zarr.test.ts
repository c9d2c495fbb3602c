// OME-Zarr that volume-view-prepare writes, read by our own reader.
import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import type { DecodedCartesianVolume } from '../../../src/formats/base/decoded-volume.ts';
import { residualsGroup, makeOmeZarr } from '../../../src/prepare/write-ome-zarr.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import { invertAffine, transformPoint } from '../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { errorOf } from '../../helpers/error-of.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { memoryTree, readStore } from '../../helpers/zarr-tree.ts';

const pack = (bytes: Uint8Array): Uint8Array => gzipSync(bytes, { level: 1, mtime: 0 });

function storeOf(volume: Volume): Map<string, Uint8Array<ArrayBuffer>> {
  return new Map(
    [...makeOmeZarr(volume, pack).files].map(([path, content]) => [
      path,
      new Uint8Array(typeof content === 'string' ? new TextEncoder().encode(content) : content),
    ]),
  );
}

const valuesOf = ({ samples, slope, intercept }: Pick<DecodedCartesianVolume, 'samples' | 'slope' | 'intercept'>) =>
  Array.from(samples, (sample) => slope * sample + intercept);

/** Neither 32 nor 256 divide these. */
const dimensions: Vector3 = [70, 41, 33];

/** Axes along those of the world, of a patient, to the right, the back and the head. */
const placed: Matrix4 = [0.7, 0, 0, -20.5, 0, -1.1, 0, 30.25, 0, 0, 2.5, 4, 0, 0, 0, 1];

const patient = (volume: Volume): Volume => ({
  ...volume,
  anatomical: true,
  grid: cartesianGrid(dimensions, placed),
});

describe('OME-Zarr that is written', () => {
  const kinds: Record<string, [Volume, string]> = {
    'whole numbers of 8 bits': [syntheticVolume({ dimensions, slope: 255 }), 'uint8'],
    'whole numbers of 16 bits': [syntheticVolume({ dimensions, kind: 'uint16', slope: 65535 }), 'uint16'],
    'numbers below 0': [
      { ...syntheticVolume({ dimensions, kind: 'uint8', slope: 255, intercept: -1000 }), unit: 'HU' },
      'int16',
    ],
    'floats, with voxels that have no data': [
      syntheticVolume({
        dimensions,
        kind: 'float32',
        field: (x, y, z) => (x < 0.3 ? NaN : x + y * z),
      }),
      'float32',
    ],
    'whole numbers beyond 32 bits': [
      syntheticVolume({ dimensions, kind: 'uint8', slope: 255, intercept: 3e9 }),
      'float32',
    ],
    'numbers with a factor': [syntheticVolume({ dimensions, slope: 5, intercept: 0.25 }), 'float32'],
  };
  for (const [name, [volume, type]] of Object.entries(kinds))
    it(`has the values and the places of the volume: ${name}`, async () => {
      const files = storeOf(patient(volume));
      const read = await readStore(memoryTree(files));
      expect(read.format).to.equal('OME-Zarr 0.5');
      expect(read.anatomical).to.equal(true);
      expect(read.grid.dimensions).to.deep.equal(dimensions);
      for (const [n, number] of read.grid.indexToWorld.entries()) expect(number).to.be.closeTo(placed[n], 1e-12);
      const [before, after] = [valuesOf(volume), valuesOf(read)];
      // Numbers with a factor become floats of 32 bits.
      for (const [n, value] of before.entries())
        if (!(Math.abs(after[n] - value) <= 1e-7 * Math.abs(value))) expect([n, after[n]]).to.deep.equal([n, value]);
      const off = before.map((value, n) => Math.abs(after[n] - value)).filter((one) => one >= 0);
      const { error } = makeOmeZarr(patient(volume), pack);
      expect(error.max, 'what is said of it').to.equal(Math.max(...off));
      expect(error.rms).to.be.closeTo(Math.hypot(...off) / Math.sqrt(off.length), 1e-12 + 1e-9 * error.max);
      const metadata = JSON.parse(new TextDecoder().decode(files.get('0/zarr.json')));
      expect(metadata.data_type).to.equal(type);
    });

  it('has its voxels where they are at each level: a ramp keeps its values', async () => {
    const places: Matrix4 = [-2, 0, 0, 7, 0, -2, 0, 5, 0, 0, 2, -9, 0, 0, 0, 1];
    const volume = {
      ...syntheticVolume({ dimensions: [96, 80, 72], kind: 'float32', field: (x, y, z) => 96 * x + 800 * y - 72 * z }),
      grid: cartesianGrid([96, 80, 72], places),
    };
    const tree = memoryTree(storeOf(volume));
    const whole = await readStore(tree);
    // A device that holds fewer voxels along an axis reads a coarser level.
    for (const level of [1, 2]) {
      const limits = { maxVoxelsPerAxis: 96 / 2 ** level, maxAtlasSize: null, maxBytes: 2 ** 30 };
      const { grid, samples } = await readStore(tree, {}, { limits });
      expect(grid.dimensions).to.deep.equal([96, 80, 72].map((n) => n / 2 ** level));
      const m = grid.indexToWorld;
      for (const [i, j, k] of [
        [1, 2, 3],
        [9, 8, 7],
      ]) {
        const world = [m[0] * i + m[3], m[5] * j + m[7], m[10] * k + m[11]];
        const [x, y, z] = world.map((w, axis) => (w - places[4 * axis + 3]) / places[5 * axis]);
        const own = samples[i + grid.dimensions[0] * (j + grid.dimensions[1] * k)];
        expect(own).to.be.closeTo(x + 0.5 + 10 * (y + 0.5) - (z + 0.5), 1e-3, `level ${level}`);
      }
    }
    expect(whole.grid.dimensions).to.deep.equal([96, 80, 72]);
  });

  it('has its axes in the order of the world: slices of a sagittal series lie along x', async () => {
    const small: Vector3 = [5, 6, 7];
    // i runs to the back, j to the feet, k to the right.
    const grid = cartesianGrid(small, [0, 0, 3, -8, -2, 0, 0, 5, 0, -1.5, 0, 9, 0, 0, 0, 1]);
    const volume = { ...syntheticVolume({ dimensions: small, slope: 255 }), anatomical: true as const, grid };
    const read = await readStore(memoryTree(storeOf(volume)));
    expect(read.grid.dimensions).to.deep.equal([7, 5, 6]);
    const toIndex = invertAffine(read.grid.indexToWorld)!;
    const [before, after] = [valuesOf(volume), valuesOf(read)];
    for (let n = 0; n < before.length; n++) {
      const place = transformPoint(grid.indexToWorld, [n % 5, Math.floor(n / 5) % 6, Math.floor(n / 30)]);
      const [i, j, k] = transformPoint(toIndex, place).map(Math.round);
      expect(after[i + 7 * (j + 5 * k)]).to.equal(before[n]);
    }
  });

  it('leaves out chunks that are empty, and reads them as 0', async () => {
    const volume = syntheticVolume({ dimensions: [96, 32, 32], slope: 255, field: (x) => (x > 0.9 ? 1 : 0) });
    const files = storeOf(volume);
    // Level 0 is one shard of three chunks, of which one is there.
    const metadata = JSON.parse(new TextDecoder().decode(files.get('0/zarr.json')));
    expect(metadata.chunk_grid.configuration.chunk_shape).to.deep.equal([32, 32, 96]);
    const index = new DataView(files.get('0/c/0/0/0')!.buffer, files.get('0/c/0/0/0')!.length - 52);
    expect([0, 16, 32].map((at) => index.getBigUint64(at, true) === 2n ** 64n - 1n)).to.deep.equal([true, true, false]);
    expect(valuesOf(await readStore(memoryTree(files)))).to.deep.equal(valuesOf(volume));
  });

  it('says what each level hides', async () => {
    const volume = syntheticVolume({
      dimensions: [96, 64, 64],
      slope: 255,
      intercept: -100,
      field: (x, y, z) => (Math.hypot(x - 0.9, y - 0.2, z - 0.3) < 0.05 ? 1 : 0.2),
    });
    const files = storeOf(volume);
    const metadata = JSON.parse(new TextDecoder().decode(files.get(`${residualsGroup}/zarr.json`)));
    const { along, ...attributes } = metadata.attributes['volume-view'];
    expect(attributes).to.deep.equal({ version: 1, block: [16, 16, 16], levels: 3 });
    // Each level: the ball's rim goes on over several voxels of the finest one, and not over those of the next one.
    expect(along).to.have.lengthOf(3);
    expect(along[1]).to.be.within(0.5, 0.9);
    expect([along[0], along[2]]).to.deep.equal([0, 0]);
    const numbers = async (name: string): Promise<number[]> => {
      const own = new Map(
        [...files]
          .filter(([path]) => path.startsWith(`${residualsGroup}/${name}/`))
          .map(([path, bytes]) => [path.slice(`${residualsGroup}/${name}/`.length), bytes]),
      );
      return [...(await readStore(memoryTree(own))).samples];
    };
    // 6 x 4 x 4 blocks, x fastest; most of the ball is in the last one of the first row of the second layer.
    const ball = 5 + 6 * 4;
    expect(await numbers('min')).to.deep.equal(Array(96).fill(-49));
    const max = await numbers('max');
    expect(max[ball]).to.equal(155);
    expect(max[0]).to.equal(-49);
    const hidden = await numbers('residual-max-2');
    expect(hidden[ball]).to.be.within(40, 204);
    expect(hidden[0]).to.equal(0);
    expect((await numbers('residual-rms-2'))[ball]).to.be.within(2, hidden[ball] / 2);
  });

  // Numbers of NumPy 2.4.6 (means, half rounded up) and SciPy 1.17.1 (map_coordinates, order 1) for the same formula.
  it('has the means, and says the residuals, that NumPy and SciPy compute', async () => {
    const [nx, ny, nz] = dimensions;
    const volume = syntheticVolume({
      dimensions,
      slope: 255,
      field: (x, y, z) => {
        const [i, j, k] = [x * nx, y * ny, z * nz].map(Math.floor);
        return ((i * i * 7 + j * 13 + k * k * 29) % 251) / 255;
      },
    });
    const files = storeOf(volume);
    const arrayOf = async (name: string) => {
      const inside = [...files].filter(([path]) => path.startsWith(`${name}/`));
      return readStore(memoryTree(new Map(inside.map(([path, bytes]) => [path.slice(name.length + 1), bytes]))));
    };
    const expected = [
      { sum: 11834817 },
      { sum: 1563439, size: [35, 21, 17], one: 113, last: 63, max: [165.625, 129.89062], rms: [67.23909, 64.8137] },
      { sum: 223188, size: [18, 11, 9], one: 132, last: 63, max: [153.75, 130.87305], rms: [71.70525, 70.68782] },
    ];
    for (const [level, { sum, size, one, last, max, rms }] of expected.entries()) {
      const read = await arrayOf(String(level));
      const values = valuesOf(read);
      expect(values.reduce((a, b) => a + b)).to.equal(sum);
      if (!size) continue;
      expect(read.grid.dimensions).to.deep.equal(size);
      expect(values[1 + size[0] * (2 + size[1] * 3)]).to.equal(one);
      expect(values.at(-1)).to.equal(last);
      // Of the first and the last block; they are written with four binary digits after the first one.
      for (const [name, numbers] of Object.entries({ max, rms })) {
        const found = valuesOf(await arrayOf(`${residualsGroup}/residual-${name}-${level}`));
        expect(found).to.have.length(5 * 3 * 3);
        const [least, most] = name === 'max' ? [0, 1 / 16] : [-1 / 32, 1 / 32];
        for (const [n, number] of [found[0], found[44]].entries())
          expect(number / numbers[n] - 1).to.be.within(least - 1e-6, most + 1e-6);
      }
    }
  });

  it('has the window of the volume', async () => {
    const volume = { ...syntheticVolume({ dimensions: [33, 8, 8], slope: 255 }), window: [20, 180] as const };
    expect((await readStore(memoryTree(storeOf(volume)))).window).to.deep.equal([20, 180]);
  });

  it('is refused where it could not say what the volume is', () => {
    const plain = syntheticVolume({ dimensions: [8, 8, 8] });
    const turned = cartesianGrid([8, 8, 8], [1, 0.1, 0, 0, -0.1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    const mirrored = cartesianGrid([8, 8, 8], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    for (const [volume, words] of [
      [{ ...plain, anatomical: true, grid: turned } as Volume, 'turned or mirrored'],
      [{ ...plain, grid: mirrored }, 'turned or mirrored'],
      [{ ...plain, isDiscrete: true }, 'labels'],
    ] as const) {
      const error = errorOf(() => storeOf(volume));
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.include(words);
    }
  });
});
