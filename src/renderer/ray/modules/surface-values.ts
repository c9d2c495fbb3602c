import { mapShares } from '../../../optics/transfer/share-map.ts';
import { maxSurfaces } from '../../../optics/transfer/surface-limits.ts';
import type { RayFrame } from '../ray-module.ts';

/** A value for unused slots, as a share of the domain: far from any value of a volume. */
const nowhere = 1e36;

/** The maximum kinks between a place and the samples before and behind it: three on each side. */
export const kinkProbes = 6;

/** Values as shares of the domain; unused slots get a value that is far from any other. */
export function surfaceValues(
  values: readonly number[],
  { volume, field: { storedScale }, domain }: RayFrame,
): number[] {
  const { from, scale } = mapShares({ ...volume, storedScale }, domain);
  return Array.from({ length: maxSurfaces }, (_, i) =>
    i < values.length
      ? Math.min(nowhere, ((values[i] - volume.intercept) / volume.slope / storedScale - from) * scale)
      : nowhere,
  );
}
