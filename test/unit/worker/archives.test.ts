import { expect } from '@esm-bundle/chai';
import { gzipSync, zipSync } from 'fflate';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { decodeHere } from '../../../src/worker/decode-here.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import { expectError, fetchFixture, roomyLimits, valuesOf } from '../../helpers/decode.ts';
import { pageOrigin, withServer } from '../../helpers/fake-fetch.ts';

const environment = { pageOrigin, onProgress: () => undefined };
const url = `${pageOrigin}/a.zip`;

/** Load an archive that a server sends, as a worker does. */
function load(bytes: Uint8Array<ArrayBuffer>, request: Partial<LoadRequest> = {}): Promise<Volume> {
  return withServer([{ pieces: [bytes] }], async (asked) => {
    const volume = await decodeRequest({ url, limits: roomyLimits, ...request }, environment);
    expect(asked).to.have.length(1);
    return volume;
  });
}

const loadFixture = async (name: string, request?: Partial<LoadRequest>): Promise<Volume> =>
  load(await fetchFixture(`zip/${name}.zip`), request);

async function loadLocal(names: readonly string[], request: Partial<LoadRequest> = {}): Promise<Volume> {
  const base = 'https://local-1.invalid/';
  const files = await Promise.all(
    names.map(async (name) => new File([await fetchFixture(name)], name.replace(/.*\//, ''))),
  );
  return decodeHere({ url: base, local: { base, files }, limits: roomyLimits, ...request }, environment);
}

describe('a volume in an archive', () => {
  it('is the same as in its file', async () => {
    const volume = await loadFixture('one');
    expect(volume.grid.dimensions).to.deep.equal([3, 4, 5]);
    expect(volume.format).to.equal('NIfTI-1');
    expect(volume.samples).to.deep.equal((await loadLocal(['nifti/v1-le-i2.nii'])).samples);
  });

  it('has its data in the archive too, and what a manifest says', async () => {
    expect(valuesOf(await loadFixture('detached'))).to.deep.equal([0, 1, 2, 3, 4, 5, 6, 7]);
    const { title, grid } = await loadFixture('manifest');
    expect([title, ...(grid as CartesianGrid).dimensions]).to.deep.equal(['Six tiles', 4, 4, 5]);
  });

  it('is a stack of all its images where the page says so', async () => {
    const volume = await loadFixture('slices', { files: [url] });
    expect(volume.grid.dimensions).to.deep.equal([12, 8, 3]);
  });

  it('may not be one file of a stack of several', async () => {
    const bytes = await fetchFixture('zip/one.zip');
    await withServer([{ pieces: [bytes] }], async () => {
      const files = [url, `${pageOrigin}/b.zip`];
      const error = await expectError(decodeRequest({ url, files, limits: roomyLimits }, environment));
      expect(error.code).to.equal('format/unsupported');
    });
  });

  it('may claim no more memory than its packed bytes allow, though they are packed twice', async () => {
    // 70 million zeros may be asked for by their gzip file, but not by the few bytes that it takes in an archive.
    const bytes = new Uint8Array(352 + 7e7);
    bytes.set((await fetchFixture('nifti/v1-le-i2.nii')).subarray(0, 352));
    const view = new DataView(bytes.buffer);
    [1000, 1000, 70].forEach((n, i) => view.setInt16(42 + 2 * i, n, true));
    [2, 8].forEach((n, i) => view.setInt16(70 + 2 * i, n, true));
    const packed = gzipSync(bytes, { level: 1, mtime: 0 });
    const twice = zipSync({ 'a.nii.gz': packed }, { level: 9 });
    expect([packed.length, twice.length / 100]).to.satisfy(([once, again]: number[]) => once > 50_000 && again < 200);
    expect((await expectError(load(twice))).code).to.equal('format/too-large');
    const stored = await load(zipSync({ 'a.nii.gz': packed }, { level: 0 }));
    expect(stored.samples.length).to.equal(7e7);
  });
});

describe('local files', () => {
  it('are read by the page itself too, where it allows no worker', async () => {
    const volume = await loadLocal(['metaimage/data.raw', 'metaimage/detached.mhd']);
    expect(volume.format).to.contain('MetaImage');
  });
});
