// The two axes of the editor's chart: data values across, opacity upwards.
import { roundStep, roundTo } from './ticks.ts';
import { spanAround } from '../optics/transfer/span-around.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import type { Histogram } from '../volume/histogram.ts';

/** Share of the values that may lie beyond each end of the chart: a few stray voxels would squeeze all others. */
const stray = 0.0002;

/**
 * Height of an opacity in the chart, both 0..1. Useful opacities are a few per cent per reference length, so they get
 * more room than a linear scale gives: the height is the cube root.
 */
export function toHeight(opacity: number): number {
  return Math.cbrt(opacity);
}

/** Lower heights mean opacity 0. */
export const lowestHeight = 0.03;

/** The opacity at a height, to three digits; near the bottom it is 0, which is what people aim at there. */
export function toOpacity(height: number): number {
  const clamped = Math.min(1, Math.max(0, height));
  return clamped < lowestHeight ? 0 : Number((clamped ** 3).toPrecision(3));
}

/** Opacities at which the chart has lines. */
export const opacityTicks: readonly number[] = [0.001, 0.01, 0.05, 0.2, 0.5, 1];

/** The values that the chart spans: the window, all stops, and all data except a few strays. */
export function chooseDomain(
  { low, high, counts }: Histogram,
  { transferFunction: stops, window }: { transferFunction: TransferFunction; window: readonly [number, number] },
): [number, number] {
  const total = counts.reduce((sum, count) => sum + count, 0);
  const binWidth = (high - low) / counts.length;
  const first = findShare(counts, total * stray);
  const last = findShare(counts, total * (1 - stray)) + 1;
  const ends = [
    low + first * binWidth,
    low + last * binWidth,
    ...window,
    stops[0].value,
    stops[stops.length - 1].value,
  ];
  const domain: [number, number] = [Math.min(...ends), Math.max(...ends)];
  return domain[1] > domain[0] ? domain : spanAround(domain[0]);
}

/** The first bin at which the counts reach a share of all counts. Empty bins are skipped. */
function findShare(counts: Uint32Array, share: number): number {
  let sum = 0;
  return counts.findIndex((count) => count > 0 && (sum += count) >= share);
}

/**
 * The step to which a stop's value is rounded when it is dragged: a round number, a five-hundredth of the chart or
 * less.
 */
export function dragStep([low, high]: readonly [number, number]): number {
  return roundStep((high - low) / 1000);
}

/** The position of a value in the chart, 0..1. */
export function toShare(value: number, [low, high]: readonly [number, number]): number {
  const whole = high - low;
  return Number.isFinite(whole) ? (value - low) / whole : (value / 2 - low / 2) / (high / 2 - low / 2);
}

/** The value at a position of the chart, rounded for dragging; exact at the ends. */
export function toValue(share: number, domain: readonly [number, number]): number {
  const [low, high] = domain;
  if (share <= 0) return low;
  if (share >= 1) return high;
  const value = roundTo(low + (high - low) * share, dragStep(domain));
  return Math.min(high, Math.max(low, value));
}
