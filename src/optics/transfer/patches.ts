import type { JumpDepth } from './jump-depth.ts';
import { extinction } from './opacity.ts';
import { opaqueExtinction } from './emission.ts';
import type { Color, Premultiplied, Stop, TransferFunction } from './transfer-function.ts';
import { maxOpacity } from './usual-columns.ts';

/** A part of the plane of values (data units) and gradients (data units per world unit) that is visible, in one colour. */
export type Patch = BoxPatch | GaussianPatch;

/** The appearance of a patch. */
export interface PatchAppearance {
  readonly color: Color;
  /** 0..1 per reference length; for a Gaussian, in its middle. */
  readonly opacity: number;
}

/** Everything between two values, and between two gradients. */
export interface BoxPatch extends PatchAppearance {
  readonly kind: 'box';
  readonly values: readonly [low: number, high: number];
  readonly gradients: readonly [low: number, high: number];
}

/** A Gaussian around a value and a gradient. */
export interface GaussianPatch extends PatchAppearance {
  readonly kind: 'gaussian';
  readonly value: number;
  readonly gradient: number;
  /** Standard deviations of values and of gradients. */
  readonly widths: readonly [ofValues: number, ofGradients: number];
}

/** The largest number of patches, which are added: the shader has room for this many. */
export const maxPatches = 8;

/**
 * A Gaussian ends at this many standard deviations from its middle. Its value there is subtracted from it, so that it ends without a step.
 */
export const gaussianReach = 3;

/** What is subtracted from the Gaussian, and the factor after that, so that it is 1 in its middle. */
export const gaussianFloor = Math.exp(-(gaussianReach ** 2) / 2);
export const gaussianScale = 1 / (1 - gaussianFloor);

/**
 * For shorter ways through a Gaussian (in standard deviations), Simpson's rule is used: the difference of two error functions would lose
 * all digits.
 */
export const shortWay = 0.2;

/** A place in the plane of values and gradients. */
export type ValueAndGradient = readonly [value: number, gradient: number];

/** The range of values in which a patch is visible. */
export function spanOfPatch(patch: Patch): readonly [number, number] {
  if (patch.kind === 'box') return patch.values;
  const reach = gaussianReach * patch.widths[0];
  return [patch.value - reach, patch.value + reach];
}

/** The smallest gradient at which a patch is visible. */
export function minGradient(patch: Patch): number {
  return patch.kind === 'box' ? patch.gradients[0] : patch.gradient - gaussianReach * patch.widths[1];
}

/** Optical depth of patches that may contain values of a range, whatever their gradients. */
export function depthOfPatches(patches: readonly Patch[]): JumpDepth {
  const parts = patches.map((patch) => ({
    span: spanOfPatch(patch),
    depth: extinction(Math.min(0.9999, patch.opacity)),
  }));
  return (low, high, length) =>
    length * parts.reduce((sum, { span, depth }) => (low <= span[1] && high >= span[0] ? sum + depth : sum), 0);
}

/**
 * Mean of extinction times colour, and of extinction, per reference length, over a straight way through the plane: value and gradient are
 * both assumed to change linearly. Where patches overlap, extinctions add.
 * Source: Kniss, Premoze, Ikits, Lefohn, Hansen and Praun 2003. Twin: shaders/chunks/classify/patches.glsl
 */
export function meanOverWay(patches: readonly Patch[], from: ValueAndGradient, to: ValueAndGradient): Premultiplied {
  const mean: Premultiplied = [0, 0, 0, 0];
  for (const patch of patches) {
    const share = meanOfPatch(patch, from, to);
    if (!(share > 0)) continue;
    const density = share * densityOf(patch);
    patch.color.forEach((channel, c) => (mean[c] += density * channel));
    mean[3] += density;
  }
  return mean;
}

/** Extinction per reference length where a patch is 1. */
export function densityOf({ opacity }: PatchAppearance): number {
  return Math.min(opaqueExtinction, extinction(Math.min(opacity, 1)));
}

/** Mean of a patch, 0..1, over a straight way. */
export function meanOfPatch(patch: Patch, from: ValueAndGradient, to: ValueAndGradient): number {
  if (patch.kind === 'box') return meanOfBox([patch.values, patch.gradients], from, to);
  const middle = [patch.value, patch.gradient];
  const [a, b] = [from, to].map((place) => place.map((x, i) => (x - middle[i]) / patch.widths[i]));
  return meanOfGaussian(a, b);
}

