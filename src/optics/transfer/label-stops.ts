// Transfer functions of label volumes. This file is loaded with the first volume whose samples are places in a list of ids.
import { labelColors } from '../../volume/label-colors.ts';
import type { NamedLabel } from '../../volume/labels.ts';
import { evaluate } from './transfer-function.ts';
import type { Color, Stop, TransferFunction } from './transfer-function.ts';

/** Opacity of a label in a volume that is labels itself. */
export const labelOpacity = 0.22;

/** Below this, a double can hold halves. */
const hasHalves = 2 ** 51;

/** The appearance of one label. */
export interface LabelAppearance {
  readonly id: number;
  readonly color: Color;
  readonly opacity: number;
}

/** A colour of the palette, by the number of a label. */
export function paletteColor(number: number): Color {
  const hex = labelColors[(number + labelColors.length) % labelColors.length];
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255) as unknown as Color;
}

/**
 * The transfer function of labels. Each id has its colour from id - 0.5 (or from id, if a double cannot hold the half) up to where the next
 * label begins. No sample has a value between two labels.
 * @param looks - ascending
 */
export function labelStops(looks: readonly LabelAppearance[]): TransferFunction {
  const beginOf = (id: number): number => (Math.abs(id) < hasHalves ? id - 0.5 : id);
  const stops: Stop[] = [];
  looks.forEach(({ id, color, opacity }, i) => {
    if (i === 0) stops.push({ value: beginOf(id), color, opacity: 0 });
    const next = looks[i + 1]?.id ?? id + 1;
    const end = id < 0 && next > 0 ? 0 : next;
    stops.push({ value: beginOf(id), color, opacity }, { value: beginOf(end), color, opacity });
    if (end < next) stops.push({ value: beginOf(end), color, opacity: 0 }, { value: beginOf(next), color, opacity: 0 });
  });
  return stops;
}

/** The transfer function of labels without settings in the page. @param ids - ascending @param named - names and colours from the file */
export function plainLabelStops(ids: readonly number[], named: readonly NamedLabel[] = []): TransferFunction {
  const colors = new Map(named.map(({ id, color }) => [id, color]));
  return labelStops(
    ids
      .filter((id) => id !== 0)
      .map((id, i) => ({ id, color: colors.get(id) ?? paletteColor(i), opacity: labelOpacity })),
  );
}

const made = new WeakMap<TransferFunction, readonly [ids: readonly number[], stops: TransferFunction]>();

/** Converts a transfer function of ids to one of their places in a list. The result is kept as long as both stay the same. */
export function stopsByPlace(stops: TransferFunction, ids: readonly number[]): TransferFunction {
  const known = made.get(stops);
  if (known?.[0] === ids) return known[1];
  const byPlace: Stop[] = [];
  let last = '';
  ids.forEach((id, place) => {
    const [red, green, blue, opacity] = evaluate(stops, id);
    const color: Color = opacity > 0 ? [red / opacity, green / opacity, blue / opacity] : [0, 0, 0];
    const appearance = [opacity, ...color].join();
    if (place > 0 && appearance === last) byPlace.pop();
    else byPlace.push({ value: place - 0.5, color, opacity });
    byPlace.push({ value: place + 0.5, color, opacity });
    last = appearance;
  });
  made.set(stops, [ids, byPlace]);
  return byPlace;
}
