// Bands as in the paper of 2011: each has one colour and one opacity between two values.
import { invalidAttribute } from '../core/errors.ts';
import { spanAround } from '../optics/transfer/span-around.ts';
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Color, Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { roundTo } from './ticks.ts';
import { colorAt } from './transfer-function-edits.ts';

/** One colour and one opacity for all values from `low` to below `high`. */
export interface Band {
  readonly low: number;
  readonly high: number;
  readonly color: Color;
  /** 0..1 per reference length. */
  readonly opacity: number;
}

/** Maximum number of bands: more do not fit on a screen. */
const maxBands = 64;

/** The number of bands in the paper. */
const defaultBands = 15;

/** The paper's range, dBZ: 15 bands of 5. */
const dbzRange = [-5, 70] as const;

/**
 * The values at which bands end and begin.
 * @param attributes - `bands`, a number of equal ones; `band-edges`, the values themselves, which override `bands`;
 * null if absent
 * @param volume - its unit, and the window, which equal bands divide; a volume in dBZ is divided from -5 to 70
 * @returns ascending, one more than there are bands
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function chooseBandEdges(
  attributes: { bands: string | null; bandEdges: string | null },
  volume: { unit: string; window: readonly [number, number] },
): number[] {
  if (attributes.bandEdges !== null) return parseBandEdges(attributes.bandEdges);
  const count = attributes.bands === null ? defaultBands : parseBandCount(attributes.bands);
  const [from, to] = volume.unit === 'dBZ' ? dbzRange : volume.window;
  // Data that are all the same have no range.
  const [low, high] = to > from ? [from, to] : spanAround(from);
  const width = (high - low) / count;
  const step = 10 ** (Math.floor(Math.log10(width)) - 1); // two digits of a band's width
  return Array.from({ length: count + 1 }, (_, i) => roundTo(low + width * i, step));
}

function parseBandCount(text: string): number {
  const count = /^\s*\d+\s*$/.test(text) ? Number(text) : NaN;
  if (!(count >= 1 && count <= maxBands)) throw invalidAttribute('bands', text, `a whole number from 1 to ${maxBands}`);
  return count;
}

function parseBandEdges(text: string): number[] {
  const edges = text
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const rises = edges.every((edge, i) => Number.isFinite(edge) && (i === 0 || edge > edges[i - 1]));
  if (edges.length < 2 || edges.length > maxBands + 1 || !rises) {
    throw invalidAttribute('band-edges', text, `2 to ${maxBands + 1} rising values, like "0 20 40 60"`);
  }
  return edges;
}

/** The bands nearest to a transfer function: its colour and opacity in the middle of each. */
export function bandsFromStops(stops: TransferFunction, edges: readonly number[]): Band[] {
  return edges.slice(1).map((high, i) => {
    const low = edges[i];
    const middle = (low + high) / 2;
    return { low, high, color: colorAt(stops, middle), opacity: evaluate(stops, middle)[3] };
  });
}

/**
 * Bands as stops, with a jump at every edge. Below the lowest band everything is transparent; above the highest one its
 * colour continues, so that the strongest values do not vanish.
 */
export function stopsFromBands(bands: readonly Band[]): TransferFunction {
  const { low, color } = bands[0];
  const floor: Stop = { value: low, color, opacity: 0 };
  return [
    floor,
    ...bands.flatMap(({ low, high, color, opacity }) => [
      { value: low, color, opacity },
      { value: high, color, opacity },
    ]),
  ];
}
