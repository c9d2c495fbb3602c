// `npm run zip` packs the files that a page needs into one file, to unpack on any web server: the built scripts, a page that works at once,
// a page for iframes, and a sample. `--out FILE` names it. The same files always give the same bytes.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { zipSync } from 'fflate';
import { projectRoot } from './shared-data.mjs';

const { version } = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
const { values: options } = parseArgs({
  options: { out: { type: 'string', default: join(projectRoot, `volume-view-${version}.zip`) } },
});
const dist = join(projectRoot, 'dist');
const pages = join(projectRoot, 'scripts/zip');
const sample = readFileSync(join(projectRoot, 'demos/data/ct-phantom.nii.gz'));

/** @type {import('fflate').Zippable} */
const files = {};
/** @param {string} name @param {Uint8Array} bytes */
const add = (name, bytes) =>
  (files[`volume-view/${name.replaceAll('\\', '/')}`] = [bytes, { level: 9, mtime: new Date(1980, 0, 2) }]);

// The modules for bundlers and the types are only for people who install the package.
for (const entry of readdirSync(dist, { recursive: true, withFileTypes: true })) {
  const path = join(entry.parentPath, entry.name);
  const name = relative(dist, path);
  if (entry.isFile() && !/^(esm\b|types\b|create-worker|x3dom-(url|beside-page))/.test(name))
    add(name, readFileSync(path));
}
const page = readFileSync(join(pages, 'index.html'), 'utf8').replace(
  '{{sample}}',
  `data:application/octet-stream;base64,${sample.toString('base64')}`,
);
add('index.html', Buffer.from(page));
add('index.css', readFileSync(join(pages, 'index.css')));
add('sample.nii.gz', sample);
add('LICENSE', readFileSync(join(projectRoot, 'LICENSE')));

const packed = zipSync(files);
writeFileSync(resolve(options.out), packed);
console.log(`${options.out}: ${Object.keys(files).length} files, ${(packed.length / 1e6).toFixed(1)} MB`);
