// `npm run color-tables` writes src/optics/transfer/color-table-values.ts from d3-scale-chromatic, so that the package does not depend on
// it. `--check` only checks whether the file is up to date.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as chromatic from 'd3-scale-chromatic';
import { projectRoot } from './shared-data.mjs';

/** With this number, straight lines between the stops differ from the table by less than 1/255. */
const stops = 64;

const tables = {
  viridis: chromatic.interpolateViridis,
  inferno: chromatic.interpolateInferno,
  magma: chromatic.interpolateMagma,
  plasma: chromatic.interpolatePlasma,
  cividis: chromatic.interpolateCividis,
  turbo: chromatic.interpolateTurbo,
};

/** @param {string} color - #rrggbb, or rgb(r, g, b) */
function toHex(color) {
  if (color.startsWith('#')) return color.slice(1);
  return (color.match(/\d+/g) ?? []).map((channel) => Number(channel).toString(16).padStart(2, '0')).join('');
}

/** @param {(t: number) => string} interpolate */
const listColors = (interpolate) => Array.from({ length: stops + 1 }, (_, i) => toHex(interpolate(i / stops))).join('');

const text = `// Written by scripts/make-color-tables.mjs from d3-scale-chromatic 3 (see CREDITS.md): change it there.

/** Colours at even distances over a window, six hexadecimal digits each, sRGB. */
export const colorTableValues = {
${Object.entries(tables)
  .map(([name, interpolate]) => `  ${name}:\n    '${listColors(interpolate)}',`)
  .join('\n')}
} as const;
`;

const file = join(projectRoot, 'src/optics/transfer/color-table-values.ts');
if (!process.argv.includes('--check')) {
  writeFileSync(file, text);
} else if (readFileSync(file, 'utf8') !== text) {
  console.error(
    'src/optics/transfer/color-table-values.ts is not what d3-scale-chromatic gives; run: npm run color-tables',
  );
  process.exitCode = 1;
}
