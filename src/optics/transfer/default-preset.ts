import type { Color, TransferFunction } from './transfer-function.ts';

/** The default. Its window comes from the histogram, so that air is invisible and the subject is visible. */
export const defaultPreset = 'mri';

/**
 * Its stops: percent of the window, colour, percent of opacity per reference length. They are numbers, so that a page
 * without colours of its own does not load the parser.
 */
const stops = [
  [0, 0x1c0a0a, 0],
  [14, 0x33100c, 2.5],
  [32, 0x6e3426, 5],
  [50, 0xb57758, 7],
  [68, 0xe8bd92, 9],
  [86, 0xfff0d8, 14],
  [100, 0xffffff, 18],
] as const;

/** @param window - the data values that it spans */
export function buildDefaultPreset([low, high]: readonly [number, number]): TransferFunction {
  return stops.map(([share, color, opacity]) => ({
    value: low + ((high - low) * share) / 100,
    color: [16, 8, 0].map((bits) => ((color >> bits) & 255) / 255) as unknown as Color,
    opacity: opacity / 100,
  }));
}
