import { expect } from '@esm-bundle/chai';
import { expectError } from '../../helpers/decode.ts';
import { fetchOne, pageOrigin, withServer } from '../../helpers/fake-fetch.ts';
import type { Answer } from '../../helpers/fake-fetch.ts';

const whole: Answer = {
  pieces: [
    [1, 2, 3],
    [4, 5, 6],
  ],
  headers: { 'content-length': '6' },
};
const half: Answer = {
  pieces: [[1, 2, 3]],
  breaks: true,
  headers: { 'content-length': '6', 'accept-ranges': 'bytes', etag: '"one"' },
};
const rest: Answer = { status: 206, pieces: [[4, 5, 6]], headers: { 'content-range': 'bytes 3-5/6', etag: '"one"' } };
const bytesOf = async (): Promise<number[]> => Array.from((await fetchOne()).bytes);

describe('a file that did not come at once', () => {
  for (const status of [429, 502, 503, 504]) {
    it(`is asked for again after ${status}`, () =>
      withServer([{ status }, whole], async (asked, waits) => {
        expect(await bytesOf()).to.deep.equal([1, 2, 3, 4, 5, 6]);
        expect(asked).to.have.length(2);
        expect(waits).to.have.length(1);
        expect(waits[0]).to.be.within(375, 625);
      }));
  }

  it('is asked for again where its own server was not reached', () =>
    withServer([{ refused: true }, { refused: true }, whole], async (asked, waits) => {
      expect(await bytesOf()).to.deep.equal([1, 2, 3, 4, 5, 6]);
      expect(asked).to.have.length(3);
      expect(waits[1]).to.be.within(750, 1250);
    }));

  it('waits as long as the server asks for', () =>
    withServer([{ status: 503, headers: { 'retry-after': '7' } }, whole], async (_, waits) => {
      await bytesOf();
      expect(waits).to.deep.equal([7000]);
    }));

  it('waits until the time that the server names', () =>
    withServer(
      [{ status: 429, headers: { 'retry-after': new Date(Date.now() + 9000).toUTCString() } }, whole],
      async (_, waits) => {
        await bytesOf();
        expect(waits[0]).to.be.within(5000, 9000);
      },
    ));

  it('does not wait for minutes, and says that the server asks for them', () =>
    withServer([{ status: 503, headers: { 'retry-after': '120' } }], async (asked) => {
      const { code, message } = await expectError(fetchOne());
      expect(code).to.equal('source/unavailable');
      expect(message).to.contain('503').and.to.contain('120 seconds');
      expect(asked).to.have.length(1);
    }));

  it('is given up after three more times', () =>
    withServer(
      Array.from({ length: 9 }, () => ({ status: 503 })),
      async (asked) => {
        const { code } = await expectError(fetchOne());
        expect(code).to.equal('source/unavailable');
        expect(asked).to.have.length(4);
      },
    ));

  for (const [status, code] of [
    [404, 'source/not-found'],
    [401, 'source/not-found'],
    [403, 'source/not-found'],
    [500, 'source/unavailable'],
  ] as const) {
    it(`is not asked for again after ${status}, which is ${code}`, () =>
      withServer([{ status }, whole], async (asked) => {
        const error = await expectError(fetchOne());
        expect(error.code).to.equal(code);
        expect(error.message).to.contain(String(status));
        expect(asked).to.have.length(1);
      }));
  }

  it('is not asked for again where another origin refuses', () =>
    withServer([{ refused: true }, whole], async (asked) => {
      expect((await expectError(fetchOne('https://other.test/a.nii'))).code).to.equal('source/cross-origin');
      expect(asked).to.have.length(1);
    }));

  it('of a sandboxed page says which header it takes, and what else helps', () =>
    withServer([{ refused: true }], async () => {
      const { code, message } = await expectError(fetchOne('/a.nii', { pageOrigin: 'null' }));
      expect(code).to.equal('source/cross-origin');
      expect(message)
        .to.contain('has no origin')
        .and.to.contain('Access-Control-Allow-Origin: *')
        .and.to.contain('allow-same-origin')
        .and.to.contain('data: URL');
    }));

  it('stops to wait at once where it is given up', () =>
    withServer([{ status: 503, headers: { 'retry-after': '7' } }, whole], async (asked) => {
      const controller = new AbortController();
      let reported = 0;
      // The second sign of life of the new try is told right before it waits.
      const onProgress = (): void =>
        void (++reported === 1 && queueMicrotask(() => controller.abort(new Error('not wanted'))));
      const error = await fetchOne('/a.nii', { signal: controller.signal, onProgress }).then(
        () => null,
        (reason: unknown) => reason,
      );
      expect(error).to.have.property('message', 'not wanted');
      expect(asked).to.have.length(1);
    }));
});

describe('a file that broke off', () => {
  it('goes on where it did, if it is the same', () =>
    withServer([half, rest], async (asked) => {
      expect(await bytesOf()).to.deep.equal([1, 2, 3, 4, 5, 6]);
      expect(asked[1].headers).to.deep.equal({ range: 'bytes=3-', 'if-range': '"one"' });
    }));

  it('comes into one buffer of its length', () =>
    withServer([half, rest], async () => {
      expect((await fetchOne()).bytes.buffer.byteLength).to.equal(6);
    }));

  it('begins again where it is another one by now', () =>
    withServer(
      [
        half,
        {
          ...whole,
          pieces: [
            [9, 8, 7],
            [6, 5, 4],
          ],
        },
      ],
      async () => {
        expect(await bytesOf()).to.deep.equal([9, 8, 7, 6, 5, 4]);
      },
    ));

  const noTag = { 'content-length': '6', 'accept-ranges': 'bytes' };
  for (const [what, headers] of [
    ['gives it no name', noTag],
    ['gives it a weak name', { ...noTag, etag: 'W/"one"' }],
    ['sends no parts', { 'content-length': '6', etag: '"one"' }],
  ] satisfies [string, Record<string, string>][]) {
    it(`begins again where the server ${what}`, () =>
      withServer([{ ...half, headers }, whole], async (asked) => {
        expect(await bytesOf()).to.deep.equal([1, 2, 3, 4, 5, 6]);
        expect(asked[1].headers).to.deep.equal({});
      }));
  }

  for (const [what, answer] of [
    ['another part than the one that is missing', { ...rest, headers: { 'content-range': 'bytes 2-5/6' } }],
    ['that there is no such part', { status: 416 }],
  ] satisfies [string, Answer][]) {
    it(`begins again where the answer is ${what}`, () =>
      withServer([half, answer, whole], async (asked) => {
        expect(await bytesOf()).to.deep.equal([1, 2, 3, 4, 5, 6]);
        expect(asked).to.have.length(3);
      }));
  }

  it('again and again is unavailable, and says how far it came', () =>
    withServer(
      Array.from({ length: 4 }, () => ({ ...half, headers: noTag })),
      async () => {
        const { code, message } = await expectError(fetchOne());
        expect(code).to.equal('source/unavailable');
        expect(message).to.contain('broke off after 3 bytes');
      },
    ));

  it('at another origin is asked for again, without headers that need its permission', () =>
    withServer([half, whole], async (asked) => {
      await fetchOne('https://other.test/a.nii');
      expect(asked[1].headers).to.deep.equal({});
      expect(pageOrigin).to.not.equal(new URL(asked[1].url).origin);
    }));
});
