// The edits of a transfer function. Each edit makes new stops and leaves the old ones unchanged.
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Color, Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';

/** The values between which a stop may move: its neighbours' (which it may reach: two stops of one value make a jump). */
export function stopBounds(stops: TransferFunction, index: number): [number, number] {
  return [stops[index - 1]?.value ?? -Infinity, stops[index + 1]?.value ?? Infinity];
}

/**
 * Changes one stop; its value stays between its neighbours', its opacity between 0 and 1. If nothing changes, it
 * returns the same stops.
 */
export function changeStop(stops: TransferFunction, index: number, change: Partial<Stop>): TransferFunction {
  const { value, opacity, color } = { ...stops[index], ...change };
  const [min, max] = stopBounds(stops, index);
  const changed = { value: clamp(value, min, max), opacity: clamp(opacity, 0, 1), color };
  const old = stops[index];
  if (changed.value === old.value && changed.opacity === old.opacity && String(color) === String(old.color))
    return stops;
  return [...stops.slice(0, index), changed, ...stops.slice(index + 1)];
}

/**
 * Adds a stop with the present colour at a value.
 * @returns the stops and the index of the new one
 */
export function addStop(
  stops: TransferFunction,
  value: number,
  opacity: number,
): { stops: TransferFunction; index: number } {
  const above = stops.findIndex((stop) => stop.value > value);
  const index = above < 0 ? stops.length : above;
  const added = { value, opacity: clamp(opacity, 0, 1), color: colorAt(stops, value) };
  return { stops: [...stops.slice(0, index), added, ...stops.slice(index)], index };
}

/** Adds a stop on the present curve, half way from one stop to the next, or for the last one half way to the one before. */
export function addStopBeside(
  stops: TransferFunction,
  index: number,
  domain: readonly [number, number],
): { stops: TransferFunction; index: number } {
  const from = stops[index].value;
  const to = stops[index + 1]?.value ?? stops[index - 1]?.value ?? (from < domain[1] ? domain[1] : domain[0]);
  const value = (from + to) / 2;
  return addStop(stops, value, evaluate(stops, value)[3]);
}

/** Removes one stop. The last one stays: a transfer function has at least one. */
export function removeStop(stops: TransferFunction, index: number): TransferFunction {
  return stops.length > 1 ? stops.filter((_, i) => i !== index) : stops;
}

/** The colour at a value, even if it is transparent there. */
export function colorAt(stops: TransferFunction, value: number): Color {
  const [red, green, blue, alpha] = evaluate(stops, value);
  if (alpha > 0) return [red / alpha, green / alpha, blue / alpha];
  const opaque = stops.map((stop) => ({ ...stop, opacity: 1 }));
  const [r, g, b] = evaluate(opaque, value);
  return [r, g, b];
}

/**
 * Simplifies stops so that they can be edited by hand: removes stops that lie on the line between others and, while
 * there are more than a maximum, those that lie near it.
 * @param maxCount - maximum number of stops
 * Source: Douglas and Peucker 1973, with the largest difference of a premultiplied channel as the distance
 */
export function simplifyStops(all: TransferFunction, maxCount: number): TransferFunction {
  if (all.length <= maxCount) return all;
  const stops = thinStops(all, maxExamined);
  for (let tolerance = 0.25 / 255; ; tolerance *= 1.5) {
    const kept = [stops[0], ...keepBetween(stops, tolerance), stops[stops.length - 1]];
    if (kept.length <= maxCount || tolerance > 1) return kept;
  }
}

/** Maximum number of stops that are examined one by one. Labels have tens of thousands. */
const maxExamined = 4096;

/**
 * At most so many stops, evenly chosen, with the first and the last one: enough for labels on a scale of some hundred
 * pixels.
 */
export function thinStops(stops: TransferFunction, maxCount: number): TransferFunction {
  const apart = Math.ceil(stops.length / maxCount);
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

/** A hundredth of the straight colour counts too. Else a colour that changes where it is transparent would be lost. */
function distanceToLine({ value, color, opacity }: Stop, ends: TransferFunction): number {
  const onLine = evaluate(ends, value);
  const straight = colorAt(ends, value);
  const differences = color.map((channel, i) =>
    Math.max(Math.abs(channel * opacity - onLine[i]), Math.abs(channel - straight[i]) / 100),
  );
  return Math.max(Math.abs(opacity - onLine[3]), ...differences);
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, value));
}
