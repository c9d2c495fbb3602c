#!/usr/bin/env node
// The program. It makes a radar file into an image with a manifest, and any file into a page that contains it.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { inspect, parseArgs } from 'node:util';
import { makeRadarMosaic } from '../../../src/prepare/radar-mosaic.ts';
import { formatManifest } from './format-manifest.ts';
import { nameFiles } from './name-files.ts';
import { maxPageBytes, writePage } from './write-page.ts';

const usage = `volume-view-prepare FILE [--as mosaic] [--moment NAME] [--out NAME]
    one quantity of a radar file (ODIM_H5, CfRadial, NEXRAD Level II) as NAME.png and its manifest NAME.json
volume-view-prepare FILE --as page [--alt TEXT] [--out NAME]
    a page NAME.html with the file inside, which works from disk beside volume-view.iife.js`;

/** The error for wrong arguments. */
class Misuse extends Error {}

async function writeMosaic(path: string, moment: string | undefined, out: string | undefined): Promise<void> {
  const { png, manifest, rounding, partial } = await makeRadarMosaic(
    new Uint8Array(readFileSync(path)),
    basename(path),
    moment,
  );
  const name = out ?? nameFiles(path, manifest.moment ?? '');
  writeFileSync(`${name}.png`, png);
  writeFileSync(`${name}.json`, formatManifest({ image: `${basename(name)}.png`, ...manifest }));
  const exact =
    rounding === 0
      ? 'values exactly as in the file'
      : `values within ${rounding.toPrecision(2)} ${manifest.unit ?? ''}`;
  console.log(
    `${name}.png and ${name}.json: ${manifest.slices} sweeps of ${inspect(manifest.moment)}, ${png.length} bytes, ${exact}`,
  );
  if (partial) console.error(`not all: ${partial}`);
}

function writeVolumePage(path: string, alt: string | undefined, out: string | undefined): void {
  const { size } = statSync(path);
  if (size > maxPageBytes)
    throw new RangeError(
      `${basename(path)} has ${Math.round(size / 2 ** 20)} MiB; expected at most ${maxPageBytes / 2 ** 20}: put it on a web server`,
    );
  const name = `${out ?? nameFiles(path)}.html`;
  writeFileSync(name, writePage(readFileSync(path), alt ?? basename(path)));
  console.log(`${name}: put volume-view.iife.js of the package volume-view next to it, and open it`);
}

async function main(): Promise<void> {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      as: { type: 'string', default: 'mosaic' },
      moment: { type: 'string' },
      alt: { type: 'string' },
      out: { type: 'string' },
      help: { type: 'boolean', short: 'h' },
    },
  });
  if (values.help) return console.log(usage);
  const [path] = positionals;
  if (positionals.length !== 1) throw new Misuse(`got ${positionals.length} files; expected one`);
  if (values.as === 'mosaic') return writeMosaic(path, values.moment, values.out);
  if (values.as === 'page') return writeVolumePage(path, values.alt, values.out);
  throw new Misuse(`got --as ${values.as}; expected mosaic or page`);
}

await main().catch((error: unknown) => {
  console.error(error instanceof Error ? error.message : String(error));
  if (error instanceof Misuse) console.error(usage);
  process.exitCode = 1;
});
