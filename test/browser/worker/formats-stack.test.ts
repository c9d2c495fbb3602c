import { isPolar } from '../../../src/volume/volume.ts';
import { expect } from '@esm-bundle/chai';
import { encode } from 'fast-png';
import { decodeFile } from '../../../src/formats/decode.ts';
import { fetchInOrder } from '../../../src/sources/fetch-files.ts';
import { finishVolume } from '../../../src/formats/finish-volume.ts';
import { loadVolume } from '../../../src/worker/load.ts';
import type { DecodeSettings } from '../../../src/formats/base/decoded-volume.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import {
  decodeBytes,
  decodeStack,
  expectError,
  fetchFixture,
  fixtureContext,
  roomyLimits,
  urlOf,
  valuesOf,
} from '../../helpers/decode.ts';

const signal = new AbortController().signal;
const ignore = (): void => undefined;

/** A gray image whose pixels count up from a number. */
function makeImage(
  from: number,
  { width = 3, height = 2, depth = 8 }: { width?: number; height?: number; depth?: 8 | 16 } = {},
): Uint8Array<ArrayBuffer> {
  const values = Array.from({ length: width * height }, (_, i) => from + i);
  const data = depth === 8 ? Uint8Array.from(values) : Uint16Array.from(values);
  return new Uint8Array(encode({ width, height, data, channels: 1, depth }));
}

/** Decode files that lie in memory, by their names, as one volume. */
async function decodeFiles(
  files: Readonly<Record<string, Uint8Array<ArrayBuffer>>>,
  settings: DecodeSettings = {},
): Promise<Volume> {
  const names = Object.keys(files);
  const fetchFile = async (url: string) => ({
    bytes: files[url.slice(urlOf('').length)].slice(),
    url,
    contentType: '',
  });
  const context = {
    onProgress: ignore,
    fetchFile,
    fetchFiles: (urls: readonly string[]) => fetchInOrder(urls, fetchFile, ignore),
    files: names.map(urlOf),
  };
  return finishVolume(await decodeFile(await fetchFile(urlOf(names[0])), settings, context), roomyLimits);
}

const three = { 'a.png': makeImage(0), 'b.png': makeImage(10), 'c.png': makeImage(20) };
const threeValues = [0, 10, 20].flatMap((from) => [0, 1, 2, 3, 4, 5].map((i) => from + i));

