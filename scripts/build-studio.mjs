// `npm run build` in packages/studio: builds the studio as a static folder, dist, which any web server can serve and which opens from a disk. The element
// has been built before.
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { zipSync } from 'fflate';
import { build, defaultClientConditions } from 'vite';
import { leaveOutNode, makeCodecModules, stripTexts } from './build-plugins.mjs';
import { licencesOfModules } from './licence-texts.mjs';
import { playerFiles } from './player-files.mjs';
import { projectRoot } from './shared-data.mjs';

const folder = join(projectRoot, 'packages/studio');
const out = join(folder, 'dist');
const element = join(projectRoot, 'dist');
const demos = join(projectRoot, 'demos');

/** The volumes to begin with, and their pictures. */
const samples = {
  brain: { files: ['mni152-t1.nii.gz'], picture: 'one-tag' },
  torso: { files: ['ct-phantom.json', 'ct-phantom.nii.gz'], picture: 'preset-ct-bone' },
  storm: { files: ['storm-radar-1500.json', 'storm-radar-1500.png'], picture: 'radar' },
};

/** @param {string} entry @param {string[]} conditions @returns {Promise<{ code: string, modules: string[] }>} a classic script, and what it is made of */
async function buildScript(entry, conditions) {
  const result = await build({
    configFile: false,
    root: folder,
    publicDir: false,
    logLevel: 'warn',
    resolve: { conditions: [...conditions, ...defaultClientConditions] },
    plugins: [stripTexts, makeCodecModules, leaveOutNode],
    build: {
      write: false,
      target: 'es2022',
      minify: true,
      lib: { entry: join(folder, entry), formats: ['iife'], name: 'LessonStudio' },
    },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return { code: output[0].code, modules: output[0].moduleIds };
}

/** Writes a large file as a script: see src/data/parts.ts. @param {string} name @param {Uint8Array} bytes */
function writePart(name, bytes) {
  const text = Buffer.from(bytes).toString('base64');
  writeFileSync(join(out, `parts/${name}.js`), `(window.studioParts ??= {})[${JSON.stringify(name)}] = '${text}';\n`);
}

/** @param {string} place @returns {Record<string, Uint8Array>} the files of a folder, or the file, by their paths in the folder of the element */
function readFiles(place) {
  const path = join(element, place);
  const entries = readdirSync(path.replace(/\/[^/]*$/, ''), { withFileTypes: true });
  const isFolder = entries.some((one) => one.name === place && one.isDirectory());
  if (!isFolder) return { [place]: readFileSync(path) };
  const files = readdirSync(path, { recursive: true, withFileTypes: true }).filter((one) => one.isFile());
  return Object.fromEntries(
    files.map((one) => {
      const file = join(one.parentPath, one.name);
      return [relative(element, file).replaceAll('\\', '/'), readFileSync(file)];
    }),
  );
}

/** Build the folder dist. @returns {Promise<void>} */
export async function buildStudio() {
  const [page, worker] = [
    await buildScript('src/page/main.ts', []),
    await buildScript('src/data/prepare-worker.ts', ['as-text']),
  ];
  rmSync(out, { recursive: true, force: true });
  for (const one of ['parts', 'images', 'player']) mkdirSync(join(out, one), { recursive: true });
  writeFileSync(join(out, 'studio.js'), page.code);
  for (const name of ['index.html', 'src/studio.css']) cpSync(join(folder, name), join(out, name.replace('src/', '')));
  for (const name of playerFiles) cpSync(join(element, name), join(out, 'player', name), { recursive: true });
  writeFileSync(join(out, 'LICENSES.txt'), licencesOfModules([...page.modules, ...worker.modules]));
  writePart('prepare-worker', Buffer.from(worker.code));
  writePart('player', zipSync(Object.assign({}, ...playerFiles.map(readFiles)), { level: 6 }));
  for (const [name, { files, picture }] of Object.entries(samples)) {
    const packed = Object.fromEntries(files.map((file) => [file, readFileSync(join(demos, 'data', file))]));
    writePart(`sample-${name}`, zipSync(packed, { level: 0 }));
    cpSync(join(demos, `images/${picture}.webp`), join(out, `images/${name}.webp`));
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await buildStudio();
