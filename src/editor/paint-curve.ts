// Draws a transfer function as paths, in boxes that may be stretched.
import type { Color, Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { toHeight, toShare } from './transfer-function-axes.ts';

/** A transfer function at one point of a scale. */
export interface PaintPoint {
  /** 0..1 along the scale. */
  readonly share: number;
  /** Straight alpha, as on an opaque ground. */
  readonly color: Color;
  readonly opacity: number;
}

/**
 * Number of straight pieces between two stops: colours are interpolated premultiplied and heights are roots, so both
 * are curved.
 */
const pieces = 16;

/**
 * Points that draw a transfer function with straight lines; two at one value where it jumps.
 * @param domain - at least as wide as the stops
 */
export function paintStops(stops: TransferFunction, domain: readonly [number, number]): PaintPoint[] {
  const toPoint = ({ value, color, opacity }: Stop): PaintPoint => ({ share: toShare(value, domain), color, opacity });
  const last = stops[stops.length - 1];
  const between = stops.slice(1).flatMap((to, i) => cutSegment(stops[i], to));
  return [{ ...stops[0], value: domain[0] }, ...between, last, { ...last, value: domain[1] }].map(toPoint);
}

/** Points from one stop to just before the next, and the next one too if its colour differs. */
function cutSegment(from: Stop, to: Stop): Stop[] {
  const even = from.opacity === to.opacity && from.color.every((channel, i) => channel === to.color[i]);
  const count = even || from.value === to.value ? 1 : pieces;
  return Array.from({ length: count + 1 }, (_, i) => mixStops(from, to, i / count));
}

function mixStops(from: Stop, to: Stop, t: number): Stop {
  const mix = (a: number, b: number) => a + (b - a) * t;
  const opacity = mix(from.opacity, to.opacity);
  const mixColor = (a: number, b: number) =>
    opacity > 0 ? mix(a * from.opacity, b * to.opacity) / opacity : mix(a, b);
  const [red, green, blue] = from.color.map((channel, i) => mixColor(channel, to.color[i]));
  return { value: mix(from.value, to.value), color: [red, green, blue], opacity };
}

/** Sides of the boxes in which paths are drawn. */
export const boxLength = 1000;
export const boxHeight = 100;

/**
 * The curve's points as a path, from left to right; if it is upright, from the bottom up, with heights to the right.
 * @returns path data in a box of boxLength x boxHeight, or with the two exchanged
 */
export function drawCurve(points: readonly PaintPoint[], upright = false): string {
  const place = ({ share, opacity }: PaintPoint) => {
    const along = share * boxLength;
    const height = toHeight(opacity) * boxHeight;
    return upright
      ? `${height.toFixed(2)} ${(boxLength - along).toFixed(2)}`
      : `${along.toFixed(2)} ${(boxHeight - height).toFixed(2)}`;
  };
  return `M${points.map(place).join('L')}`;
}

/** The area under the curve. */
export function drawArea(points: readonly PaintPoint[], upright = false): string {
  const foot = upright ? `L0 0V${boxLength}Z` : `L${boxLength} ${boxHeight}H0Z`;
  return drawCurve(points, upright) + foot;
}
