import { add, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Sample, Segment } from '../rays/ray-stages.ts';

/** Number of samples to find a surface between two samples: at most two where values kink, and the rest by regula falsi. */
export const surfaceRefinements = 4;

/** Number of samples to find a place where a ray may graze a surface. */
export const grazingProbes = 3;

/** Substeps of a step on which a ray may graze a surface, if the kinks of values are known. If not, the step gets as many as possible. */
export const kinkedSubsteps = 4;

/** A piece of a ray along which values only rise or only fall, as far as the samples show. Its ends know their `point`. */
export interface Leg extends Segment {
  /** The leg crosses the surfaces between this value and that of its back. */
  readonly from: number;
  /** Whether the emission and absorption on it are still to be gathered. */
  readonly isNew: boolean;
}

/** Where a leg crosses a surface. */
export interface Crossing {
  /** Number of the surface. */
  readonly surface: number;
  /** Share of the leg. */
  readonly share: number;
  /** The sample there, with the surface's value. */
  readonly hit: Sample;
}

/** How to sample places of the unit cube. */
export interface Looking {
  sampleAt(place: Vector3): Sample;
  /** See `FieldStage`. */
  kinksBetween?(from: Vector3, to: Vector3): readonly number[];
}

/**
 * The surfaces that a leg crosses, in the order of the ray. Values above that of a surface, or equal to it, are on one side of it. So each
 * crossing counts once, whatever the steps.
 * Source: regula falsi with the weights of Dowell and Jarratt 1971 ("Illinois"). Twin: shaders/chunks/gather/surface-crossings.glsl
 */
export function crossSurfaces(
  values: readonly number[],
  leg: Leg,
  appearance: Looking,
  refinements = surfaceRefinements,
): Crossing[] {
  const crossings: Crossing[] = [];
  let [share, value] = [0, leg.front.value];
  for (const surface of listCrossed(values, leg)) {
    const found = refine(leg, { share, value, wanted: values[surface] }, appearance, refinements);
    share = found.share;
    value = values[surface];
    crossings.push({ surface, ...found });
  }
  return crossings;
}

function listCrossed(values: readonly number[], { from, back }: Leg): number[] {
  const crossed = values.flatMap((value, i) => (from >= value === back.value >= value ? [] : [i]));
  if (back.value < from) crossed.reverse();
  return crossed;
}

function refine(
  { front, back }: Leg,
  { share, value, wanted }: { readonly share: number; readonly value: number; readonly wanted: number },
  { sampleAt, kinksBetween }: Looking,
  refinements: number,
): { share: number; hit: Sample } {
  const isAbove = back.value >= wanted;
  let [a, b] = [share, 1];
  let [fromA, fromB] = [value - wanted, back.value - wanted];
  let [hit, kept] = [back, 0];
  const next = (): number => (fromA === fromB ? a : Math.min(b, Math.max(a, a + ((b - a) * fromA) / (fromA - fromB))));
  const kinks = [...(kinksBetween?.(front.point as Vector3, back.point as Vector3) ?? []), 2, 2, 2].slice(0, 3);
  kinks.sort((one, other) => one - other);
  for (let i = 0; i < refinements; i++) {
    // First the middle kink, then the next one on the surface's side: between two kinks values are smooth.
    const kink = i === 0 ? kinks[1] : i === 1 ? kinks[a < kinks[1] ? 0 : 2] : 2;
    const isKink = kink > a && kink < b;
    const at = isKink ? kink : next();
    const found = sampleAt(between(front, back, at));
    if (!found.valid) break;
    hit = found;
    const off = found.value - wanted;
    if (off >= 0 === isAbove) {
      [b, fromB] = [at, off];
      if (kept === 1) fromA *= 0.5;
      kept = isKink ? 0 : 1;
    } else {
      [a, fromA] = [at, off];
      if (kept === -1) fromB *= 0.5;
      kept = isKink ? 0 : -1;
    }
  }
  const at = next();
  return { share: at, hit: { ...hit, value: wanted, valid: true, point: between(front, back, at) } };
}

