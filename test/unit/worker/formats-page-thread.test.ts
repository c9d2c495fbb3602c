import { expect } from '@esm-bundle/chai';
import { decodeHere } from '../../../src/worker/decode-here.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import { expectError, fetchFixture, roomyLimits } from '../../helpers/decode.ts';
import { pageOrigin, withServer } from '../../helpers/fake-fetch.ts';
import type { Answer } from '../../helpers/fake-fetch.ts';

const environment = { pageOrigin, onProgress: () => undefined };
const requestOf = (url: string, files?: string[]): LoadRequest => ({ url, files, limits: roomyLimits });
const textOf = (text: string): Answer => ({ pieces: [new TextEncoder().encode(text)] });

describe('a page that allows no worker', () => {
  it('refuses what would hold it up for long, and says that a worker would not', () =>
    withServer([{ headers: { 'content-length': String(2 ** 28 + 1) } }], async () => {
      const { code, message } = await expectError(decodeHere(requestOf(`${pageOrigin}/large.nii`), environment));
      expect(code).to.equal('format/too-large');
      expect(message).to.contain('allows no worker').and.to.contain('256 MiB').and.to.contain('worker-src');
    }));

  it('gives the page a turn between two long works', async () => {
    const bytes = await fetchFixture('nifti/v1-le-i2.nii');
    const native = globalThis.setTimeout;
    let turns = 0;
    globalThis.setTimeout = ((act: () => void) => (turns++, native(act))) as typeof setTimeout;
    try {
      const url = URL.createObjectURL(new Blob([bytes]));
      expect((await decodeHere(requestOf(url), environment)).grid.dimensions).to.deep.equal([3, 4, 5]);
      URL.revokeObjectURL(url);
    } finally {
      globalThis.setTimeout = native;
    }
    expect(turns).to.equal(2);
  });
});

describe('the files that a manifest names', () => {
  for (const [what, base, image, credentials] of [
    ["of the page's own origin come as the page's reader", pageOrigin, 'a.nii', undefined],
    ['of another origin do not', 'https://other.test', 'a.nii', 'omit'],
    [
      "of another origin do not, at the page's origin least of all",
      'https://other.test',
      `${pageOrigin}/private`,
      'omit',
    ],
  ] as const) {
    it(what, () =>
      withServer([textOf(JSON.stringify({ image })), { status: 404 }], async (asked) => {
        await expectError(decodeRequest(requestOf(`${base}/a.json`), environment));
        expect(asked.map((one) => one.credentials)).to.deep.equal([undefined, credentials]);
        expect(asked[1].url).to.equal(new URL(image, base).href);
      }),
    );
  }

  it('come with the credentials that the attribute crossorigin asks for, except where the manifest is of another origin', async () => {
    for (const [base, second] of [
      [pageOrigin, 'include'],
      ['https://other.test', 'omit'],
    ])
      await withServer([textOf(JSON.stringify({ image: 'a.nii' })), { status: 404 }], async (asked) => {
        const request = { ...requestOf(`${base}/a.json`), settings: { credentials: 'include' } as const };
        await expectError(decodeRequest(request, environment));
        expect(asked.map((one) => one.credentials)).to.deep.equal(['include', second]);
      });
  });

  it('that the page lists itself come as its reader, whatever their first one is', async () => {
    const files = ['https://other.test/a.png', `${pageOrigin}/b.png`];
    const png = await fetchFixture('mosaic/gray-3x2.png');
    await withServer([{ pieces: [png] }, { status: 404 }], async (asked) => {
      await expectError(decodeRequest(requestOf(files[0], files), environment));
      expect(asked.map(({ url, credentials }) => [url, credentials])).to.deep.equal(
        files.map((url) => [url, undefined]),
      );
    });
  });

  for (const image of [
    'blob:https://example.test/8c5b1c5e',
    'file:///etc/passwd',
    'javascript:alert(1)',
    'ftp://example.test/a.nii',
  ]) {
    it(`may not be ${image}`, () =>
      withServer([textOf(JSON.stringify({ image }))], async (asked) => {
        const { code, message } = await expectError(decodeRequest(requestOf(`${pageOrigin}/a.json`), environment));
        expect(code).to.equal('manifest/invalid');
        expect(message).to.contain(image).and.to.contain('http:, https: or data:');
        expect(asked).to.have.length(1);
      }));
  }
});
