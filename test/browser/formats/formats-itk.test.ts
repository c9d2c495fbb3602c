import { expect } from '@esm-bundle/chai';
import { loadVolume } from '../../../src/worker/load.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { decodeBytes, fetchFixture, roomyLimits } from '../../helpers/decode.ts';
import { compareValues, readExpected } from '../../helpers/expected-file.ts';
import type { ExpectedFile } from '../../helpers/expected-file.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';

/** What SimpleITK (or pynrrd, where ITK refuses a file) says of a file; made by test/fixtures/make-itk-fixtures.py. Places are LPS. */
interface Expected extends ExpectedFile {
  reader: string;
  /** 2 for a flat image. */
  axes: number;
  spacing: number[];
  origin: number[];
  /** Row by row; a column is the direction of an axis. */
  direction: number[];
}

const fixtures = await readExpected<Expected>('itk-fixtures.json');
const shared = await readExpected<Expected>('itk-shared.json');

/** Voxel index to world, RAS: x and y of LPS turned round. */
function comparePlace({ grid: { indexToWorld, spacing } }: Volume, expected: Expected): void {
  const { axes, direction, origin } = expected;
  for (let row = 0; row < axes; row++) {
    const sign = row < 2 ? -1 : 1;
    for (let column = 0; column < axes; column++) {
      const step = sign * direction[row * axes + column] * expected.spacing[column];
      expect(indexToWorld[row * 4 + column], `step ${column}, component ${row}`).to.be.closeTo(
        step,
        1e-9 * expected.spacing[column],
      );
    }
    expect(indexToWorld[row * 4 + 3], `origin ${row}`).to.be.closeTo(
      sign * origin[row],
      1e-9 * Math.max(1, Math.abs(origin[row])),
    );
  }
  expected.spacing.forEach((length, axis) => expect(spacing[axis]).to.be.closeTo(length, 1e-9 * length));
}

function compare(volume: Volume, expected: Expected): void {
  comparePlace(volume, expected);
  compareValues(volume, expected);
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
    for (const [path, format] of [
      ['nrrd/list-first.nrrd', 'NRRD, volume 1 of 2'],
      ['nrrd/list-last.nrrd', 'NRRD, volume 1 of 2'],
      ['metaimage/series.mha', 'MetaImage, volume 1 of 2'],
    ]) {
      expect((await decodeBytes(await fetchFixture(path), path)).format).to.equal(format);
    }
  });

  it('keep 64-bit numbers apart that doubles do not distinguish', async () => {
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
      const volume = await loadVolume(
        { url: `/shared-data/${expected.path}`, limits: roomyLimits },
        { signal: new AbortController().signal, onProgress: () => undefined },
      );
      compare(volume, expected);
    });
  }
});
