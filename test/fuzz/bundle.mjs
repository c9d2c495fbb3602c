// The sources are TypeScript, which Node can not read as it is: the worker and all of it become one file.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * @returns {Promise<URL>} the worker's script, which is removed when the program ends
 */
export async function bundleWorker() {
  const result = await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'error',
    build: {
      write: false,
      minify: false,
      target: 'node20',
      lib: { entry: fileURLToPath(new URL('worker.ts', import.meta.url)), formats: ['es'] },
      rolldownOptions: { external: /^node:/, output: { codeSplitting: false } },
    },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  const folder = mkdtempSync(join(tmpdir(), 'volume-view-fuzz-'));
  process.once('exit', () => rmSync(folder, { recursive: true, force: true }));
  const file = join(folder, 'worker.mjs');
  writeFileSync(file, output[0].code);
  return pathToFileURL(file);
}
