// The attribute crossorigin: a server of another origin that wants a cookie, for the volume and for what is inside of the view.
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { ballPly } from '../helpers/meshes.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { atlas } from './helpers/atlas.ts';
import { expect, open, keptTest as test, withElement } from './helpers/harness.ts';

const files: Record<string, Uint8Array> = {
  '/head.nii': niftiBytes(atlas),
  '/atlas.nii': niftiBytes(atlas),
  '/dseg.tsv': new TextEncoder().encode('index\tname\tcolor\n3\tRight side\t#ff0000\n7\tLeft side\t#0000ff\n'),
  '/ball.ply': new TextEncoder().encode(ballPly([0, 0, 0], 9)),
};

/** Answers with 401 where the cookie is absent. */
const server = createServer((request, response) => {
  response.setHeader('Access-Control-Allow-Origin', request.headers.origin ?? '*');
  response.setHeader('Access-Control-Allow-Credentials', 'true');
  const body = files[request.url ?? ''];
  response.statusCode = request.headers.cookie?.includes('key=1234') ? (body ? 200 : 404) : 401;
  response.end(response.statusCode === 200 ? body : '');
});
test.beforeAll(() => new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve)));
test.afterAll(() => new Promise<void>((resolve) => void (server.closeAllConnections(), server.close(() => resolve()))));

test.use({ allowedLines: /401|Failed to load resource|its box is/ });

test('use-credentials sends cookies to another server, for the volume, labels, their table and a surface; else none are sent', async ({
  page,
}) => {
  const other = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  await page.context().addCookies([{ name: 'key', value: '1234', url: other }]);
  await open(
    page,
    '<main><h1>Cookies</h1><volume-view id="v" style="width: 60px; height: 45px" alt="A field" interaction="none"></volume-view></main>',
  );
  const outcome = await withElement(
    page,
    async (one, url) => {
      const end = (of: HTMLElement, type: string): Promise<CustomEvent<{ message: string }>> =>
        new Promise((resolve) => of.addEventListener(type, (event) => resolve(event as never), { once: true }));
      one.src = `${url}/head.nii`;
      const refused = (await end(one, 'error')).detail.message;
      one.crossOrigin = 'use-credentials';
      await end(one, 'load');
      one.innerHTML = `<volume-labels src="${url}/atlas.nii" table="${url}/dseg.tsv"></volume-labels><volume-surface src="${url}/ball.ply"></volume-surface>`;
      const [labels, surface] = one.children as unknown as [
        HTMLElementTagNameMap['volume-labels'],
        HTMLElementTagNameMap['volume-surface'],
      ];
      const named = new Promise<readonly string[]>((resolve) =>
        labels.addEventListener('labels-change', () => {
          if (labels.labels.length > 1) resolve(labels.labels.map(({ name }) => name ?? ''));
        }),
      );
      await end(surface, 'load');
      return [refused, surface.info!.triangles, await named];
    },
    { argument: other },
  );
  expect(outcome[0]).toContain('401');
  expect(outcome.slice(1)).toEqual([528, ['', 'Right side', 'Left side']]);
});

test('a word that is none of its is an error', async ({ page }) => {
  await open(
    page,
    '<main><h1>Cookies</h1><volume-view id="v" src="/test/fixtures/nifti/v1-le-i2.nii" crossorigin="always" alt="A field"></volume-view></main>',
  );
  await expect(page.locator('volume-view .error')).toContainText('crossorigin got "always"');
});
