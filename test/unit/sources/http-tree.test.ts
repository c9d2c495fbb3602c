// Parts of the files of a folder on a server.
import { expect } from '@esm-bundle/chai';
import { HttpTree } from '../../../src/sources/http-tree.ts';

const bytes = Uint8Array.from({ length: 100 }, (_, n) => n);

/** @param partOf - from a range that was asked for to the first byte and the last one that the server sends */
function serve(partOf: (range: string) => readonly [number, number]) {
  const asked: string[] = [];
  const fetch = async (_url: RequestInfo | URL, init?: RequestInit): Promise<Response> => {
    const range = new Headers(init?.headers).get('range')!;
    asked.push(range);
    const [first, last] = partOf(range);
    const headers = { 'content-range': `bytes ${first}-${last}/100` };
    return new Response(bytes.slice(first, last + 1), { status: 206, headers });
  };
  const options = { pageOrigin: 'https://example.test', fetch, onProgress: () => undefined };
  return { tree: new HttpTree('https://example.test/x.zarr/', '', options), asked };
}

/** As the standard says, or with the numbers alone, as sirv 3.0 reads them. */
const byStandard = (range: string): readonly [number, number] => {
  const [first, last] = range.slice('bytes='.length).split('-');
  return first === '' ? [100 - Number(last), 99] : [Number(first), Number(last)];
};
const asSirv = (range: string): readonly [number, number] => {
  const [first, last] = range.slice('bytes='.length).split('-');
  return [Number(first || 0), Number(last)];
};

describe('the last bytes of a file of a folder', () => {
  it('are asked for at once', async () => {
    const { tree, asked } = serve(byStandard);
    expect([...(await tree.read('0', { part: { last: 20 } }))!]).to.deep.equal([...bytes.slice(80)]);
    expect(asked).to.deep.equal(['bytes=-20']);
  });

  it('are asked for again by their numbers, where a server sends the first ones', async () => {
    const { tree, asked } = serve(asSirv);
    expect([...(await tree.read('0', { part: { last: 20 } }))!]).to.deep.equal([...bytes.slice(80)]);
    expect(asked).to.deep.equal(['bytes=-20', 'bytes=80-99']);
    expect([...(await tree.read('0', { part: { start: 5, end: 9 } }))!]).to.deep.equal([5, 6, 7, 8]);
  });
});
