// Series of several times of which the files are at hand: one time is decoded, and the others when they are shown.
import { expect } from '@esm-bundle/chai';
import { zipSync } from 'fflate';
import { decodeRequest } from '../../../../src/worker/decode-request.ts';
import type { CoarseVolume, LoadProgress, LoadRequest } from '../../../../src/formats/base/load-request.ts';
import { hasNumbers } from '../../../../src/formats/base/scan-data.ts';
import type { ScanData } from '../../../../src/formats/base/scan-data.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

const base = 'https://local-3.invalid/';
const pageOrigin = 'https://example.test';
const [edge, slices, count] = [96, 36, 3];

/** The first number of a slice: 100 times its time, and its place. */
const firstOf = (time: number, k: number): number => 100 * time + k;

/** Files of 18 kB, which are longer than the start that is read of each. */
function slice(time: number, k: number): Uint8Array<ArrayBuffer> {
  const numbers = Int16Array.from({ length: edge * edge }, (_, i) =>
    i === 0 ? firstOf(time, k) : (i * (k + 3)) % 700,
  );
  return dicomBytes({
    ...ctSlice(2 * k),
    Modality: 'MR',
    RescaleIntercept: undefined,
    RescaleSlope: undefined,
    WindowCenter: undefined,
    Rows: [edge],
    Columns: [edge],
    PixelRepresentation: [1],
    PixelData: new Uint8Array(numbers.buffer),
    TriggerTime: String(40 * time),
  });
}

/** All files, slice by slice: the time changes first. */
const made = Array.from({ length: slices * count }, (_, i) => slice(i % count, Math.floor(i / count)));
const files = (): File[] => made.map((bytes, i) => new File([bytes], `Geheim-${i}.dcm`));

interface Opened {
  readonly volume: Volume;
  readonly times: readonly unknown[];
  readonly data: readonly ScanData[];
  readonly coarse: readonly CoarseVolume[];
  readonly progress: readonly LoadProgress[];
}

async function open(request: Partial<LoadRequest>): Promise<Opened> {
  let opened: Pick<Opened, 'times' | 'data'> = { times: [], data: [] };
  const coarse: CoarseVolume[] = [];
  const progress: LoadProgress[] = [];
  const volume = await decodeRequest(
    { url: base, scan: { index: 1 }, limits: roomyLimits, ...request },
    {
      pageOrigin,
      onProgress: (one) => progress.push(one),
      onCoarse: (one) => one && coarse.push(one),
      onScans: (times, data = []) => (opened = { times, data: structuredClone(data) }),
    },
  );
  return { volume, coarse, progress, ...opened };
}

/** Shows one of the times. */
const show = (data: ScanData): Promise<Volume> =>
  decodeRequest({ url: base, limits: roomyLimits, data }, { pageOrigin, onProgress: () => undefined });

function expectTime(volume: Volume, time: number): void {
  const values = valuesOf(volume);
  const firsts = Array.from({ length: slices }, (_, k) => values[k * edge * edge]);
  expect(firsts).to.deep.equal(Array.from({ length: slices }, (_, k) => firstOf(time, k)));
  expect(volume.format).to.equal(`DICOM, MR, volume ${time + 1} of ${count}`);
}

/** Does a task, and counts what is read of files as a whole meanwhile. */
async function countReads<T>(task: () => Promise<T>): Promise<{ result: T; bytes: number }> {
  const { arrayBuffer } = Blob.prototype;
  let bytes = 0;
  Blob.prototype.arrayBuffer = async function () {
    bytes += this.size;
    return arrayBuffer.call(this);
  };
  try {
    return { result: await task(), bytes };
  } finally {
    Blob.prototype.arrayBuffer = arrayBuffer;
  }
}

const size = made[0].length;
const starts = slices * count * 2 ** 14;

