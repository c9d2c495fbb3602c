import { expect } from '@esm-bundle/chai';
import { fetchBytes } from '../../../src/sources/fetch-bytes.ts';
import { expectError } from '../../helpers/decode.ts';
import { fetchOne, withServer } from '../../helpers/fake-fetch.ts';

/** A server that sends these pieces and says so much of their length. */
async function fetchPieces(
  pieces: readonly number[][],
  contentLength: number | null,
): Promise<{ bytes: Uint8Array; totals: number[] }> {
  const native = globalThis.fetch;
  const body = new ReadableStream<Uint8Array>({
    start(controller) {
      for (const piece of pieces) controller.enqueue(Uint8Array.from(piece));
      controller.close();
    },
  });
  const headers = contentLength === null ? undefined : { 'content-length': String(contentLength) };
  globalThis.fetch = async () => new Response(body, { headers });
  const totals: number[] = [];
  try {
    const onProgress = (_: number, total: number): void => void totals.push(total);
    const { bytes } = await fetchBytes('https://example.test/a', { pageOrigin: 'https://example.test', onProgress });
    return { bytes, totals };
  } finally {
    globalThis.fetch = native;
  }
}

describe('bytes that are fetched', () => {
  const pieces = [[1, 2, 3], [4], [5, 6]];
  const lengths: [string, number | null, number][] = [
    ['is right', 6, 6],
    ['is missing', null, 0],
    ['is too small', 4, 0],
    ['is smaller than a piece', 2, 0],
    ['is too large', 9, 9],
  ];
  for (const [what, announced, total] of lengths) {
    it(`are all there where the announced length ${what}`, async () => {
      const { bytes, totals } = await fetchPieces(pieces, announced);
      expect(Array.from(bytes)).to.deep.equal([1, 2, 3, 4, 5, 6]);
      expect(totals.at(-1)).to.equal(total);
    });
  }

  it('lie in one buffer of their length where it was announced', async () => {
    const { bytes } = await fetchPieces(pieces, 6);
    expect(bytes.buffer.byteLength).to.equal(6);
  });
});

/** Lengths of the arrays that are allocated meanwhile. */
async function watchAllocations(run: () => Promise<unknown>): Promise<number[]> {
  const native = globalThis.Uint8Array;
  const lengths: number[] = [];
  globalThis.Uint8Array = new Proxy(native, {
    construct(target, args: unknown[], self) {
      if (typeof args[0] === 'number') lengths.push(args[0]);
      return Reflect.construct(target, args, self) as object;
    },
  });
  try {
    await run();
  } finally {
    globalThis.Uint8Array = native;
  }
  return lengths;
}

describe('an announced length', () => {
  it('of 2 GB allocates little until bytes come', () =>
    withServer([{ headers: { 'content-length': '2000000000' }, pieces: [[1, 2, 3]] }], async () => {
      const lengths = await watchAllocations(() => fetchOne());
      expect(Math.max(...lengths)).to.be.within(3, 2 ** 24);
    }));

  it('that is true ends in one buffer of that length, of which an eighth was copied', async () => {
    const mebibyte = new Uint8Array(2 ** 20).fill(7);
    const length = 17 * 2 ** 20;
    await withServer(
      [{ headers: { 'content-length': String(length) }, pieces: Array<typeof mebibyte>(17).fill(mebibyte) }],
      async () => {
        let bytes = new Uint8Array();
        const lengths = await watchAllocations(async () => {
          ({ bytes } = await fetchOne());
        });
        expect(lengths.filter((one) => one >= 2 ** 20)).to.deep.equal([length / 8, length]);
        expect(bytes.buffer.byteLength).to.equal(length);
        expect(bytes.every((byte) => byte === 7)).to.equal(true);
      },
    );
  });

  it('beyond what the load may hold is refused before a byte is read', () =>
    withServer([{ headers: { 'content-length': '1001' } }], async () => {
      const { code, message } = await expectError(fetchOne('/a.nii', { maxBytes: 1000 }));
      expect(code).to.equal('format/too-large');
      expect(message).to.contain('1,001').and.to.contain('1,000');
    }));
});
