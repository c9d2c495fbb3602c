import { VolumeViewError } from '../errors.ts';
import { parseTransferFunction } from './parse-transfer-function.ts';
import type { TransferFunction } from './transfer-function.ts';

/**
 * Presets as the stops that an author would write. CT ones speak Hounsfield units and need no window, `radar-dbz`
 * speaks dBZ, `gray` and `mri` span the window. Their opacities hold per reference length, 1 % of the longest edge.
 */
const written: Readonly<Record<string, string>> = {
  gray: '0% black 0, 30% #4a4a4a 0.5%, 60% #a8a8a8 2.5%, 100% white 14%',
  mri: '0% #120608 0, 18% #3a1210 0.3%, 35% #6f2a20 2.5%, 52% #b06a4c 6%, 70% #e2b58c 12%, 88% #fff1da 22%, 100% white 30%',
  // Soft tissue up to 120 HU is out; spongy bone from 150, compact bone above 600.
  'ct-bone': '110 #5e2416 0, 180 #96482c 1.2%, 300 #d9a066 8%, 550 #f0d9b5 30%, 1000 #fffaf0 60%, 2000 white 85%',
  // Skin and fat as a veil around muscle and organs, bone as a hint of white.
  'ct-soft-tissue': '-220 #f2c9a8 0, -120 #f0c8a0 0.8%, -60 #e8b088 1%, 0 #c96f57 2.2%, 60 #b23a3a 6%, 140 #d98b70 7%, 300 #f5e3cf 14%, 1200 white 30%',
  // Vessels filled with contrast medium, 150 to 450 HU, in red; bone pale and thin, so that it does not hide them.
  'ct-angio': '90 #40080a 0, 140 #8c1016 1.5%, 200 #d8201c 16%, 340 #ff6a3c 30%, 460 #f7c9a0 14%, 700 #f2e8da 9%, 1500 white 14%',
  // Lung tissue around -850, its vessels and airways' walls up to -400, the body as a faint shell.
  'ct-lung': '-1000 #0b1030 0, -950 #15306b 0, -880 #2f6fb5 0.9%, -780 #6fb6df 2.2%, -600 #dfe9f2 5%, -420 #ff9d7a 8%, -250 #e8a58c 1.2%, -50 #e0b8a0 0.4%, 200 #fff 0.9%, 1000 #fff 6%',
  // The scale of the US National Weather Service, 5 to 75 dBZ.
  'radar-dbz':
    '3 #04e9e7 0, 7 #04e9e7 0.6%, 10 #019ff4 0.9%, 15 #0300f4 1.3%, 20 #02fd02 2%, 25 #01c501 3%, 30 #008e00 4.5%, 35 #fdf802 8%, ' +
    '40 #e5bc00 12%, 45 #fd9500 18%, 50 #fd0000 30%, 55 #d40000 40%, 60 #bc0000 55%, 65 #f800fd 70%, 70 #9854c6 80%, 75 #fdfdfd 90%',
};

/** Presets that paint a colour table over the window; the tables come from d3-scale-chromatic when one is used. */
const colorTables = ['viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'] as const;

/** Names that `transfer-function` takes. */
export const presetNames: readonly string[] = [...Object.keys(written), ...colorTables];

/** What is shown where the author says nothing: the window is the histogram's, so the air is out and the subject in. */
export const defaultPreset = 'mri';

/**
 * A transfer function from an attribute: a preset's name, or stops.
 * @param window - data values that presets and percentages span
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function resolveTransferFunction(
  text: string,
  window: readonly [number, number],
): Promise<TransferFunction> {
  const name = text.trim().toLowerCase();
  if (Object.hasOwn(written, name)) return parseTransferFunction(written[name], window);
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

export type ColorTable = (typeof colorTables)[number];
