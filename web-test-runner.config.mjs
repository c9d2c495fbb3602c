// Unit tests in a real browser: `npx wtr --files test/numeric/x.test.ts` runs one file.
import { createReadStream } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { esbuildPlugin } from '@web/dev-server-esbuild';
import { defaultReporter } from '@web/test-runner';
import { playwrightLauncher } from '@web/test-runner-playwright';
import { findBrowser, listTestArgs } from './scripts/find-browser.mjs';
import { reusePages } from './scripts/reuse-pages.mjs';
import { countsReporter } from './scripts/wtr-counts-reporter.mjs';
import { findFile, findSharedData, projectRoot, sharedDataPrefix } from './scripts/shared-data.mjs';

/** `import text from './chunk.glsl?raw'`, as vite has it. */
const rawPlugin = {
  name: 'raw',
  /** @param {import('koa').Context} context */
  resolveMimeType: ({ URL }) => (URL.searchParams.has('raw') ? 'js' : undefined),
  /** @param {import('koa').Context} context */
  transform: ({ URL, body }) => (URL.searchParams.has('raw') ? `export default ${JSON.stringify(body)};` : undefined),
};

/** @type {import('koa').Middleware} */
async function serveSharedData(context, next) {
  if (!context.path.startsWith(sharedDataPrefix)) return next();
  const file = findSharedData(context.path);
  context.status = file ? 200 : 404;
  context.type = 'application/octet-stream';
  context.body = file ? createReadStream(file) : 'no such file';
}

const fixtures = '/test/fixtures/';

/**
 * Fixtures byte for byte: the server itself takes files that are mostly text for text, and changes what is not UTF-8.
 * @type {import('koa').Middleware}
 */
async function serveFixtures(context, next) {
  const file = context.path.startsWith(fixtures)
    ? findFile(join(projectRoot, 'test/fixtures'), context.path.slice(fixtures.length))
    : null;
  if (!file) return next();
  context.type = 'application/octet-stream';
  context.body = createReadStream(file);
}

export default {
  files: ['test/{numeric,glsl,components}/**/*.test.ts'],
  nodeResolve: { exportConditions: ['production'] }, // Lit's development build talks on the console.
  concurrency: 2, // While one file starts, or works a reference out, another has software GL.
  browserStartTimeout: 120_000,
  testsStartTimeout: 120_000,
  testsFinishTimeout: 600_000,
  /** @param {string} framework */
  testRunnerHtml: (framework) =>
    `<!doctype html><html><body><script type="module" src="/test/helpers/provide-substeps.ts"></script><script type="module" src="${framework}"></script></body></html>`,
  testFramework: { config: { timeout: 60_000 } },
  browsers: [
    playwrightLauncher({
      product: 'chromium',
      launchOptions: { executablePath: await findBrowser(), args: listTestArgs() },
      ...reusePages(),
    }),
  ],
  plugins: [
    esbuildPlugin({ ts: true, target: 'es2022', tsconfig: fileURLToPath(new URL('./tsconfig.json', import.meta.url)) }),
    rawPlugin,
  ],
  middleware: [serveSharedData, serveFixtures],
  reporters: [defaultReporter({ reportTestResults: true, reportTestProgress: false }), countsReporter()],
};
