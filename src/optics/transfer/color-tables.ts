import { colorTableValues } from './color-table-values.ts';
import type { colorTables } from './preset-names.ts';
import type { Color, TransferFunction } from './transfer-function.ts';

type ColorTable = (typeof colorTables)[number];

/** Opacity per reference length at the top of the window. It rises with the square, so low values are a thin veil. */
const topOpacity = 0.2;

/** A colour table over a window; low values are transparent. */
export function colorTableStops(name: ColorTable, [low, high]: readonly [number, number]): TransferFunction {
  const values: Record<ColorTable, string> = colorTableValues;
  const colors = values[name].match(/.{6}/g)!;
  return colors.map((digits, i) => {
    const t = i / (colors.length - 1);
    return { value: low + (high - low) * t, color: readColor(digits), opacity: topOpacity * t * t };
  });
}

/** @param digits - rrggbb */
function readColor(digits: string): Color {
  const [r, g, b] = [0, 2, 4].map((at) => parseInt(digits.slice(at, at + 2), 16) / 255);
  return [r, g, b];
}
