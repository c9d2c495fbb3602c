import {
  interpolateCividis,
  interpolateInferno,
  interpolateMagma,
  interpolatePlasma,
  interpolateTurbo,
  interpolateViridis,
} from 'd3-scale-chromatic';
import { parseCssColor } from './css-color.ts';
import type { colorTables } from './preset-names.ts';
import type { TransferFunction } from './transfer-function.ts';

type ColorTable = (typeof colorTables)[number];

const interpolators = {
  viridis: interpolateViridis,
  inferno: interpolateInferno,
  magma: interpolateMagma,
  plasma: interpolatePlasma,
  cividis: interpolateCividis,
  turbo: interpolateTurbo,
} satisfies Record<ColorTable, (t: number) => string>;

/** Enough that straight lines between the stops differ from the table by less than 1/255. */
const stops = 64;

/** Opacity per reference length at the top of the window; it rises with the square, so that low values are a veil. */
const topOpacity = 0.2;

/** A colour table over a window, low values transparent. */
export function colorTableStops(name: ColorTable, [low, high]: readonly [number, number]): TransferFunction {
  return Array.from({ length: stops + 1 }, (_, i) => {
    const t = i / stops;
    const { color } = parseCssColor(interpolators[name](t))!;
    return { value: low + (high - low) * t, color, opacity: topOpacity * t * t };
  });
}
