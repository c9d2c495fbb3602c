// The development server, which an author sees first: it bundles packages in another way than the build.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { checkPicture, made, openUrl } from './open-app.mjs';

/** A pyramid in shards, of which the server sends parts. @param {string} root - of the app */
function makePyramid(root) {
  const program = join(projectRoot, 'packages/prepare/bin/volume-view-prepare.js');
  const file = join(projectRoot, 'demos/data/mni152-t1.nii.gz');
  execFileSync(process.execPath, [program, file, '--as', 'ome-zarr', '--out', join(root, 'public/head')]);
}

/**
 * A pyramid is shown in bricks, and what is wrong with a file is said as on any page: the parts of a worker are those of one copy of it.
 * @param {import('./open-app.mjs').OpenApp} app
 */
async function checkFiles({ page }) {
  const show = (/** @type {string} */ src) =>
    page.evaluate(async (address) => {
      const view = /** @type {any} */ (document.createElement('volume-view'));
      /** @type {string[]} */
      const codes = [];
      view.addEventListener('error', (/** @type {any} */ { detail }) => codes.push(detail.code));
      view.style.cssText = 'display: block; width: 120px; height: 90px';
      for (const [name, value] of Object.entries({ src: address, loading: 'eager', 'max-gpu-bytes': '2.2e6' }))
        view.setAttribute(name, value);
      document.body.append(view);
      await view.whenRendered().catch(() => undefined);
      const { count = 0 } = view.renderStats?.bricks ?? {};
      view.remove();
      return { codes, count };
    }, src);
  const { codes, count } = await show('/head.ome.zarr/');
  assert.deepEqual(codes, []);
  assert.ok(count > 3, `${count} bricks`);
  assert.deepEqual((await show('/app.js')).codes, ['format/unknown']);
  return `${count} bricks`;
}

/** @param {string} root - of the app */
export async function checkDevelopment(root) {
  makePyramid(root);
  const { createServer } = await import('vite'); // Installed only now.
  const server = await createServer({
    root,
    logLevel: 'error',
    cacheDir: `${root}/cache`,
    server: { host: '127.0.0.1', port: 0 },
    plugins: [
      {
        name: 'volume',
        configureServer: ({ middlewares }) =>
          void middlewares.use((request, response, next) => {
            const bytes = made[/** @type {keyof typeof made} */ (request.url ?? '')]?.();
            if (bytes) response.end(bytes);
            else if (request.url === '/favicon.ico') response.writeHead(204).end();
            else next();
          }),
      },
    ],
  });
  await server.listen();
  try {
    return await openUrl(server.resolvedUrls?.local[0] ?? '', async (app) => {
      const remark = await checkPicture({
        ...app,
        get troubles() {
          return app.troubles.filter((text) => !text.includes('Lit is in dev mode'));
        },
      });
      return `${remark}, ${await checkFiles(app)}`;
    });
  } finally {
    await server.close();
  }
}