describe('a stack of images', () => {
  it('is one volume, a slice an image, in the order that is given', async () => {
    const volume = await decodeFiles(three, { spacing: [0.5, 2, 3] });
    expect(volume.grid.dimensions).to.deep.equal([3, 2, 3]);
    expect(valuesOf(volume)).to.deep.equal(threeValues);
    expect(volume.grid.spacing).to.deep.equal([0.5, 2, 3]);
    expect(volume.format).to.equal('PNG stack');
    const backwards = await decodeFiles({ 'c.png': three['c.png'], 'b.png': three['b.png'], 'a.png': three['a.png'] });
    expect(backwards.samples[0]).to.equal(20);
  });

  it('lies as a mosaic of the same slices', async () => {
    const stack = await decodeFiles(three, { spacing: [0.5, 2, 3] });
    const tall = new Uint8Array(
      encode({ width: 3, height: 6, data: Uint8Array.from(threeValues), channels: 1, depth: 8 }),
    );
    const mosaic = await decodeBytes(tall, 'tall.png', { spacing: [0.5, 2, 3], mosaic: { columns: 1, rows: 3 } });
    expect(stack.grid.indexToWorld).to.deep.equal(mosaic.grid.indexToWorld);
    expect(stack.samples).to.deep.equal(mosaic.samples);
  });

  it('keeps 16 bits, and may be one image, which is one slice', async () => {
    const volume = await decodeFiles({ 'a.png': makeImage(60_000, { depth: 16 }) });
    expect(volume.grid.dimensions).to.deep.equal([3, 2, 1]);
    expect(valuesOf(volume)).to.deep.equal([60_000, 60_001, 60_002, 60_003, 60_004, 60_005]);
  });

  it('of other sizes, depths or formats is refused, and the file is named', async () => {
    for (const [other, words] of [
      [makeImage(0, { width: 4 }), '4 x 2'],
      [makeImage(0, { depth: 16 }), '16 bits'],
    ] as const) {
      const error = await expectError(decodeFiles({ ...three, 'd.png': other }));
      expect(error.code).to.equal('format/corrupt');
      expect(error.message).to.contain('d.png').and.to.contain(words);
    }
    const mixed = await expectError(decodeFiles({ ...three, 'd.nii': await fetchFixture('nifti/one-slice.nii') }));
    expect(mixed.code).to.equal('format/unsupported');
    expect(mixed.message).to.contain('d.nii').and.to.contain('NIfTI');
  });

  it('with a mosaic layout is refused', async () => {
    expect((await expectError(decodeFiles(three, { mosaic: { columns: 3, rows: 1 } }))).code).to.equal('mosaic/layout');
  });

  it("is a radar's where elevations are given, a sweep an image", async () => {
    const sweep = makeImage(1, { width: 40, height: 36 });
    const volume = await decodeFiles({ 'a.png': sweep, 'b.png': sweep }, { elevations: [0.5, 1.5], range: [250, 500] });
    expect(isPolar(volume) && volume.grid.sweeps).to.have.length(2);
    expect(volume.format).to.equal('PNG stack');
  });

  it('of too many files, or of more voxels than can be held, is refused before they are fetched', async () => {
    let fetched = 0;
    const first = makeImage(0, { width: 2000, height: 2000 });
    const count = (url: string) => (fetched++, fixtureContext().fetchFile(url));
    const refuse = (files: string[]) =>
      expectError(
        decodeFile(
          { bytes: first.slice(), url: urlOf('a.png'), contentType: '' },
          {},
          { onProgress: ignore, fetchFile: count, fetchFiles: (urls) => fetchInOrder(urls, count, ignore), files },
        ),
      );
    expect((await refuse(Array.from({ length: 8193 }, () => urlOf('a.png')))).code).to.equal('format/too-large');
    const large = await refuse(Array.from({ length: 1000 }, () => urlOf('a.png')));
    expect(large.code).to.equal('format/too-large');
    expect(large.message).to.contain('2000 x 2000 x 1000');
    expect(fetched).to.equal(0);
  });
});

describe('a stack of a header and its data', () => {
  const expected = async (path: string) => valuesOf(await decodeBytes(await fetchFixture(path), path));

  for (const [header, ...data] of [
    ['nrrd/detached.nhdr', 'metaimage/data.raw'],
    ['nrrd/detached-gzip.nhdr', 'metaimage/data.zraw'],
    ['metaimage/detached-zlib.mhd', 'nrrd/data.raw.gz'],
    ['metaimage/detached-list.mhd', ...[1, 2, 3, 4].map((part) => `nrrd/slice_0${part}%23.raw`)],
  ]) {
    it(`takes ${data.join(', ')} for ${header}, whatever it calls them`, async () => {
      expect(valuesOf(await decodeStack([header, ...data]))).to.deep.equal(await expected(header));
    });
  }

  it('of fewer or more files than the header names is refused', async () => {
    for (const names of [
      ['nrrd/detached-list.nhdr', 'nrrd/data.raw'],
      ['metaimage/detached.mhd', 'nrrd/data.raw', 'nrrd/data.raw'],
    ]) {
      const error = await expectError(decodeStack(names));
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.contain('names');
    }
    expect((await expectError(decodeStack(['nrrd/gzip.nrrd', 'nrrd/data.raw']))).message).to.contain('own file');
  });

  it('of volumes that are whole by themselves is refused', async () => {
    const error = await expectError(decodeStack(['nifti/one-slice.nii', 'nifti/one-slice.nii']));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('leave out stack');
  });
});

