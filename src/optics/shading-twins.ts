// The float64 twins of light, rendering styles, surfaces and transfer functions by gradient. They are loaded with the first ray that needs
// one of them.
import type { VolumeData } from '../volume/volume.ts';
import { cartesianGradient } from './rays/gradient.ts';
import type { GradientStage } from './rays/gradient.ts';
import { cartesianField } from './rays/ray-field.ts';
import type { FieldStage } from './rays/ray-stages.ts';

export { ambientShade } from './rays/ambient-light.ts';
export { lightAt, litShade, towardsEye } from './rays/lit.ts';
export { lightPatches, patchClassify } from './rays/patch-classify.ts';
export { styledShade, stylesAt } from './rays/styled.ts';
export { brightenSurfaces, surfaceGather } from './surfaces/surfaces.ts';
export { meanOverWay } from './transfer/patches.ts';
export { withLight } from './transfer/volume-styles.ts';

/** A field whose gradient is known at each place. */
export interface SlopedField {
  readonly gradient: GradientStage;
  readonly isFolded: FieldStage['isFolded'];
}

/** The gradients of a volume on a cartesian grid. */
export function cartesianSlopes(volume: VolumeData): SlopedField {
  const { grid, finer } = volume;
  const field = cartesianField({ ...volume, dimensions: grid.dimensions });
  return { gradient: cartesianGradient(field, grid, finer), isFolded: field.isFolded };
}
