#!/usr/bin/env node
// Writes one moment of a radar file (ODIM_H5, CfRadial, NEXRAD Level II) as a mosaic, a PNG with a sweep a tile, and the
// manifest that says where its gates lie. <volume-view src="….json"> shows the same picture of it as of the file.
//   volume-view-radar-mosaic FILE [--moment NAME] [--out NAME-WITHOUT-EXTENSION]
import { existsSync, readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inspect, parseArgs } from 'node:util';

const usage = 'volume-view-radar-mosaic FILE [--moment NAME] [--out NAME-WITHOUT-EXTENSION]';
const source = new URL('../src/formats/radar-mosaic-tool.ts', import.meta.url);
const built = new URL('../dist/esm/src/formats/radar/radar-mosaic-tool.js', import.meta.url);

/**
 * The package's own modules: in a checkout the source, which Node can not read as it is, in the package what was built.
 * @returns {Promise<typeof import('../src/formats/radar-mosaic-tool.ts')>}
 */
export async function loadTool() {
  if (!existsSync(source)) return import(built.href);
  const { build } = await import('vite');
  const result = await build({
    configFile: false,
    root: fileURLToPath(new URL('..', import.meta.url)),
    publicDir: false,
    logLevel: 'error',
    build: { write: false, minify: false, lib: { entry: fileURLToPath(source), formats: ['es'] }, rolldownOptions: { output: { codeSplitting: false } } },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}

/** A manifest as JSON, its lists and inner objects on one line where they hold nothing deeper. @param {object} manifest */
export function formatManifest(manifest) {
  const oneLine = (/** @type {string} */ inner) => inner.replace(/\s+/g, ' ');
  const text = JSON.stringify(manifest, null, 2)
    .replace(/\[\s+([^[\]{}]+?)\s+\]/g, (_, list) => `[${oneLine(list)}]`)
    .replace(/\{\n {4,}([^{}]+?)\s+\}/g, (_, fields) => `{ ${oneLine(fields)} }`);
  return `${text}\n`;
}

/**
 * What files are called that are made of one: its name, and the quantity's, of which the file itself says what it is. Nothing
 * in that can lead to another folder, or to a hidden file.
 * @param {string} path - of the radar file
 * @param {string} moment
 */
export function nameMosaic(path, moment) {
  const word = (/** @type {string} */ text) => text.replace(/[^\p{L}\p{N}._-]+/gu, '_').replace(/^\.+/, '_').slice(0, 100);
  return `${word(basename(path).replace(/(\.(gz|hdf5?|h5|nc4?)){1,9}$/i, ''))}-${word(moment)}`;
}

async function main() {
  const { values, positionals } = parseArgs({ allowPositionals: true, options: { moment: { type: 'string' }, out: { type: 'string' } } });
  const [path] = positionals;
  if (positionals.length !== 1) throw new Error(`got ${positionals.length} files; expected one\n${usage}`);
  const { makeRadarMosaic } = await loadTool();
  const bytes = new Uint8Array(readFileSync(path));
  const { png, manifest, rounding, partial } = await makeRadarMosaic(bytes, basename(path), values.moment);
  const out = values.out ?? nameMosaic(path, manifest.moment ?? '');
  writeFileSync(`${out}.png`, png);
  writeFileSync(`${out}.json`, formatManifest({ image: `${basename(out)}.png`, ...manifest }));
  const exact = rounding === 0 ? 'values exactly as in the file' : `values within ${rounding.toPrecision(2)} ${manifest.unit ?? ''}`;
  console.log(`${out}.png and ${out}.json: ${manifest.slices} sweeps of ${inspect(manifest.moment)}, ${png.length} bytes, ${exact}`);
  if (partial) console.error(`not all: ${partial}`);
}

// npm starts programs by links.
if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  await main().catch((error) => {
    console.error(error instanceof Error ? error.message : String(error));
    process.exitCode = 1;
  });
}
