import { VolumeViewError } from '../../core/errors.ts';
import { parseTransferFunction } from './parse-transfer-function.ts';
import { colorTables, presetNames } from './preset-names.ts';
import type { writtenPresets } from './preset-names.ts';
import type { TransferFunction } from './transfer-function.ts';

/**
 * Presets as stops that an author could write. CT presets use Hounsfield units and need no window, `radar-dbz`
 * uses dBZ, and the others span the window. Opacities are per reference length, usually 1 % of the longest edge.
 */
const written: Readonly<Record<(typeof writtenPresets)[number], string>> = {
  // Dark tissue dims what lies behind it, so that furrows stay dark and folds stand out.
  gray: '0% black 0, 18% #101010 2%, 40% #4c4c4c 3.5%, 65% #a4a4a4 6%, 100% white 13%',
  // Soft tissue up to 140 HU is left out; spongy bone lies above it, compact bone from 600. Thin enough to show the depth of a skull.
  'ct-bone': '140 #3c140a 0, 210 #7a3c22 5%, 300 #c58a5a 12%, 480 #e9cda0 18%, 800 #faf0dc 24%, 1800 white 40%',
  // Skin and fat as a thin veil, muscle and brain red, organs with contrast medium brighter, bone more transparent than these.
  'ct-soft-tissue':
    '-250 #f0c9a0 0, -150 #f0c9a0 0.6%, -60 #eab98a 0.8%, -10 #c46a52 1%, 40 #a8322e 3.2%, 80 #b8463c 4%, 115 #d9826a 9%, 200 #f0c08e 10%, 320 #f7e3c4 5%, 700 #fff6e6 5%, 1600 white 9%',
  // Vessels filled with contrast medium, 200 to 450 HU, in red. Compact bone is pale and thin, so that it does not hide them.
  // Spongy bone has the same values as these vessels, so it is red, too.
  'ct-angio':
    '150 #4a080e 0, 210 #94141a 3%, 280 #d8201c 10%, 350 #ff5a34 28%, 430 #f9b080 9%, 540 #efe2cc 4%, 1000 #f2ead9 5%, 1600 white 7%',
  // Lung tissue around -850 in blue, its vessels and airways' walls up to -400 in orange, the body as a faint shell.
  'ct-lung':
    '-1000 #0a1a3a 0, -960 #123a7a 0, -900 #2f7fc4 1%, -820 #6fc0e8 2%, -700 #cfeaf5 5%, -560 #ffe0c8 7%, -430 #ff9d7a 7%, -320 #e88e74 1.2%, -200 #d8b0a0 0.15%, 100 #d8c8c0 0.15%, 250 #fff 0.7%, 1000 #fff 3%',
  // The scale of the US National Weather Service, 5 to 75 dBZ.
  'radar-dbz':
    '3 #04e9e7 0, 6 #04e9e7 1.5%, 10 #019ff4 2.5%, 15 #0300f4 3%, 20 #02fd02 4%, 25 #01c501 6%, 30 #008e00 8%, 35 #fdf802 13%, ' +
    '40 #e5bc00 18%, 45 #fd9500 25%, 50 #fd0000 36%, 55 #d40000 46%, 60 #bc0000 58%, 65 #f800fd 70%, 70 #9854c6 80%, 75 #fdfdfd 90%',
  // Green towards the radar, red away from it, as in meteorology. No motion is gray and thin. It is no brighter than slow
  // motion, so that it does not appear as a bright line when only the colour is used.
  'radar-velocity':
    '0% #a8ffd0 24%, 12% #2ee58a 18%, 30% #0a9a52 10%, 46% #2c6a4c 4%, 50% #545454 1.5%, 54% #7a3a36 4%, 70% #c4201c 10%, 88% #ff5a3c 18%, 100% #ffd0b8 24%',
  // For maps of both signs, such as t values: blue below 0, red to yellow above. Values near 0 are a thin veil that shows where the map is.
  diverging:
    '0% #c8f4ff 36%, 14% #4fb4f0 22%, 26% #2468c8 11%, 35% #1c3f8c 4%, 41% #30406e 0.3%, 47% #6a6a72 0, 53% #6a6a72 0, 59% #6e3a30 0.3%, 65% #94281c 4%, 74% #d8481c 11%, 86% #f89a2c 22%, 100% #fff2a8 36%',
};

/**
 * Reads a transfer function from an attribute: the name of a preset other than the default, or stops.
 * @param window - the data values that presets and percentages span
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function readTransferFunction(text: string, window: readonly [number, number]): Promise<TransferFunction> {
  const name = text.trim().toLowerCase();
  if (isWritten(name)) return parseTransferFunction(written[name], window);
  const table = colorTables.find((known) => known === name);
  if (table) {
    const { colorTableStops } = await import('./color-tables.ts');
    return colorTableStops(table, window);
  }
  if (/^[a-z][a-z0-9-]*$/.test(name)) {
    throw new VolumeViewError(
      'transfer-function/syntax',
      `transfer-function got "${name.slice(0, 60)}"; expected stops like "0 black 0, 100 white 5%" or one of ${presetNames.join(', ')}.`,
    );
  }
  return parseTransferFunction(text, window);
}

function isWritten(name: string): name is keyof typeof written {
  return Object.hasOwn(written, name);
}
