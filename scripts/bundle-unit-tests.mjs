// Bundles the unit tests that run in a browser. Without it, the pages of these tests load some 16,000 modules one by one. It also keeps a
// run from files that are changed while it runs.
import { mkdtempSync, rmSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { build } from 'vite';
import { projectRoot } from './shared-data.mjs';

/** What every page of tests loads first. */
const setup = 'test/helpers/provide-substeps.ts';

/** Folders whose modules do nothing when they are loaded: they are one file each, which all pages of tests share. */
const shared = [
  'src/core',
  'src/volume',
  'src/optics',
  'src/quality',
  'src/radar',
  'src/formats',
  'src/sources',
  'src/renderer',
  'src/messages',
  'shaders',
];

/** @param {string} file - a path from the root of the project */
const nameOf = (file) => file.replace(/\.ts$/, '');

/**
 * Bundle test files into a new folder, which is removed when the process ends.
 * @param {string[]} files - paths from the root of the project
 * @returns {Promise<import('@web/test-runner').TestRunnerPlugin>} serves the bundles at the addresses of the files
 */
export async function bundleUnitTests(files) {
  const folder = mkdtempSync(join(projectRoot, 'node_modules/.test-unit-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  const address = `/${relative(projectRoot, folder).replaceAll('\\', '/')}`;
  await build({
    configFile: false,
    root: projectRoot,
    base: `${address}/`,
    publicDir: false,
    logLevel: 'error',
    resolve: { conditions: ['module', 'browser', 'production'] }, // Lit's development build talks on the console.
    worker: { format: 'es' },
    build: {
      outDir: folder,
      assetsInlineLimit: 0,
      minify: false,
      modulePreload: false,
      sourcemap: true,
      target: 'es2022',
      rolldownOptions: {
        input: Object.fromEntries([setup, ...files].map((file) => [nameOf(file), join(projectRoot, file)])),
        preserveEntrySignatures: false,
        treeshake: false, // Modules of tests are loaded for what they do.
        output: {
          entryFileNames: '[name].js',
          chunkFileNames: 'chunks/[name]-[hash].js',
          codeSplitting: {
            groups: shared.map((name) => ({
              name: name.replaceAll('/', '-'),
              // From the root on: a folder of tests has the name of the folder that it tests.
              test: (/** @type {string} */ id) => id.startsWith(join(projectRoot, name) + sep),
            })),
          },
        },
      },
    },
  });
  const served = new Set(files.map((file) => `/${file}`));
  return {
    name: 'bundled-unit-tests',
    serve: ({ path }) =>
      served.has(path)
        ? {
            body: [setup, path.slice(1)].map((file) => `import '${address}/${nameOf(file)}.js';\n`).join(''),
            type: 'js',
          }
        : undefined,
  };
}