describe('a folder of DICOM of several times', function () {
  this.timeout(20_000);

  it('reads the time that is wanted, every eighth slice first, and the others when they are shown', async () => {
    const { result, bytes } = await countReads(() => open({ local: { base, files: files() } }));
    const { volume, times, data, coarse } = result;
    expect(times).to.deep.equal(['0 s', '0.04 s', '0.08 s']);
    expectTime(volume, 1);
    expect(coarse).to.have.length(1);
    expect(coarse[0].of).to.deep.include({ format: volume.format, window: volume.window });
    // The starts of all, one time, and three slices of each for one window.
    expect((bytes - starts) / size).to.be.within(slices, slices + 3 * count + 1);
    for (const time of [2, 0, 1]) {
      const shown = await countReads(() => show(data[time]));
      expectTime(shown.result, time);
      expect(shown.bytes, 'its own files').to.equal(slices * size);
      expect(shown.result.window).to.deep.equal(volume.window);
      expect(shown.result.grid).to.deep.equal(volume.grid);
    }
  });

  it('reports what is read of all, and never goes back', async () => {
    const { progress } = await open({ local: { base, files: files() } });
    const shares = progress.filter(({ total }) => total > 0).map(({ loaded, total }) => loaded / total);
    expect(shares.every((share, i) => i === 0 || share >= shares[i - 1])).to.equal(true);
    expect(shares.at(-1)).to.equal(1);
  });

  it('of a damaged slice says so where its time is shown', async () => {
    const some = files();
    some[count * 20 + 2] = new File([slice(2, 20).slice(0, -100)], 'Geheim-cut.dcm');
    const { volume, data } = await open({ local: { base, files: some } });
    expectTime(volume, 1);
    expect(volume.left).to.equal(undefined);
    const { left } = await show(data[2]);
    expect(left!.join()).to.match(/^file 21 of 36 of this time: damaged, and its place shown as no data/);
    expect((await show(data[0])).left).to.equal(undefined);
  });

  it('of which a file was changed is an error without a name', async () => {
    const { data } = await open({ local: { base, files: files() } });
    const { arrayBuffer } = Blob.prototype;
    Blob.prototype.arrayBuffer = async () => Promise.reject(new DOMException('Geheim', 'NotReadableError'));
    try {
      const { code, message } = await expectError(show(data[2]));
      expect(code).to.equal('format/corrupt');
      expect(message).to.match(/^file 1 of 36 of this time can not be read any longer/);
      expect(message).not.to.match(/Geheim/);
    } finally {
      Blob.prototype.arrayBuffer = arrayBuffer;
    }
  });

  for (const [packing, level] of [
    ['packed', 6],
    ['not packed', 0],
  ] as const) {
    const zip = (all = made) =>
      zipSync(Object.fromEntries(all.map((bytes, i) => [`Geheim-${i}.dcm`, bytes])), { level });

    it(`in an archive reads the time that is wanted, and the others when they are shown: ${packing}`, async () => {
      const archive = zip();
      const { result, bytes } = await countReads(() =>
        open({ local: { base, files: [new File([archive], 'Geheim.zip')] } }),
      );
      const { volume, data, coarse } = result;
      expectTime(volume, 1);
      expect(coarse).to.have.length(1);
      expect(data.some(hasNumbers)).to.equal(false);
      if (level === 0) expect((bytes - starts) / size, 'files that were read').to.be.below(slices + 3 * count + 5);
      for (const time of [2, 0]) {
        const shown = await countReads(() => show(data[time]));
        expectTime(shown.result, time);
        expect(shown.bytes, 'a third of the archive').to.be.below(1.1 * (archive.length / count));
      }
    });

    it(`in an archive of which a file is damaged says so where its time is shown: ${packing}`, async () => {
      const archive = zip();
      // A byte near the end of the pixels of slice 20 at the last time: the start of a file is looked at when the archive is opened.
      const name = new TextEncoder().encode(`Geheim-${count * 20 + 2}.dcm`);
      const at = archive.findIndex((_, i) => name.every((byte, k) => archive[i + k] === byte));
      const packed = new DataView(archive.buffer).getUint32(at - 12, true);
      archive[at + name.length + Math.round(0.95 * packed)] ^= 0x55;
      const { volume, data } = await open({ local: { base, files: [new File([archive], 'Geheim.zip')] } });
      expectTime(volume, 1);
      const { left } = await show(data[2]);
      expect(left!.join()).to.match(/^file 21 of 36 of this time: damaged, and its place shown as no data/);
      expect(left!.join()).not.to.match(/Geheim/);
    });
  }

  it('in an archive on a server is kept by the browser as it came', async () => {
    const native = globalThis.fetch;
    const archive = zipSync(Object.fromEntries(made.map((bytes, i) => [`${i}.dcm`, bytes])));
    let asked = 0;
    globalThis.fetch = async () => {
      asked++;
      return new Response(archive, { headers: { 'content-length': String(archive.length) } });
    };
    try {
      const { volume, data } = await open({ url: `${pageOrigin}/study.zip` });
      expectTime(volume, 1);
      expectTime(await show(data[2]), 2);
      expect(asked).to.equal(1);
    } finally {
      globalThis.fetch = native;
    }
  });
});

describe('a list of DICOM of several times on a server', function () {
  this.timeout(20_000);

  it('asks for the files of a time when it is shown', async () => {
    const urls = made.map((_, i) => `${pageOrigin}/${i}.dcm`);
    const native = globalThis.fetch;
    const whole: number[] = [];
    globalThis.fetch = async (url, { headers } = {}) => {
      const i = Number(/(\d+)\.dcm$/.exec(url as string)![1]);
      const range = new Headers(headers).get('range');
      if (!range) {
        whole.push(i);
        return new Response(made[i], { headers: { 'content-length': String(size) } });
      }
      const part = made[i].slice(0, 2 ** 14);
      const from = `bytes 0-${part.length - 1}/${size}`;
      return new Response(part, { status: 206, headers: { 'content-range': from } });
    };
    try {
      const { volume, data } = await open({ url: urls[0], files: urls });
      expectTime(volume, 1);
      expect(whole.length).to.be.within(slices, slices + 3 * count + 1);
      whole.length = 0;
      expectTime(await show(data[2]), 2);
      expect(whole.map((i) => i % count)).to.deep.equal(Array(slices).fill(2));
    } finally {
      globalThis.fetch = native;
    }
  });
});
