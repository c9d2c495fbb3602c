// Edits of boxes and Gaussians in the plane of values and gradients.
import type { BoxPatch, GaussianPatch, Patch, PatchAppearance, ValueAndGradient } from '../optics/transfer/patches.ts';
import { maxPatches } from '../optics/transfer/patches.ts';
import { largestValue } from '../optics/transfer/transfer-function.ts';
import { numbersOf } from '../optics/transfer/write-patches.ts';
import { roundTo } from './ticks.ts';
import { dragStep } from './transfer-function-axes.ts';

/** What the chart spans. */
export interface PlaneRange {
  /** Data values at its left and right edge. */
  readonly domain: readonly [number, number];
  /** The gradient at its upper edge; that at the lower one is 0. */
  readonly steepest: number;
}

/** The handle by which a patch is dragged: its middle, or the one that changes its size. */
export type Grip = 'middle' | 'size';

/** Distance of a Gaussian's size grip from its middle, in standard deviations. */
export const gripReach = 2;

/** The minimum width and height of a patch, as a share of the chart. */
const thinnest = 0.004;

/** Colours of new patches, one after the other. */
const newColors: readonly PatchAppearance['color'][] = [
  [1, 0.6, 0.2],
  [0.35, 0.7, 1],
  [0.5, 0.9, 0.45],
  [1, 0.9, 0.6],
  [0.95, 0.4, 0.55],
  [0.75, 0.6, 1],
  [0.4, 0.9, 0.85],
  [1, 1, 1],
];

const newOpacity = 0.3;

/** The position of a patch's grip. */
export function placeOfGrip(patch: Patch, grip: Grip): ValueAndGradient {
  if (patch.kind === 'gaussian')
    return [0, 1].map(
      (i) => [patch.value, patch.gradient][i] + (grip === 'size' ? gripReach * patch.widths[i] : 0),
    ) as unknown as ValueAndGradient;
  const { values, gradients } = patch;
  return grip === 'size' ? [values[1], gradients[1]] : [(values[0] + values[1]) / 2, (gradients[0] + gradients[1]) / 2];
}

/** Moves a grip of a patch to another point. The middle moves the whole patch. */
export function moveGrip(patch: Patch, grip: Grip, to: ValueAndGradient, range: PlaneRange): Patch {
  const [value, gradient] = roundPlace(clampPlace(to, range), range);
  if (grip === 'size') return resize(patch, [value, gradient], range);
  if (patch.kind === 'gaussian') return { ...patch, value, gradient };
  const [wide, high] = [patch.values[1] - patch.values[0], patch.gradients[1] - patch.gradients[0]];
  const low = roundPlace([value - wide / 2, Math.max(0, gradient - high / 2)], range);
  return { ...patch, values: [low[0], low[0] + wide], gradients: [low[1], low[1] + high] };
}

/** Changes the size: a box keeps its low corner, a Gaussian its middle. */
function resize(patch: Patch, [value, gradient]: ValueAndGradient, { domain, steepest }: PlaneRange): Patch {
  const [thinValues, thinGradients] = [thinnest * (domain[1] - domain[0]), thinnest * steepest];
  if (patch.kind === 'gaussian') {
    return {
      ...patch,
      widths: [
        Math.max(thinValues, (value - patch.value) / gripReach),
        Math.max(thinGradients, (gradient - patch.gradient) / gripReach),
      ],
    };
  }
  const {
    values: [low],
    gradients: [bottom],
  } = patch;
  return {
    ...patch,
    values: [low, Math.max(low + thinValues, value)],
    gradients: [bottom, Math.max(bottom + thinGradients, gradient)],
  };
}

/** A box between two points. */
export function boxBetween(
  a: ValueAndGradient,
  b: ValueAndGradient,
  appearance: PatchAppearance,
  range: PlaneRange,
): BoxPatch {
  const [from, to] = [a, b].map((place) => roundPlace(clampPlace(place, range), range));
  const { domain, steepest } = range;
  const [low, bottom] = [Math.min(from[0], to[0]), Math.min(from[1], to[1])];
  return {
    kind: 'box',
    color: appearance.color,
    opacity: appearance.opacity,
    values: [low, Math.max(from[0], to[0], low + thinnest * (domain[1] - domain[0]))],
    gradients: [bottom, Math.max(from[1], to[1], bottom + thinnest * steepest)],
  };
}

/** A new patch in the middle of the chart. */
export function newPatch(kind: Patch['kind'], count: number, range: PlaneRange): Patch {
  const {
    domain: [low, high],
    steepest,
  } = range;
  const appearance = newAppearance(count);
  const at = (share: number, up: number): ValueAndGradient =>
    roundPlace([low + share * (high - low), up * steepest], range);
  if (kind === 'box') return boxBetween(at(0.4, 0.3), at(0.6, 0.6), appearance, range);
  const [value, gradient] = at(0.5, 0.4);
  const widths: GaussianPatch['widths'] = [
    roundTo(0.06 * (high - low), dragStep([low, high])),
    roundTo(0.1 * steepest, dragStep([0, steepest])),
  ];
  return { kind, value, gradient, widths, ...appearance };
}

/** The appearance of the next patch. */
export function newAppearance(count: number): PatchAppearance {
  return { color: newColors[count % newColors.length], opacity: newOpacity };
}

/** Whether one more patch is allowed. */
export function hasRoom(patches: readonly Patch[]): boolean {
  return patches.length < maxPatches;
}

/** Sets one of the four numbers of a patch's position; returns the patch unchanged if it would become empty. */
export function withNumber(patch: Patch, index: number, number: number): Patch {
  if (!(Math.abs(number) < largestValue)) return patch;
  const [a, b, c, d] = numbersOf(patch).map((x, i) => (i === index ? number : x));
  if (patch.kind === 'box') return a < b && c >= 0 && c < d ? { ...patch, values: [a, b], gradients: [c, d] } : patch;
  return b >= 0 && c > 0 && d > 0 ? { ...patch, value: a, gradient: b, widths: [c, d] } : patch;
}

function clampPlace(
  [value, gradient]: ValueAndGradient,
  { domain: [low, high], steepest }: PlaneRange,
): ValueAndGradient {
  return [Math.min(high, Math.max(low, value)), Math.min(steepest, Math.max(0, gradient))];
}

function roundPlace([value, gradient]: ValueAndGradient, { domain, steepest }: PlaneRange): ValueAndGradient {
  return [roundTo(value, dragStep(domain)), roundTo(gradient, dragStep([0, steepest]))];
}
