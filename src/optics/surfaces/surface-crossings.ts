import { add, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Sample, Segment } from '../rays/ray-stages.ts';

/** Samples from the straight line between two samples to the surface: where values kink, two at the most, and by regula falsi. */
export const surfaceRefinements = 4;

/** Samples that are taken for one place at which a ray may graze a surface. */
export const grazingProbes = 3;

/** Substeps of a step on which a ray may graze a surface, where it is known where values kink; elsewhere it takes as many as there may be. */
export const kinkedSubsteps = 4;

/** A piece of a ray along which values only rise, or only fall, as far as is known; its ends know their `point`. */
export interface Leg extends Segment {
  /** Surfaces from this value on are crossed on it, up to that at its back. */
  readonly from: number;
  /** Whether what emits and absorbs on it still has to be gathered. */
  readonly isNew: boolean;
}

/** Where a leg crosses a surface. */
export interface Crossing {
  /** Number of the surface. */
  readonly surface: number;
  /** Share of the leg. */
  readonly share: number;
  /** What is there; its value is the surface's. */
  readonly hit: Sample;
}

/** What is known of places of the unit cube. */
export interface Looking {
  sampleAt(place: Vector3): Sample;
  /** See `FieldStage`. */
  kinksBetween?(from: Vector3, to: Vector3): readonly number[];
}

/**
 * The surfaces that a leg crosses, in the order of the ray. Values above or at that of a surface are on one side of it, so that each
 * crossing counts once, whatever the steps.
 * Source: regula falsi with the weights of Dowell and Jarratt 1971 ("Illinois"). Twin: shaders/chunks/gather/surface-crossings.glsl
 */
export function crossSurfaces(values: readonly number[], leg: Leg, look: Looking, refinements = surfaceRefinements): Crossing[] {
  const crossings: Crossing[] = [];
  let [share, value] = [0, leg.front.value];
  for (const surface of listCrossed(values, leg)) {
    const found = refine(leg, { share, value, wanted: values[surface] }, look, refinements);
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
  { front, back }: Leg, { share, value, wanted }: { readonly share: number; readonly value: number; readonly wanted: number }, { sampleAt, kinksBetween }: Looking, refinements: number,
): { share: number; hit: Sample } {
  const isAbove = back.value >= wanted;
  let [a, b] = [share, 1];
  let [fromA, fromB] = [value - wanted, back.value - wanted];
  let [hit, kept] = [back, 0];
  const next = (): number => (fromA === fromB ? a : Math.min(b, Math.max(a, a + ((b - a) * fromA) / (fromA - fromB))));
  const kinks = [...(kinksBetween?.(front.point as Vector3, back.point as Vector3) ?? []), 2, 2, 2].slice(0, 3);
  kinks.sort((one, other) => one - other);
  for (let i = 0; i < refinements; i++) {
    // The kink in the middle, and the next one on the side where the surface is: between two of them values are smooth.
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

/** What a ray is known by around a segment. */
export interface Around {
  /** The sample before the segment. */
  readonly sample: Sample;
  /** How far before. */
  readonly span: number;
  /** At a place that rays do not show only turns within the segment count. */
  readonly isShown: boolean;
}

/** Where a ray turns between samples. */
export interface Turn {
  /** From where the segment begins, as lengths of rays are. */
  readonly at: number;
  readonly top: Sample;
}

/**
 * Where a ray grazes a surface between samples, of which no two lie on different sides of it: the place where values turn, if there they are
 * beyond a surface. Values that turn may go on as far as they came: a single voxel is steepest next to its top. It is looked for where values
 * kink, as a thin edge is a kink, and then at the tops of parabolas, as all else is smooth.
 * Twin: shaders/chunks/gather/surface-crossings.glsl, findTurn
 */
export function findTurn(
  values: readonly number[], { front, back, span }: Segment, { sample, span: spanBefore, isShown }: Around, { sampleAt, kinksBetween }: Looking,
): Turn | null {
  let [a, b, c] = [sample.value, front.value, back.value];
  let [ta, tb, tc] = [-spanBefore, 0, span];
  const isTop = a <= b && c <= b;
  if (!(isTop || (a >= b && c >= b)) || (a === b && b === c)) return null;
  const reach = b + (isTop ? b - Math.min(a, c) : b - Math.max(a, c));
  const known = front.value;
  const isBeyond = (value: number): boolean => values.some((wanted) => known >= wanted !== isTop && value >= wanted === isTop);
  if (!isBeyond(reach)) return null;
  const kinks = kinksBetween ? [...kinksBetween(front.point as Vector3, back.point as Vector3).map((share) => share * span), ...kinksBetween(front.point as Vector3, sample.point as Vector3).map((share) => -share * spanBefore)] : [];
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
    // Beyond a place that is known, as kinks come in any order, the end of the whole is the next.
    if (isBetter && at > tb) [ta, a, tb, b, tc, c] = at < tc ? [tb, b, at, found.value, tc, c] : [tb, b, at, found.value, span, back.value];
    else if (isBetter) [ta, a, tb, b, tc, c] = at > ta ? [ta, a, at, found.value, tb, b] : [-spanBefore, sample.value, at, found.value, tb, b];
    else if (at > tb && at < tc) [tc, c] = [at, found.value];
    else if (at < tb && at > ta) [ta, a] = [at, found.value];
    else if (!isKink) return null;
  }
  return null;
}

/**
 * Whether values next to those of a step may be beyond a surface that is not met on it: as far on as they came, on the step or before it.
 * Only there it takes more samples to find where a ray grazes one. Twin: shaders/chunks/gather/surfaces.glsl
 * @param before - by how much values changed on a step before
 */
export function mayGraze(values: readonly number[], [from, to]: readonly [number, number], before: number): boolean {
  const [low, high] = [Math.min(from, to), Math.max(from, to)];
  const reach = Math.max(high - low, before);
  return values.some((wanted) => (high < wanted && high + reach >= wanted) || (low >= wanted && low - reach < wanted));
}

/** Place between two samples that know theirs. */
export function between(front: Sample, back: Sample, share: number): Vector3 {
  return add(scale(front.point as Vector3, 1 - share), scale(back.point as Vector3, share));
}
