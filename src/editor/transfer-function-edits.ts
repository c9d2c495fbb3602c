// What an editor does to a transfer function. Each edit makes new stops and leaves the old ones as they are.
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Color, Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';

/** Between what values a stop may stand: its neighbours' (which it may reach: two stops of one value make a jump). */
export function stopBounds(stops: TransferFunction, index: number): [number, number] {
  return [stops[index - 1]?.value ?? -Infinity, stops[index + 1]?.value ?? Infinity];
}

/** Change one stop; a value goes no further than its neighbours, an opacity stays between 0 and 1. No change: the same stops. */
export function changeStop(stops: TransferFunction, index: number, change: Partial<Stop>): TransferFunction {
  const { value, opacity, color } = { ...stops[index], ...change };
  const [least, most] = stopBounds(stops, index);
  const changed = { value: clamp(value, least, most), opacity: clamp(opacity, 0, 1), color };
  const old = stops[index];
  if (changed.value === old.value && changed.opacity === old.opacity && String(color) === String(old.color)) return stops;
  return [...stops.slice(0, index), changed, ...stops.slice(index + 1)];
}

/**
 * Put in a stop of the colour that is there now.
 * @returns the stops and the index of the new one
 */
export function addStop(stops: TransferFunction, value: number, opacity: number): { stops: TransferFunction; index: number } {
  const above = stops.findIndex((stop) => stop.value > value);
  const index = above < 0 ? stops.length : above;
  const added = { value, opacity: clamp(opacity, 0, 1), color: colorAt(stops, value) };
  return { stops: [...stops.slice(0, index), added, ...stops.slice(index)], index };
}

/** Put in a stop half-way from one stop to the next, or, after the last, to the one before; on the curve as it is. */
export function addStopBeside(stops: TransferFunction, index: number, domain: readonly [number, number]): { stops: TransferFunction; index: number } {
  const from = stops[index].value;
  const to = stops[index + 1]?.value ?? stops[index - 1]?.value ?? (from < domain[1] ? domain[1] : domain[0]);
  const value = (from + to) / 2;
  return addStop(stops, value, evaluate(stops, value)[3]);
}

/** Take one stop out. The last one stays: a transfer function has at least one. */
export function removeStop(stops: TransferFunction, index: number): TransferFunction {
  return stops.length > 1 ? stops.filter((_, i) => i !== index) : stops;
}

/** The colour at a value, also where it is transparent. */
export function colorAt(stops: TransferFunction, value: number): Color {
  const [red, green, blue, alpha] = evaluate(stops, value);
  if (alpha > 0) return [red / alpha, green / alpha, blue / alpha];
  const opaque = stops.map((stop) => ({ ...stop, opacity: 1 }));
  const [r, g, b] = evaluate(opaque, value);
  return [r, g, b];
}

/**
 * Fewer stops that draw the same curve, so that a hand can hold it: stops that lie on the line between others go, and,
 * while there are more than a number, those that lie near it.
 * @param most - how many may stay
 * Source: Douglas and Peucker 1973, with the largest difference of a premultiplied channel as the distance
 */
export function simplifyStops(all: TransferFunction, most: number): TransferFunction {
  if (all.length <= most) return all;
  const stops = thinStops(all, mostLookedAt);
  for (let tolerance = 0.25 / 255; ; tolerance *= 1.5) {
    const kept = [stops[0], ...keepBetween(stops, tolerance), stops[stops.length - 1]];
    if (kept.length <= most || tolerance > 1) return kept;
  }
}

/** Stops of which each counts. Labels have tens of thousands. */
const mostLookedAt = 4096;

/** So many stops at most, evenly picked, with the first and the last one: what a scale of some hundred pixels can show of labels. */
export function thinStops(stops: TransferFunction, most: number): TransferFunction {
  const apart = Math.ceil(stops.length / most);
  return apart === 1 ? stops : stops.filter((_, i) => i % apart === 0 || i === stops.length - 1);
}

/** The stops between the first and the last one that are needed to stay within a tolerance. */
function keepBetween(stops: TransferFunction, tolerance: number): Stop[] {
  const ends = [stops[0], stops[stops.length - 1]];
  let worst = 0;
  let at = 0;
  for (let i = 1; i < stops.length - 1; i++) {
    const distance = distanceToLine(stops[i], ends);
    if (distance > worst) [worst, at] = [distance, i];
  }
  if (worst <= tolerance) return [];
  return [...keepBetween(stops.slice(0, at + 1), tolerance), stops[at], ...keepBetween(stops.slice(at), tolerance)];
}

/** A hundredth of the colour counts as well, or a colour that changes unseen would be lost. */
function distanceToLine({ value, color, opacity }: Stop, ends: TransferFunction): number {
  const onLine = evaluate(ends, value);
  const straight = colorAt(ends, value);
  const differences = color.map((channel, i) => Math.max(Math.abs(channel * opacity - onLine[i]), Math.abs(channel - straight[i]) / 100));
  return Math.max(Math.abs(opacity - onLine[3]), ...differences);
}

function clamp(value: number, least: number, most: number): number {
  return Math.min(most, Math.max(least, value));
}
