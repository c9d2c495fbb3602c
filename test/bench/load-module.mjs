import { mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * A TypeScript module of the project in Node, for benches without a browser: bundled, so that it runs at the speed of what is published.
 * @template T
 * @param {string} path - from the root of the project
 * @returns {Promise<T>} what it exports
 */
export async function loadModule(path) {
  const folder = mkdtempSync(join(projectRoot, 'node_modules/.bench-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'error',
    ssr: { noExternal: true },
    build: {
      ssr: true,
      outDir: folder,
      minify: false,
      target: 'node20',
      rolldownOptions: { input: { module: join(projectRoot, path) }, output: { entryFileNames: '[name].mjs' } },
    },
  });
  return import(pathToFileURL(join(folder, 'module.mjs')).href);
}
