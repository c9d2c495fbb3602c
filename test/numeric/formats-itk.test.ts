import { expect } from '@esm-bundle/chai';
import { loadVolume } from '../../src/formats/load.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { decodeBytes, fetchFixture, roomyLimits, valuesOf } from '../helpers/decode.ts';
import { fetchSharedData } from '../helpers/shared-data.ts';

/** What SimpleITK (or pynrrd, where ITK refuses a file) says of a file; made by test/fixtures/make-itk-fixtures.py. ContextPool are LPS. */
interface Expected {
  path: string;
  reader: string;
  dimensions: number[];
  /** 2 for a flat image. */
  axes: number;
  spacing: number[];
  origin: number[];
  /** Row by row; a column is the direction of an axis. */
  direction: number[];
  range: [number, number];
  sum: number;
  samples: [number, number | string][];
}

const readList = async (name: string): Promise<Expected[]> =>
  (JSON.parse(new TextDecoder().decode(await fetchFixture(name))) as { files: Expected[] }).files;
const fixtures = await readList('itk-fixtures.json');
const shared = await readList('itk-shared.json');

/** float32 keeps half a unit of 2^-24 of the largest stored magnitude; integers of up to 25 bits are exact. */
function toleranceOf(volume: Volume): number {
  const farthest = Array.from(volume.samples).reduce((most, sample) => Math.max(most, Math.abs(sample) || 0), 0);
  const stored = volume.samples instanceof Float32Array ? Math.abs(volume.slope) * farthest * 2 ** -24 : 0;
  return stored + 4 * Math.max(Math.abs(volume.range[0]), Math.abs(volume.range[1])) * Number.EPSILON;
}

/** Voxel index to world, RAS: x and y of LPS turned round. */
function comparePlace({ grid: { indexToWorld, spacing } }: Volume, expected: Expected): void {
  const { axes, direction, origin } = expected;
  for (let row = 0; row < axes; row++) {
    const sign = row < 2 ? -1 : 1;
    for (let column = 0; column < axes; column++) {
      const step = sign * direction[row * axes + column] * expected.spacing[column];
      expect(indexToWorld[row * 4 + column], `step ${column}, component ${row}`).to.be.closeTo(step, 1e-9 * expected.spacing[column]);
    }
    expect(indexToWorld[row * 4 + 3], `origin ${row}`).to.be.closeTo(sign * origin[row], 1e-9 * Math.max(1, Math.abs(origin[row])));
  }
  expected.spacing.forEach((length, axis) => expect(spacing[axis]).to.be.closeTo(length, 1e-9 * length));
}

function compare(volume: Volume, expected: Expected): void {
  expect(volume.grid.dimensions).to.deep.equal(expected.dimensions);
  comparePlace(volume, expected);
  const values = valuesOf(volume);
  const tolerance = toleranceOf(volume);
  for (const [i, value] of expected.samples) {
    expect(Math.abs(values[i] - Number(value)), `sample ${i}: ${values[i]} for ${value}`).to.be.at.most(tolerance);
  }
  expect(Math.abs(volume.range[0] - expected.range[0])).to.be.at.most(tolerance);
  expect(Math.abs(volume.range[1] - expected.range[1])).to.be.at.most(tolerance);
  const sum = values.reduce((total, value) => total + value, 0);
  expect(Math.abs(sum - expected.sum)).to.be.at.most(tolerance * values.length + 1e-9 * Math.abs(expected.sum));
}

describe('NRRD and MetaImage: values, spacing, directions and origin against SimpleITK', () => {
  for (const expected of fixtures) {
    it(`${expected.path} (${expected.reader})`, async () => {
      const volume = await decodeBytes(await fetchFixture(expected.path), expected.path);
      expect(volume.format).to.match(expected.path.startsWith('nrrd/') ? /^NRRD/ : /^MetaImage/);
      compare(volume, expected);
    });
  }

  it('say which volume of several they show', async () => {
    for (const [path, format] of [['nrrd/list-first.nrrd', 'NRRD, volume 1 of 2'], ['nrrd/list-last.nrrd', 'NRRD, volume 1 of 2'], ['metaimage/series.mha', 'MetaImage, volume 1 of 2']]) {
      expect((await decodeBytes(await fetchFixture(path), path)).format).to.equal(format);
    }
  });

  it('keep 64-bit numbers apart that doubles can not tell apart', async () => {
    for (const path of ['nrrd/i8-big.nrrd', 'metaimage/u8-little.mha']) {
      const { samples } = await decodeBytes(await fetchFixture(path), path);
      expect(Array.from(samples), path).to.deep.equal(Array.from({ length: 24 }, (_, i) => 7 * (23 - i)));
    }
  });
});

describe('NRRD and MetaImage files of the shared data, in the worker', () => {
  for (const expected of shared) {
    it(`${expected.path} (${expected.reader})`, async function () {
      await fetchSharedData(this, expected.path);
      const volume = await loadVolume({ url: `/shared-data/${expected.path}`, limits: roomyLimits }, { signal: new AbortController().signal, onProgress: () => undefined });
      compare(volume, expected);
    });
  }
});