/** What is known of the ray in front of a segment. */
export interface Around {
  /** The sample before the segment. */
  readonly sample: Sample;
  /** Distance between this sample and the segment. */
  readonly span: number;
  /** Whether rays show this sample. If not, only turns within the segment count. */
  readonly isShown: boolean;
}

/** A place between samples where values along a ray turn. */
export interface Turn {
  /** Length from the start of the segment. */
  readonly at: number;
  readonly top: Sample;
}

/**
 * Finds where a ray grazes a surface although no two of its samples lie on different sides: a place where values turn, if they are beyond
 * a surface there. Values that turn may go on as far as they have come: a single voxel is steepest next to its top. Kinks are tried
 * first, because a thin edge is a kink; then the tops of parabolas, because everything else is smooth.
 * Twin: shaders/chunks/gather/surface-crossings.glsl, findTurn
 */
export function findTurn(
  values: readonly number[],
  { front, back, span }: Segment,
  { sample, span: spanBefore, isShown }: Around,
  { sampleAt, kinksBetween }: Looking,
): Turn | null {
  let [a, b, c] = [sample.value, front.value, back.value];
  let [ta, tb, tc] = [-spanBefore, 0, span];
  const isTop = a <= b && c <= b;
  if (!(isTop || (a >= b && c >= b)) || (a === b && b === c)) return null;
  const reach = b + (isTop ? b - Math.min(a, c) : b - Math.max(a, c));
  const known = front.value;
  const isBeyond = (value: number): boolean =>
    values.some((wanted) => known >= wanted !== isTop && value >= wanted === isTop);
  if (!isBeyond(reach)) return null;
  const kinks = kinksBetween
    ? [
        ...kinksBetween(front.point as Vector3, back.point as Vector3).map((share) => share * span),
        ...kinksBetween(front.point as Vector3, sample.point as Vector3).map((share) => -share * spanBefore),
      ]
    : [];
  for (let i = 0; i < kinks.length + grazingProbes; i++) {
    const [before, after] = [(b - a) / (tb - ta), (c - b) / (tc - tb)];
    const bend = (after - before) / (tc - ta);
    const isKink = i < kinks.length;
    if (!isKink && bend === 0) return null;
    const at = isKink ? kinks[i] : tb - (after - bend * (tc - tb)) / (2 * bend);
    const found = sampleAt(at < 0 ? between(front, sample, -at / spanBefore) : between(front, back, at / span));
    if (!found.valid) return null;
    if (isBeyond(found.value)) return isShown || at > 0 ? { at, top: found } : null;
    const isBetter = isTop ? found.value > b : found.value < b;
    // Kinks come in any order. If the place lies beyond a neighbour, the end of the whole becomes the new neighbour.
    if (isBetter && at > tb)
      [ta, a, tb, b, tc, c] = at < tc ? [tb, b, at, found.value, tc, c] : [tb, b, at, found.value, span, back.value];
    else if (isBetter)
      [ta, a, tb, b, tc, c] =
        at > ta ? [ta, a, at, found.value, tb, b] : [-spanBefore, sample.value, at, found.value, tb, b];
    else if (at > tb && at < tc) [tc, c] = [at, found.value];
    else if (at < tb && at > ta) [ta, a] = [at, found.value];
    else if (!isKink) return null;
  }
  return null;
}

/**
 * Whether values near those of a step may be beyond a surface that the step does not meet. They may go on as far as they have changed on this
 * step or the previous one. Only such a step takes more samples to find where a ray grazes a surface.
 * Twin: shaders/chunks/gather/surfaces.glsl
 * @param before - by how much values changed on the previous step
 */
export function mayGraze(values: readonly number[], [from, to]: readonly [number, number], before: number): boolean {
  const [low, high] = [Math.min(from, to), Math.max(from, to)];
  const reach = Math.max(high - low, before);
  return values.some((wanted) => (high < wanted && high + reach >= wanted) || (low >= wanted && low - reach < wanted));
}

/** The place between two samples that have a `point`. */
export function between(front: Sample, back: Sample, share: number): Vector3 {
  return add(scale(front.point as Vector3, 1 - share), scale(back.point as Vector3, share));
}
