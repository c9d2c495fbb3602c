import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../src/formats/decode.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { groupFiles, lookAtFile } from '../../src/prepare/find-sources.ts';
import type { Source } from '../../src/prepare/find-sources.ts';
import { decodeSource } from '../../src/prepare/decode-source.ts';
import { prepareSource } from '../../src/prepare/prepare-source.ts';
import type { PreparedVolume } from '../../src/prepare/prepare-source.ts';
import { LocalStore } from '../../src/sources/local-store.ts';
import type { ByteStore } from '../../src/sources/byte-store.ts';
import type { CartesianGrid } from '../../src/volume/grid.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { roomyLimits } from './decode.ts';

export const base = 'https://files.test/';

/** Files by their paths. */
export function storeOf(files: Readonly<Record<string, Uint8Array<ArrayBuffer>>>): ByteStore {
  return new LocalStore(
    Object.entries(files).map(([name, bytes]) => Object.assign(new File([bytes], name), { webkitRelativePath: name })),
    base,
  );
}

/** All sources of a store. */
export async function sourcesOf(store: ByteStore): Promise<Source[]> {
  const found = [];
  for (const url of (await store.list())!) found.push(await lookAtFile(store, url));
  return groupFiles(found);
}

/** Reads what was written as a page would. */
export async function readPrepared({ png, manifest }: Pick<PreparedVolume, 'png' | 'manifest'>): Promise<Volume> {
  const files: Record<string, Uint8Array<ArrayBuffer>> = {
    'volume.json': new TextEncoder().encode(JSON.stringify({ image: 'volume.png', ...manifest })),
    'volume.png': new Uint8Array(png),
  };
  const store = storeOf(files);
  const fetchFile = (url: string) => store.read(url);
  const decoded = await decodeFile(
    await fetchFile(`${base}volume.json`),
    {},
    { fetchFile, fetchFiles: () => expect.fail('a mosaic is one file'), onProgress: () => undefined },
  );
  return finishVolume(decoded, roomyLimits);
}

const valueAt = ({ samples, slope, intercept, ids, grid }: Volume, i: number): number => {
  if (ids) return ids[samples[i]];
  const isEmpty = grid.kind === 'polar' && !(samples instanceof Float32Array) && samples[i] === 0;
  return isEmpty ? NaN : slope * samples[i] + intercept;
};

/** Whether two volumes are the same at the same places, within the stated error. Returns the largest difference. */
export function compareVolumes(got: Volume, wanted: Volume, stated: number): number {
  expect(got.unit).to.equal(wanted.unit);
  expect(Boolean(got.isDiscrete), 'labels').to.equal(Boolean(wanted.isDiscrete));
  if (isPolar(got) && isPolar(wanted)) expect(got.grid.sweeps.length).to.equal(wanted.grid.sweeps.length);
  else {
    expect(got.grid.dimensions).to.deep.equal(wanted.grid.dimensions);
    // JSON has no -0.
    const [place, own] = [got, wanted].map(({ grid }) => grid as CartesianGrid);
    expect(place.indexToWorld.map((n) => n + 0)).to.deep.equal(own.indexToWorld.map((n) => n + 0));
    expect(got.anatomical).to.equal(wanted.anatomical);
    if (!wanted.isDiscrete) expect(got.window).to.deep.equal(wanted.window);
  }
  expect(got.samples.length).to.equal(wanted.samples.length);
  let [worst, largest] = [0, 0];
  for (let i = 0; i < got.samples.length; i++) {
    const [a, b] = [valueAt(got, i), valueAt(wanted, i)];
    if (Number.isNaN(a) !== Number.isNaN(b)) expect.fail(`sample ${i} got ${a}; expected ${b}`);
    if (Number.isNaN(a)) continue;
    worst = Math.max(worst, Math.abs(a - b));
    largest = Math.max(largest, Math.abs(b));
  }
  // What is read may be rounded to float32 once more.
  expect(worst).to.be.at.most(stated * (1 + 1e-6) + largest * 2 ** -23);
  return worst;
}

/** Prepares all volumes of a source, reads them again, and compares them with the original. Returns how many there are. */
export async function roundTrip(store: ByteStore, source: Source): Promise<number> {
  const options = { deviceBytes: 2 ** 32, fit: 'desktop' as const, poster: 0 };
  const originals = decodeSource(store, source, options);
  let count = 0;
  for await (const prepared of prepareSource(store, source, options)) {
    const original = (await originals.next()).value!;
    count++;
    if ('code' in prepared) expect(original, prepared.message).to.have.property('error');
    else if ('error' in original) throw original.error;
    else {
      const read = await readPrepared(prepared);
      const worst = compareVolumes(read, original.volume, prepared.report.error.max);
      // An error that is stated is there.
      if (prepared.report.error.max > 0 && !isPolar(read))
        expect(worst).to.be.greaterThan(prepared.report.error.max / 2);
    }
  }
  return count;
}