describe('a manifest with files', () => {
  const encodeText = (value: unknown) => new TextEncoder().encode(JSON.stringify(value));

  it('is one volume, described by the manifest', async () => {
    const manifest = { files: ['metaimage/detached.mhd', 'metaimage/data.raw'], slope: 2, unit: 'HU', title: 'T' };
    const volume = await decodeBytes(encodeText(manifest), 'a.json');
    expect(volume).to.deep.include({ unit: 'HU', title: 'T', format: 'MetaImage' });
    expect(valuesOf(volume).slice(0, 3)).to.deep.equal([-200, -178, -156]);
    const images = await decodeBytes(
      encodeText({ files: ['mosaic/gray-3x2.png', 'mosaic/gray-3x2.png'], spacing: [1, 1, 4] }),
      'a.json',
    );
    expect(images.grid.dimensions).to.deep.equal([12, 8, 2]);
    expect(images.grid.spacing).to.deep.equal([1, 1, 4]);
  });

  it('of scans each has its own', async () => {
    const scans = [{ image: 'mosaic/gray-3x2.png', mosaic: '3x2' }, { files: ['mosaic/gray-3x2.png'] }];
    expect((await decodeBytes(encodeText({ scans }), 'a.json', { scan: { index: 1 } })).format).to.equal('PNG stack');
  });

  it('that names a manifest, or no URL, is refused', async () => {
    for (const files of [['itk-shared.json'], ['mosaic/gray-3x2.png', 'http://']]) {
      expect((await expectError(decodeBytes(encodeText({ files }), 'a.json'))).code).to.equal('manifest/invalid');
    }
  });
});

describe('loadVolume of a stack', () => {
  it('fetches the files in the worker, by URLs that are relative to the page', async () => {
    const url = '/test/fixtures/mosaic/gray-3x2.png';
    const volume = await loadVolume(
      { url, files: [url, url, url], limits: roomyLimits },
      { signal, onProgress: ignore },
    );
    expect(volume.grid.dimensions).to.deep.equal([12, 8, 3]);
  });

  it('finds the data next to a header', async () => {
    const volume = await loadVolume(
      { url: '/test/fixtures/nrrd/detached-list.nhdr', limits: roomyLimits },
      { signal, onProgress: ignore },
    );
    expect(valuesOf(volume)).to.deep.equal(Array.from({ length: 24 }, (_, i) => 11 * i - 100));
  });

  it('says which file is missing', async () => {
    const url = '/test/fixtures/mosaic/gray-3x2.png';
    const error = await expectError(
      loadVolume(
        { url, files: [url, '/test/fixtures/missing-slice.png'], limits: roomyLimits },
        { signal, onProgress: ignore },
      ),
    );
    expect(error.code).to.equal('source/not-found');
    expect(error.message).to.contain('missing-slice.png');
  });
});

describe('files that are fetched in order', () => {
  it('are at most six at a time, and in their order whichever comes first', async () => {
    let [running, max] = [0, 0];
    const fetchOne = async (url: string) => {
      max = Math.max(max, ++running);
      await new Promise((resolve) => setTimeout(resolve, (7 * Number(url)) % 5));
      running--;
      return { bytes: new Uint8Array(1), url, contentType: '' };
    };
    const urls = Array.from({ length: 20 }, (_, i) => String(i));
    const got: string[] = [];
    for await (const { url } of fetchInOrder(urls, fetchOne, ignore)) got.push(url);
    expect(got).to.deep.equal(urls);
    expect(max).to.equal(6);
  });

  it('report the bytes of all that have come, and of one alone its total', async () => {
    const fetchOne = async (url: string, onProgress: (loaded: number, total: number) => void) => {
      for (const loaded of [0, 4, 10]) onProgress(loaded, 10);
      return { bytes: new Uint8Array(10), url, contentType: '' };
    };
    const reported = async (urls: string[]) => {
      const seen: [number, number][] = [];
      for await (const _file of fetchInOrder(urls, fetchOne, (loaded, total) => seen.push([loaded, total])));
      return seen;
    };
    expect(await reported(['a'])).to.deep.equal([
      [0, 10],
      [4, 10],
      [10, 10],
    ]);
    expect(await reported(['a', 'b'])).to.deep.equal([
      [0, 0],
      [4, 0],
      [10, 0],
      [10, 0],
      [14, 0],
      [20, 0],
    ]);
  });
});
