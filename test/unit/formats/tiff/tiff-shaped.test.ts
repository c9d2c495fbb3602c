// Shapes that tifffile writes: {"shape": [3, 5, 6, 7], "axes": "TZYX"}
import { expect } from '@esm-bundle/chai';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import { grayPage, tiffBytes } from '../../../helpers/tiff-bytes.ts';
import type { TiffEntry, TiffPageBytes } from '../../../helpers/tiff-bytes.ts';

type Entries = Readonly<Record<number, TiffEntry>>;

/** Pages of 3 x 2 numbers: all of each are its index. */
const pages = (count: number, description: unknown, more: Entries = {}): TiffPageBytes[] => {
  const text = typeof description === 'string' ? description : JSON.stringify(description);
  const first: Entries = { 270: [2, text] };
  return Array.from({ length: count }, (_, i) =>
    grayPage(3, 2, new Uint8Array(6 * (more[277] ? 3 : 1)).fill(i), { ...(i === 0 ? first : {}), ...more }),
  );
};
const file = (...of: Parameters<typeof pages>): Uint8Array<ArrayBuffer> => tiffBytes(pages(...of));

/** The pages of the slices of each scan, and what is left. */
async function read(bytes: Uint8Array<ArrayBuffer>): Promise<{ scans: number[][]; left: readonly string[] }> {
  const { first, times, read: readOne } = await openScans(bytes, 'x.tif', { scan: { index: 0 } });
  const scans: number[][] = [];
  for (let i = 0; i < Math.max(1, times.length); i++) {
    const volume = i === 0 ? first : await readOne(i);
    scans.push(valuesOf(volume).filter((_, at) => at % 6 === 0));
  }
  return { scans, left: first.left ?? [] };
}

const stacked = (count: number): number[][] => [Array.from({ length: count }, (_, i) => i)];

describe('a TIFF file with the shape of an array', () => {
  // tifffile 2026.3.3 gives series[0].axes as they stand in "axes"; without them, napari shows the first of four as time.
  for (const [description, count, scans, left] of [
    [
      { shape: [2, 3, 2, 3], axes: 'TZYX' },
      6,
      [
        [0, 1, 2],
        [3, 4, 5],
      ],
      [],
    ],
    [
      { shape: [2, 3, 2, 3] },
      6,
      [
        [0, 1, 2],
        [3, 4, 5],
      ],
      [],
    ],
    [
      { shape: [3, 2, 2, 3], axes: 'ZTYX' },
      6,
      [
        [0, 2, 4],
        [1, 3, 5],
      ],
      [],
    ],
    [{ shape: [2, 3, 2, 3], axes: 'CZYX' }, 6, [[0, 1, 2]], ['channel 2 of the file']],
    [{ shape: [3, 3, 2, 3], axes: 'ZCYX' }, 9, [[0, 3, 6]], ['channels 2 to 3 of the file']],
    [
      { shape: [2, 2, 2, 2, 3] },
      8,
      [
        [0, 1],
        [4, 5],
      ],
      ['channel 2 of the file'],
    ],
    [{ shape: [4, 2, 3] }, 4, stacked(4), []],
    [{ shape: [4, 2, 3], axes: 'TYX' }, 4, [[0], [1], [2], [3]], []],
    [
      { shape: [2, 1, 3, 2, 3, 1], axes: 'TCZYXS' },
      6,
      [
        [0, 1, 2],
        [3, 4, 5],
      ],
      [],
    ],
  ] as const)
    it(`${JSON.stringify(description)} has its scans and slices`, async () => {
      expect(await read(file(count, description))).to.deep.equal({ scans, left });
    });

  it('may have numbers that JSON has not, as tifffile 2026.3.3 writes metadata={"axes": "TZYX", "mean": nan}', async () => {
    const text = '{"shape": [2, 3, 2, 3], "axes": "TZYX", "mean": NaN, "range": [-Infinity, Infinity]}';
    expect((await read(file(6, text))).scans).to.deep.equal([
      [0, 1, 2],
      [3, 4, 5],
    ]);
  });

  it('has colours as its last axis, or before those of the page', async () => {
    const colors = { 258: [3, 8, 8, 8], 262: [3, 2], 277: [3, 3] } as const;
    const contiguous = file(4, { shape: [2, 2, 2, 3, 3], axes: 'TZYXS' }, colors);
    expect((await read(contiguous)).scans).to.deep.equal([
      [0, 1],
      [2, 3],
    ]);
  });

  it('may have one directory for all pages', async () => {
    const numbers = Uint8Array.from({ length: 36 }, (_, i) => Math.floor(i / 6));
    const text = JSON.stringify({ shape: [2, 3, 2, 3], truncated: true });
    const bytes = tiffBytes([grayPage(3, 2, numbers, { 270: [2, text], 279: [4, 6] })]);
    expect((await read(bytes)).scans).to.deep.equal([
      [0, 1, 2],
      [3, 4, 5],
    ]);
  });

  it('with all pages in one directory is refused where they are not there', async () => {
    const text = JSON.stringify({ shape: [2 ** 20, 2, 3], truncated: true });
    const error = await expectError(decodeBytes(tiffBytes([grayPage(3, 2, undefined, { 270: [2, text] })]), 'x.tif'));
    expect(error.code).to.be.oneOf(['format/corrupt', 'format/too-large']);
  });

  for (const [what, description] of [
    ['is not that of its pages', { shape: [2, 2, 2, 3] }],
    ['has other rows', { shape: [2, 3, 3, 2] }],
    ['is that of the first page', { shape: [2, 3] }],
    ['has axes that are not known', { shape: [2, 3, 2, 3], axes: 'RZYX' }],
    ['has an axis twice', { shape: [2, 3, 2, 3], axes: 'TTYX' }],
    ['has no numbers', { shape: ['a', {}] }],
    ['is none', { shape: 6 }],
    ['has no end', '{"shape": [2, 3, 2, 3]'],
    ['is too long', { shape: [2, 3, 2, 3], more: 'x'.repeat(2 ** 16) }],
    ['is beyond all sizes', { shape: [2 ** 40, 2 ** 40, 2, 3] }],
  ] as const)
    it(`is a stack of its pages where the shape ${what}`, async () => {
      expect(await read(file(6, description))).to.deep.equal({ scans: stacked(6), left: [] });
    });

  it('has lengths as ImageJ has them, where it names a distance or a unit', async () => {
    const resolution: Entries = { 282: [5, 20_000, 1], 283: [5, 20_000, 1], 296: [3, 3] };
    const lengths = async (more: object): Promise<number[]> => {
      const { indexToWorld: m } = (await decodeBytes(file(2, { shape: [2, 2, 3], ...more }, resolution), 'x.tif')).grid;
      return [0, 1, 2].map((i) => Number(Math.hypot(m[i], m[i + 4], m[i + 8]).toPrecision(9)));
    };
    expect(await lengths({ spacing: 2, unit: 'um' })).to.deep.equal([5e-4, 5e-4, 2e-3]);
    expect(await lengths({})).to.deep.equal([1, 1, 1]);
  });
});
