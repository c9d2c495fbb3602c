import { opaqueExtinction } from './emission.ts';
import { extinction } from './opacity.ts';
import { maxSurfaces } from './surface-limits.ts';
import type { Stop, TransferFunction } from './transfer-function.ts';
import { maxOpacity } from './usual-columns.ts';

/** A change of a voxel's opacity is visible from this on, even if a ray passes the place for less than a step. */
const seen = 0.1;

/** A piece narrower than this share of the domain acts as a jump: from one sample of a ray to the next, values change by more. */
const narrow = 0.04;

const halvings = 30;

/**
 * Values at which a transfer function becomes opaque at once, or stops being so: where it jumps, and where it rises steeply to full
 * opacity. A ray that touches matter beyond such a value shows all of it or nothing. So rays search for these places, as they do for
 * surfaces (see optics/surfaces/surface-crossings.ts). Only the strongest are returned, at most `maxSurfaces`.
 * @param voxelRatio - length of a voxel / reference length, times the opacity factor
 * @returns ascending, data values
 */
export function findOpaqueJumps(transferFunction: TransferFunction, voxelRatio: number): number[] {
  const domain = transferFunction[transferFunction.length - 1].value - transferFunction[0].value;
  const found: { readonly value: number; readonly change: number }[] = [];
  transferFunction.slice(1).forEach((to, i) => {
    const from = transferFunction[i];
    const change = Math.abs(voxelOpacity(to.opacity, voxelRatio) - voxelOpacity(from.opacity, voxelRatio));
    if (to.value === from.value) found.push({ value: to.value, change });
    else if (Math.max(from.opacity, to.opacity) > maxOpacity)
      found.push(...findInPiece([from, to], { change, narrow: narrow * domain, voxelRatio }));
  });
  const strong = found.filter(({ change }) => change >= seen);
  strong.sort((a, b) => b.change - a.change);
  const values = [...new Set(strong.slice(0, maxSurfaces).map(({ value }) => value))];
  values.sort((a, b) => a - b);
  return values;
}

/** The share of the light from behind that a voxel hides. */
function voxelOpacity(opacity: number, voxelRatio: number): number {
  return -Math.expm1(-Math.min(opaqueExtinction, extinction(opacity)) * voxelRatio);
}

/** The value where half of the change is reached and, in a wide piece, also the steep end at full opacity. */
function findInPiece(
  [from, to]: readonly [Stop, Stop],
  {
    change,
    narrow: width,
    voxelRatio,
  }: { readonly change: number; readonly narrow: number; readonly voxelRatio: number },
): { value: number; change: number }[] {
  const at = (t: number): number => voxelOpacity(from.opacity + t * (to.opacity - from.opacity), voxelRatio);
  const span = to.value - from.value;
  const half = (at(0) + at(1)) / 2;
  let [a, b] = [0, 1];
  for (let i = 0; i < halvings; i++) {
    const middle = (a + b) / 2;
    if (at(middle) < half === at(0) < half) a = middle;
    else b = middle;
  }
  const middle = { value: from.value + a * span, change };
  if (span <= width) return [middle];
  const [end, before] = to.opacity > from.opacity ? [1, 1 - width / span] : [0, width / span];
  return [middle, { value: end === 1 ? to.value : from.value, change: Math.abs(at(end) - at(before)) }];
}
