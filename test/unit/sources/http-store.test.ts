import { expect } from '@esm-bundle/chai';
import { HttpStore } from '../../../src/sources/http-store.ts';
import { expectError } from '../../helpers/decode.ts';
import { pageOrigin, withServer } from '../../helpers/fake-fetch.ts';
import type { Answer } from '../../helpers/fake-fetch.ts';

const store = new HttpStore({ pageOrigin });
const url = `${pageOrigin}/a.nii`;
const range = { start: 2, end: 5 };
const part: Answer = { status: 206, headers: { 'content-range': 'bytes 2-4/10' }, pieces: [[2, 3], [4]] };
const whole: Answer = {
  pieces: [
    [0, 1, 2, 3],
    [4, 5, 6, 7, 8, 9],
  ],
};

describe('a range of a file on a server', () => {
  it('is all that is requested', () =>
    withServer([part], async (asked) => {
      expect([...(await store.read(url, { range })).bytes]).to.deep.equal([2, 3, 4]);
      expect(asked.map(({ headers }) => headers.range)).to.deep.equal(['bytes=2-4']);
    }));

  for (const [what, answers] of [
    ['from a server that sends no parts', [whole]],
    ['from a server that hides which part it sends', [{ ...part, headers: {} }]],
    ['from a server that sends another part', [{ ...part, headers: { 'content-range': 'bytes 0-2/10' } }, whole]],
    ['from a server that packs a part', [{ ...part, headers: { ...part.headers, 'content-encoding': 'gzip' } }, whole]],
    ['after the connection broke', [{ refused: true }, whole]],
    ['after a part broke off', [{ ...part, pieces: [[2]], breaks: true }, whole]],
  ] as const) {
    it(`is right ${what}`, () =>
      withServer(answers, async (asked) => {
        expect([...(await store.read(url, { range })).bytes]).to.deep.equal([2, 3, 4]);
        expect(asked).to.have.length(answers.length);
      }));
  }

  it('is read no further than its end', async () => {
    let pulled = 0;
    const native = globalThis.fetch;
    const body = new ReadableStream<Uint8Array>(
      { pull: (controller) => controller.enqueue(Uint8Array.from([pulled++])) },
      { highWaterMark: 0 },
    );
    globalThis.fetch = async () => new Response(body);
    try {
      expect([...(await store.read(url, { range })).bytes]).to.deep.equal([2, 3, 4]);
    } finally {
      globalThis.fetch = native;
    }
    expect(pulled).to.equal(5);
  });

  it('beyond the end is empty', () =>
    withServer([{ status: 416 }], async () => {
      expect((await store.read(url, { range: { start: 20, end: 30 } })).bytes.length).to.equal(0);
    }));

  it('of a missing file is an error in words', () =>
    withServer([{ status: 404 }, { status: 404 }], async () => {
      // Node 20 has none, and what explains failures asks whether there is a network.
      if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });
      expect((await expectError(store.read(url, { range }))).code).to.equal('source/not-found');
    }));

  it('of a data: URL needs no server', () =>
    withServer([{ pieces: [[65, 66, 67]] }], async (asked) => {
      expect([...(await store.read('data:,ABC', { range: { start: 1, end: 2 } })).bytes]).to.deep.equal([66]);
      expect(asked[0].headers).to.deep.equal({});
    }));

  it('may be no larger than a load may read', () =>
    withServer([{ ...part, headers: { ...part.headers, 'content-length': '3' } }], async () => {
      expect((await expectError(store.read(url, { range, maxBytes: 2 }))).code).to.equal('format/too-large');
    }));
});

describe('the size of a file on a server', () => {
  for (const [what, answer, size] of [
    ['is what it says', { headers: { 'content-length': '10' } }, 10],
    ['is unknown where it does not say', {}, null],
    [
      'is unknown where it packs what it sends',
      { headers: { 'content-length': '10', 'content-encoding': 'gzip' } },
      null,
    ],
    ['is unknown where the file is missing', { status: 404, headers: { 'content-length': '10' } }, null],
    ['is unknown where there is no answer', { refused: true }, null],
  ] as const) {
    it(what, () => withServer([answer], async () => void expect(await store.stat(url)).to.deep.equal({ size })));
  }

  it('can not be listed', async () => void expect(await store.list()).to.equal(null));
});