/** The share of a way that lies inside the box. */
function meanOfBox(
  sides: readonly (readonly [number, number])[],
  from: ValueAndGradient,
  to: ValueAndGradient,
): number {
  let [begin, end] = [0, 1];
  sides.forEach(([low, high], i) => {
    const step = to[i] - from[i];
    if (step === 0) {
      if (from[i] < low || from[i] > high) end = 0;
      return;
    }
    const [a, b] = [(low - from[i]) / step, (high - from[i]) / step];
    begin = Math.max(begin, Math.min(a, b));
    end = Math.min(end, Math.max(a, b));
  });
  return Math.max(0, end - begin);
}

/** Mean over a way, in standard deviations from the middle. Along a straight line, the Gaussian depends on one number only. */
function meanOfGaussian(from: readonly number[], to: readonly number[]): number {
  const step = to.map((x, i) => x - from[i]);
  const length = Math.hypot(...step);
  if (length < shortWay)
    return (gaussianAt(from) + 4 * gaussianAt(from.map((x, i) => x + step[i] / 2)) + gaussianAt(to)) / 6;
  const start = (from[0] * step[0] + from[1] * step[1]) / length;
  const off = from[0] ** 2 + from[1] ** 2 - start ** 2;
  const half = Math.sqrt(Math.max(0, gaussianReach ** 2 - off));
  const [a, b] = [Math.max(start, -half), Math.min(start + length, half)];
  if (!(b > a)) return 0;
  const integral = Math.exp(-off / 2) * Math.sqrt(Math.PI / 2) * (erf(b / Math.SQRT2) - erf(a / Math.SQRT2));
  return (gaussianScale * Math.max(0, integral - gaussianFloor * (b - a))) / length;
}

/** @param place - in standard deviations from the middle */
function gaussianAt([x, y]: readonly number[]): number {
  return gaussianScale * Math.max(0, Math.exp(-(x * x + y * y) / 2) - gaussianFloor);
}

/**
 * The error function near 0, where alone it is needed. All terms of the series have one sign.
 * Source: NIST, Digital Library of Mathematical Functions, 7.6.2
 */
export function erf(x: number): number {
  let [term, sum] = [x, x];
  for (let n = 1; Math.abs(term) > 1e-17 * Math.abs(sum); n++) {
    term *= (2 * x * x) / (2 * n + 1);
    sum += term;
  }
  return (2 / Math.sqrt(Math.PI)) * Math.exp(-x * x) * sum;
}

/** Number of steps between the stops of `outlinePatches`, from 0 % to 100 %. */
const steps = 100;

/**
 * The largest visible effect of patches by value alone, over all gradients. Legends, empty space and planes in the picture use it.
 * It has a stop at each percent. The outer stops lie next to the patches. If patches reach beyond the data, the outer stops lie next
 * to the data, and the function keeps the patches' opacity there.
 * @param range - of the data
 */
export function outlinePatches(
  patches: readonly Patch[],
  [min, max]: readonly [number, number] = [-Infinity, Infinity],
): TransferFunction {
  const spans = patches.map(spanOfPatch);
  const [from, to] = [Math.min(...spans.map(([first]) => first)), Math.max(...spans.map(([, last]) => last))];
  const [low, high] = Math.max(from, min) < Math.min(to, max) ? [Math.max(from, min), Math.min(to, max)] : [from, to];
  const width = (high - low) / (steps - 2);
  const valueAt = (i: number): number => low + (i - 1) * width;
  return Array.from({ length: steps + 1 }, (_, i): Stop => {
    // Includes the neighbours' values, as the function is linear between stops. Outside, the opacity is 0, in the colour of the nearest
    // stop inside.
    const inside = Math.min(steps - 1, Math.max(1, i));
    const [red, green, blue, density] = maxAmong(patches, valueAt(inside - 1), valueAt(inside + 1));
    const color: Color = density > 0 ? [red / density, green / density, blue / density] : patches[0].color;
    return {
      value: valueAt(i),
      color,
      opacity: inside === i || (i === 0 ? from < low : to > high) ? Math.min(maxOpacity, -Math.expm1(-density)) : 0,
    };
  });
}

/** The largest value of each patch among values, added. */
function maxAmong(patches: readonly Patch[], low: number, high: number): Premultiplied {
  const sum: Premultiplied = [0, 0, 0, 0];
  for (const patch of patches) {
    const density = densityOf(patch) * maxOf(patch, low, high);
    if (!(density > 0)) continue;
    patch.color.forEach((channel, c) => (sum[c] += density * channel));
    sum[3] += density;
  }
  return sum;
}

function maxOf(patch: Patch, low: number, high: number): number {
  if (patch.kind === 'box') return Number(high >= patch.values[0] && low <= patch.values[1]);
  const nearest = Math.min(Math.max(patch.value, low), high);
  return gaussianAt([(nearest - patch.value) / patch.widths[0], 0]);
}
