// Several TIFF files as one volume: each has its own description. Source: ImageJ 1.54, FileOpener, setCalibration (cf, c0, c1, min and max)
import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../../../src/formats/decode.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { fetchInOrder } from '../../../../src/sources/fetch-files.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { expectError, fixtureContext, roomyLimits, urlOf, valuesOf } from '../../../helpers/decode.ts';
import { grayPage, tiffBytes } from '../../../helpers/tiff-bytes.ts';
import type { TiffEntry } from '../../../helpers/tiff-bytes.ts';

type Entries = Readonly<Record<number, TiffEntry>>;

/** One page of 2 x 1 numbers. */
const page = (numbers: readonly number[], lines: string | null, more: Entries = {}): Uint8Array<ArrayBuffer> =>
  tiffBytes([
    grayPage(2, 1, Uint8Array.from(numbers), lines === null ? more : { 270: [2, `ImageJ=1.54f\n${lines}`], ...more }),
  ]);

async function readStack(...files: Uint8Array<ArrayBuffer>[]): Promise<Volume> {
  const urls = files.map((_, i) => urlOf(`${i + 1}.tif`));
  const fetchFile = async (url: string) => ({ bytes: files[urls.indexOf(url)].slice(), url, contentType: '' });
  const fetchFiles = (list: readonly string[]) => fetchInOrder(list, fetchFile, () => undefined);
  const context = { ...fixtureContext(), fetchFile, fetchFiles, files: urls };
  return finishVolume(await decodeFile(await fetchFile(urls[0]), {}, context), roomyLimits);
}

describe('several TIFF files of ImageJ as one volume', () => {
  it('have the values of their own scales', async () => {
    const volume = await readStack(
      page([1, 2], 'cf=0\nc0=-1024\nc1=0.5\nvunit=HU'),
      page([1, 2], 'cf=0\nc0=10\nc1=0.5\nvunit=HU'),
      page([1, 2], 'cf=0\nc0=0.1\nc1=-3\nvunit=HU'),
    );
    expect(volume.unit).to.equal('HU');
    const expected = [-1023.5, -1023, 10.5, 11, 0.1 - 3, 0.1 - 6];
    for (const [i, value] of valuesOf(volume).entries()) expect(value).to.be.closeTo(expected[i], 1e-4);
  });

  it('of 16 bits with a sign, and without a scale, have theirs as well', async () => {
    const signed = { 258: [3, 16], 339: [3, 2] } as const;
    const volume = await readStack(
      page([0xfe, 0xff, 3, 0], 'cf=0\nc0=-32768\nc1=1', signed),
      page([0xfe, 0xff, 3, 0], null, signed),
      page([0xfe, 0xff, 3, 0], 'cf=0\nc0=-65536\nc1=2', signed),
    );
    expect(valuesOf(volume)).to.deep.equal([-2, 3, -2, 3, -4, 6]);
  });

  it('with one scale keep their numbers', async () => {
    const lines = 'cf=0\nc0=5\nc1=2';
    const volume = await readStack(page([1, 2], lines), page([3, 4], lines));
    expect(volume.samples).to.be.instanceOf(Uint8Array);
    expect(valuesOf(volume)).to.deep.equal([7, 9, 11, 13]);
  });

  it('have a window with those of all of them', async () => {
    const first = page([1, 2], 'min=3\nmax=9');
    expect((await readStack(first, page([3, 4], 'min=2\nmax=5'))).window).to.deep.equal([2, 9]);
    const scaled = await readStack(first, page([3, 4], 'min=2\nmax=5\ncf=0\nc0=10\nc1=2'));
    expect(scaled.window).to.deep.equal([3, 20]);
    // A file without one may have any values.
    expect((await readStack(first, page([3, 200], null))).window).not.to.deep.equal([3, 9]);
  });

  it('in other units are refused, with both', async () => {
    const files = [page([1, 2], 'cf=0\nc0=0\nc1=1\nvunit=HU'), page([1, 2], 'cf=0\nc0=0\nc1=1\nvunit=mGy')];
    const { code, message } = await expectError(readStack(...files));
    expect(code).to.equal('format/corrupt');
    expect(message).to.match(/got 2\.tif of 2 x 1 pixels of uint8 in mGy; expected 2 x 1 pixels of uint8 in HU/);
    expect((await expectError(readStack(files[0], page([1, 2], null)))).message).to.contain('of uint8; expected');
  });

  it('with voxels of other sizes have those of the first one, which is said', async () => {
    const sized = (pixels: number): Entries => ({ 282: [5, pixels, 1], 283: [5, pixels, 1], 296: [3, 1] });
    const lines = 'unit=mm\nspacing=2';
    const alike = await readStack(page([1, 2], lines, sized(2)), page([1, 2], lines, sized(2)));
    expect([alike.grid.spacing, alike.left]).to.deep.equal([[0.5, 0.5, 2], undefined]);
    const volume = await readStack(page([1, 2], lines, sized(2)), page([1, 2], lines, sized(4)));
    expect([volume.grid.spacing, volume.left]).to.deep.equal([
      [0.5, 0.5, 2],
      ['sizes of voxels of files that differ from those of the first one'],
    ]);
  });
});
