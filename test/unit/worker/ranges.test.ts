// A plain NIfTI file of several times from a server that sends ranges, as the worker fetches it.
import { expect } from '@esm-bundle/chai';
import type { ScanData } from '../../../src/formats/base/scan-data.ts';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import { fetchFile, roomyLimits, valuesOf } from '../../helpers/decode.ts';
import { pageOrigin } from '../../helpers/fake-fetch.ts';

/** Bytes of one volume of the file. */
const volumeBytes = 17 * 21 * 3 * 2;

/** The file in pieces of 1,000 bytes, and its ranges; returns what was asked for, and how much was sent of the whole. */
async function withServer<T>(
  acceptRanges: string | null,
  run: (log: { readonly ranges: string[]; sent: number }) => Promise<T>,
): Promise<T> {
  const native = globalThis.fetch;
  const file = await fetchFile('/demos/data/functional.nii');
  const log = { ranges: [] as string[], sent: 0 };
  globalThis.fetch = async (_url, { headers } = {}) => {
    const range = /bytes=(\d+)-(\d+)/.exec(new Headers(headers).get('range') ?? '');
    if (range) {
      log.ranges.push(range[0]);
      const [start, end] = [Number(range[1]), Number(range[2])];
      return new Response(file.slice(start, end + 1), {
        status: 206,
        headers: { 'content-range': `bytes ${start}-${end}/${file.length}` },
      });
    }
    let at = 0;
    const body = new ReadableStream<Uint8Array>(
      {
        pull(controller) {
          if (at >= file.length) return controller.close();
          controller.enqueue(file.slice(at, at + 1000));
          log.sent = at = Math.min(file.length, at + 1000);
        },
      },
      { highWaterMark: 0 },
    );
    return new Response(body, {
      headers: { 'content-length': String(file.length), ...(acceptRanges && { 'accept-ranges': acceptRanges }) },
    });
  };
  try {
    return await run(log);
  } finally {
    globalThis.fetch = native;
  }
}

let data: readonly ScanData[] = [];
const read = (more: Partial<LoadRequest>): Promise<Volume> =>
  decodeRequest(
    { url: `${pageOrigin}/a.nii`, limits: roomyLimits, ...more },
    { pageOrigin, onProgress: () => undefined, onScans: (_times, found = []) => (data = found) },
  );

describe('a plain NIfTI file of several times', () => {
  it('is not fetched as a whole where its server sends ranges: a volume is fetched when it is shown', () =>
    withServer('bytes', async (log) => {
      const third = await read({ scan: { index: 2 } });
      expect(log.sent).to.equal(1000);
      const rangeOf = (t: number): string => `bytes=${352 + t * volumeBytes}-${352 + (t + 1) * volumeBytes - 1}`;
      expect(log.ranges.at(-1)).to.equal(rangeOf(2));
      const again = await read({ scan: { index: 2 }, data: data[2] });
      expect(valuesOf(again)).to.deep.equal(valuesOf(third));
      await read({ scan: { index: 19 }, data: data[19] });
      expect(log.ranges.at(-1)).to.equal(rangeOf(19));
      expect(log.sent).to.equal(1000);
    }));

  it('is fetched once where its server does not say that it sends ranges', () =>
    withServer(null, async (log) => {
      await read({ scan: { index: 2 } });
      await read({ scan: { index: 19 }, data: data[19] });
      expect(log.ranges).to.deep.equal([]);
      expect(log.sent).to.equal(43_192);
    }));

  it('is fetched as a whole where it is a layer or labels', () =>
    withServer('bytes', async (log) => {
      expect((await read({})).left).to.deep.equal(['volumes 2 to 20 of the file']);
      expect(log.ranges).to.deep.equal([]);
    }));

  it('is refused in words where a range has changed', () =>
    withServer('bytes', async () => {
      await read({ scan: { index: 0 } });
      const from = { url: `${pageOrigin}/a.nii`, start: 43_000, end: 43_000 + volumeBytes };
      const broken = read({ scan: { index: 0 }, data: { ...data[0], from } });
      expect(await broken.catch((error: Error) => error.message)).to.include(
        'sent 192 bytes of NIfTI-1, volume 1 of 20',
      );
    }));

  it('from the disk is read in parts too, without a server', async () => {
    const base = 'https://chosen.invalid/1/';
    const local = { base, files: [new File([await fetchFile('/demos/data/functional.nii')], 'x.nii')] };
    const first = await read({ url: base, local, scan: { index: 0 } });
    expect(data.length).to.equal(20);
    const last = await read({ url: base, local, scan: { index: 19 }, data: data[19] });
    expect(last.format).to.equal('NIfTI-1, volume 20 of 20');
    expect(valuesOf(last)).to.not.deep.equal(valuesOf(first));
  });

  it('of a chosen folder too, and of files that a page sends in groups', async () => {
    const base = 'https://chosen.invalid/2/';
    const file = new File([await fetchFile('/demos/data/functional.nii')], 'x.nii');
    const handle = { kind: 'file', name: file.name, getFile: async () => file };
    const folder = {
      kind: 'directory',
      name: 'scan',
      async *values() {
        yield handle;
      },
    };
    const sent = (): MessagePort => {
      const { port1, port2 } = new MessageChannel();
      port1.postMessage({ files: [], isLast: false });
      port1.postMessage({ files: [file], isLast: true });
      return port2;
    };
    for (const local of [() => ({ base, files: [folder] }), () => ({ base, files: [], rest: sent() })]) {
      data = [];
      const first = await read({ url: base, local: local(), scan: { index: 0 } });
      expect(data.length).to.equal(20);
      const last = await read({ url: base, local: local(), scan: { index: 19 }, data: data[19] });
      expect(last.format).to.equal('NIfTI-1, volume 20 of 20');
      expect(valuesOf(last)).to.not.deep.equal(valuesOf(first));
    }
  });
});
