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

  it('in an archive is decoded at once, as a file of it can not be read alone', async () => {
    const zip = zipSync(Object.fromEntries(made.map((bytes, i) => [`${i}.dcm`, bytes])), { level: 0 });
    const { volume, data } = await open({ local: { base, files: [new File([zip], 'a.zip')] } });
    expectTime(volume, 1);
    expect(data.every(hasNumbers)).to.equal(true);
    expectTime(await show(data[2]), 2);
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
