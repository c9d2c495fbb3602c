import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { Budget } from '../../../../src/formats/base/budget.ts';
import type { ScanData, ScanNumbers } from '../../../../src/formats/base/scan-data.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { readPlaceOverTime } from '../../../../src/formats/series/read-place-over-time.ts';
import { placeDataOf, valuesOfPlace } from '../../../../src/viewer/picking/place-data.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { expectError, fetchFile, fixtureContext, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';

/**
 * Values of voxels of demos/data/functional.nii over its 20 times. Source: `nibabel.load(...).get_fdata()[i, j, k]` of nibabel 5.4.2,
 * to four decimals.
 */
const courses: readonly (readonly [Vector3, readonly number[]])[] = [
  [
    [9, 12, 2],
    [
      3545.3612, 3591.284, 3710.2762, 3638.7904, 3603.5, 3522.9653, 3536.1616, 3512.1821, 3642.5608, 3682.9035,
      3646.4065, 3661.7896, 3661.4879, 3594.602, 3493.9337, 3582.8385, 3477.5703, 3628.6105, 3673.1006, 3548.2267,
    ],
  ],
  [
    [0, 0, 0],
    [
      4004.1372, 4039.7293, 4020.1235, 3996.1441, 4043.4996, 3997.5768, 4042.8964, 3992.3737, 3993.6556, 3999.5374,
      3989.6591, 4027.815, 4056.8467, 4037.6179, 3972.0138, 4023.8184, 3976.7645, 3986.492, 3994.5605, 3971.109,
    ],
  ],
  [
    [16, 20, 2],
    [
      3142.8388, 3128.059, 3066.7532, 3060.419, 3114.1088, 3110.64, 3096.7651, 3032.8954, 3082.8149, 3083.7952,
      3002.5818, 3085.2279, 3130.1704, 3145.5535, 3076.4807, 3098.8765, 3108.8303, 3145.7043, 3087.5655, 3129.341,
    ],
  ],
  [
    [8, 10, 1],
    [
      3865.7654, 3880.2436, 3824.4424, 3832.0585, 3849.8545, 3897.3609, 3879.4141, 3918.1733, 3910.708, 3970.7319,
      3937.2512, 3901.5083, 3921.642, 3856.2641, 3962.965, 3882.732, 3911.1604, 3856.415, 3810.6429, 3910.8588,
    ],
  ],
];

const functional = await fetchFile('/demos/data/functional.nii');

/** Ranges of a file, and which ones were asked for. */
function serveRanges(file: Uint8Array<ArrayBuffer>) {
  const asked: (readonly [start: number, end: number])[] = [];
  const context = fixtureContext();
  const read: typeof context.fetchFile = async (url, range) => {
    if (range) asked.push([range.start, range.end]);
    return { bytes: file.slice(range?.start, range?.end), url, contentType: '' };
  };
  return { asked, read };
}

/** The values of a voxel, as the worker and the page read them. */
async function courseOf(
  scans: readonly ScanData[],
  voxel: Vector3,
  fetchParts = fixtureContext().fetchFile,
): Promise<number[]> {
  const data = scans as readonly ScanNumbers[];
  const place = structuredClone(placeDataOf(data, voxel)); // As a message brings it to the worker.
  const read = await readPlaceOverTime(place, { fetchFile: fetchParts, budget: new Budget() });
  return valuesOfPlace(await finishVolume(read, roomyLimits), data);
}

describe('the values of a voxel over time', () => {
  it('are those of nibabel, of a file that is kept, packed or not', async () => {
    for (const file of [functional.slice(), gzipSync(functional, { level: 1 })]) {
      const { data } = await openScans(file, 'functional.nii');
      for (const [voxel, expected] of courses)
        (await courseOf(data, voxel)).forEach((value, t) =>
          expect(value, `${voxel.join(' ')}, time ${t}`).to.be.closeTo(expected[t], 5e-5),
        );
    }
  });

  it('are to the bit those of each volume that is shown', async () => {
    const { data, read } = await openScans(functional.slice(), 'functional.nii');
    const volumes = await Promise.all(data.map((_, t) => read(t)));
    const voxel: Vector3 = [5, 7, 1];
    const at = 5 + 17 * (7 + 21 * 1);
    expect(await courseOf(data, voxel)).to.deep.equal(volumes.map((volume) => valuesOf(volume)[at]));
  });

  it('are fetched in ranges: near ones together, and nothing but these', async () => {
    const { asked, read } = serveRanges(functional);
    const { data } = await openScans(functional.slice(0, 400), 'functional.nii', {
      input: { missing: functional.length - 400 },
      fetchFile: read,
    });
    asked.length = 0;
    const values = await courseOf(data, courses[0][0], read);
    values.forEach((value, t) => expect(value).to.be.closeTo(courses[0][1][t], 5e-5));
    const first = 352 + 2 * (9 + 17 * (12 + 21 * 2));
    expect(asked).to.deep.equal([[first, first + 19 * 2142 + 2]]);
  });

  it('far apart are fetched one by one, a few at a time', async () => {
    const step = 2 ** 17;
    const bytes = new Uint8Array(9 * step);
    for (let t = 0; t < 9; t++) bytes[t * step + 3] = 10 + t;
    const data = Array.from({ length: 9 }, (_, t) => scanAt(t * step, t * step + 8));
    const { asked, read } = serveRanges(bytes);
    let [running, most] = [0, 0];
    const slow: typeof read = async (url, range) => {
      most = Math.max(most, ++running);
      await new Promise((resolve) => setTimeout(resolve, 5));
      running--;
      return read(url, range);
    };
    expect(await courseOf(data, [1, 1, 0], slow)).to.deep.equal(data.map((_, t) => 10 + t));
    expect(asked).to.have.length(9);
    expect(asked.every(([start, end]) => end - start === 1)).to.equal(true);
    expect(most).to.equal(6);
  });

  it('of volumes that are scaled one by one have the scale of their own', async () => {
    const data = [0, 1, 2].map((t) => ({
      ...scanAt(0, 8),
      from: new Blob([Uint8Array.from({ length: 8 }, (_, i) => i)]),
      slope: t + 1,
      intercept: -t,
    }));
    expect(await courseOf(data, [1, 1, 1])).to.deep.equal([7, 13, 19]);
  });

  it('have no data where numbers are none, and say what is wrong where the file has changed', async () => {
    const numbers = [1, NaN, 3, Infinity];
    const data = numbers.map((number) => ({
      ...scanAt(0, 32, 'float32'),
      from: new Blob([new Float32Array(8).fill(number)]),
    }));
    expect(await courseOf(data, [0, 0, 0])).to.deep.equal([1, NaN, 3, NaN]);
    const { read } = serveRanges(new Uint8Array(4));
    const error = await expectError(courseOf([scanAt(0, 8), scanAt(8, 16)], [1, 1, 1], read));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('it has changed since it was opened');
  });
});

/** A volume of 2 x 2 x 2 numbers in a file. */
function scanAt(start: number, end: number, type = 'uint8'): ScanData {
  return {
    from: { url: 'https://example.org/file', start, end },
    type,
    littleEndian: true,
    slope: 1,
    intercept: 0,
    format: 'test',
    series: {
      grid: {
        kind: 'cartesian',
        dimensions: [2, 2, 2],
        indexToWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        spacing: [1, 1, 1],
      },
      anatomical: false,
      unit: '',
      format: 'test',
    },
  };
}
