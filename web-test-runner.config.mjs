// Unit tests in a real browser: `npx wtr --files test/browser/x3d/x.test.ts` runs one file; `--watch` serves the files as they are.
import { createReadStream, existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { esbuildPlugin } from '@web/dev-server-esbuild';
import { defaultReporter } from '@web/test-runner';
import { playwrightLauncher } from '@web/test-runner-playwright';
import { bundleUnitTests } from './scripts/bundle-unit-tests.mjs';
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

const folder = 'test/browser';

const stray = readdirSync(join(projectRoot, 'test'), { recursive: true, encoding: 'utf8' }).filter(
  (name) => name.endsWith('.test.ts') && !/^(unit|browser)[\\/]|node_modules/.test(name),
);
if (stray.length > 0) throw new Error(`no runner runs ${stray.join(', ')}: put them into test/unit or test/browser`);

/** The test files of this run, if it names them one by one; else all. */
function listTests() {
  const named = process.argv
    .slice(2)
    .filter((word) => word.endsWith('.test.ts') && existsSync(join(projectRoot, word)));
  const all = () =>
    readdirSync(join(projectRoot, folder), { recursive: true, encoding: 'utf8' }).map(
      (name) => `${folder}/${name.replaceAll('\\', '/')}`,
    );
  return named.length > 0 ? named : all().filter((name) => name.endsWith('.test.ts'));
}

const isWatching = process.argv.includes('--watch');
const bundled = isWatching ? null : await bundleUnitTests(listTests());
const setup = '<script type="module" src="/test/helpers/provide-substeps.ts"></script>';
const flags = process.env.VOLUME_VIEW_ALL_CASES ? '<script>globalThis.__allCases = true</script>' : '';

export default {
  files: `${folder}/**/*.test.ts`,
  nodeResolve: { exportConditions: ['production'] }, // Lit's development build talks on the console.
  concurrency: 2, // While one file starts, or works a reference out, another has software GL.
  browserStartTimeout: 120_000,
  testsStartTimeout: 120_000,
  testsFinishTimeout: 600_000,
  /** @param {string} framework */
  testRunnerHtml: (framework) =>
    `<!doctype html><html><body>${flags}${isWatching ? setup : ''}<script type="module" src="${framework}"></script></body></html>`,
  testFramework: { config: { timeout: 60_000 } },
  browsers: [
    playwrightLauncher({
      product: 'chromium',
      launchOptions: { executablePath: await findBrowser(), args: listTestArgs() },
      ...reusePages(),
    }),
  ],
  plugins: [
    ...(bundled ? [bundled] : []),
    esbuildPlugin({ ts: true, target: 'es2022', tsconfig: fileURLToPath(new URL('./tsconfig.json', import.meta.url)) }),
    rawPlugin,
  ],
  middleware: [serveSharedData, serveFixtures],
  reporters: [defaultReporter({ reportTestResults: true, reportTestProgress: false }), countsReporter()],
};
