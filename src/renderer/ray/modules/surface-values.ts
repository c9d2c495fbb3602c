import { mapShares } from '../../../optics/transfer/share-map.ts';
import { maxSurfaces } from '../../../optics/transfer/surface-limits.ts';
import type { RayFrame } from '../ray-module.ts';

/** Farther than any value: a share of the domain. */
const nowhere = 1e36;

/** Kinks on the ways to the samples before and behind a place: three at the most on each. */
export const kinkProbes = 6;

/** Values as shares of the domain, far from any where there are fewer than there may be. */
export function surfaceValues(values: readonly number[], { volume, field: { storedScale }, domain }: RayFrame): number[] {
  const { from, scale } = mapShares({ ...volume, storedScale }, domain);
  return Array.from({ length: maxSurfaces }, (_, i) => (i < values.length ? Math.min(nowhere, ((values[i] - volume.intercept) / volume.slope / storedScale - from) * scale) : nowhere));
}
