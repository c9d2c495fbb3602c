import { expect } from '@esm-bundle/chai';
import { fetchBytes } from '../../src/formats/fetch-bytes.ts';

/** A server that sends these pieces and says so much of their length. */
async function fetchPieces(pieces: readonly number[][], contentLength: number | null): Promise<{ bytes: Uint8Array; totals: number[] }> {
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
  const lengths: [string, number | null, number][] = [['is right', 6, 6], ['is missing', null, 0], ['is too small', 4, 0], ['is smaller than a piece', 2, 0], ['is too large', 9, 9]];
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
