// Where the points of a curve lie, and the numbers on its axes.
import { readScanTime } from '../../src/core/scan-time.ts';

/** A number on an axis, and its share of the length, 0..1. */
export interface Tick {
  readonly at: number;
  readonly value: number;
}

/** The axis of time: the place of each scan, 0..1, and its numbers; ticks are null where scans have no times that can be counted. */
export interface TimeAxis {
  readonly at: readonly number[];
  readonly ticks: { readonly unit: string; readonly all: readonly Tick[] } | null;
}

/**
 * Scans lie at their times where all times are known, of one unit, and one after the other; else at equal steps.
 * @param times - as a view has them
 */
export function placeTimes(times: readonly (string | null)[], maxTicks = 5): TimeAxis {
  const read = times.map((time) => (time === null ? null : readScanTime(time)));
  const [first] = read;
  const last = read.at(-1);
  const isCounted =
    first && last && read.every((time, i) => time?.unit === first.unit && (i === 0 || time.value > read[i - 1]!.value));
  if (!isCounted) return { at: times.map((_, i) => (times.length > 1 ? i / (times.length - 1) : 0)), ticks: null };
  const span = last.value - first.value || 1;
  const share = (value: number): number => (value - first.value) / span;
  return {
    at: read.map((time) => share(time!.value)),
    ticks:
      first.unit === 'UTC'
        ? null
        : {
            unit: first.unit,
            all: roundNumbers(first.value, last.value, maxTicks).map((value) => ({ value, at: share(value) })),
          },
  };
}

/** The axis of values: from a round number below all of them to one above. */
export interface ValueAxis {
  readonly low: number;
  readonly high: number;
  readonly ticks: readonly Tick[];
  /** Decimals that distinguish the ticks. */
  readonly decimals: number;
}

/** @param values - NaN and undefined are left out @returns null where there is none */
export function scaleValues(values: readonly (number | undefined)[], maxTicks = 4): ValueAxis | null {
  let [min, max] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === undefined || !Number.isFinite(value)) continue;
    min = Math.min(min, value);
    max = Math.max(max, value);
  }
  if (min > max) return null;
  // A flat curve lies in the middle.
  const room = max > min ? 0 : Math.abs(max) / 10 || 1;
  const step = roundStep(min - room, max + room, maxTicks - 1);
  const [low, high] = [Math.floor((min - room) / step) * step, Math.ceil((max + room) / step) * step];
  const count = Math.round((high - low) / step);
  const ticks = Array.from({ length: count + 1 }, (_, i) => ({ at: i / count, value: low + i * step }));
  return { low, high, ticks, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

/** Round numbers from `low` to `high`, at most so many. */
function roundNumbers(low: number, high: number, most: number): number[] {
  const step = roundStep(low, high, most - 1);
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** 1, 2 or 5 times a power of ten, so that at most so many steps lie between two numbers. */
function roundStep(low: number, high: number, most: number): number {
  const least = (high - low) / most || 1;
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((digit) => digit * power).find((step) => step >= least * (1 - 1e-9))!;
}

/**
 * The path of the curve in a square of 1: it ends where a value is missing, and begins again after that. A value between two that are
 * missing is a line of no length, which is drawn as a point.
 * @param at - places of the scans, 0..1
 */
export function drawCurve(
  at: readonly number[],
  values: readonly (number | undefined)[],
  { low, high }: Pick<ValueAxis, 'low' | 'high'>,
): string {
  const isThere = (i: number): boolean => Number.isFinite(values[i]);
  return values
    .map((value, i) => {
      if (!isThere(i)) return '';
      const place = `${short(at[i])} ${short(1 - (value! - low) / (high - low))}`;
      if (isThere(i - 1)) return `L${place}`;
      return isThere(i + 1) ? `M${place}` : `M${place}h0`;
    })
    .join('');
}

/** The path of all points of the curve, each a line of no length. */
export function drawPoints(
  at: readonly number[],
  values: readonly (number | undefined)[],
  { low, high }: Pick<ValueAxis, 'low' | 'high'>,
): string {
  return values
    .map((value, i) => (Number.isFinite(value) ? `M${short(at[i])} ${short(1 - (value! - low) / (high - low))}h0` : ''))
    .join('');
}

const short = (share: number): number => Number(share.toFixed(5));

/** The scan whose place is nearest to a share of the length. */
export function nearestScan(at: readonly number[], share: number): number {
  return at.reduce((best, place, i) => (Math.abs(place - share) < Math.abs(at[best] - share) ? i : best), 0);
}
