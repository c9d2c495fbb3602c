// What a pick needs of surfaces: loaded with the first pick where there are some.
import { pointField } from './rays/lit.ts';
import type { IsoSurface } from './rays/ray-style.ts';
import type { ReferenceScene } from './reference.ts';
import { surfaceGather } from './surfaces/surfaces.ts';
import type { SurfaceScene } from './surfaces/surfaces.ts';

/** As many as find a place to rounding: one ray is cast. */
const refinements = 40;

/** Surfaces as a pick meets them: light makes no difference to where they are, and styles do to how much hides what is behind. */
export function surfaceStages(surfaces: readonly IsoSurface[], isClear: boolean, stylesOf?: SurfaceScene['stylesOf']): Required<Pick<ReferenceScene, 'moreFields' | 'gather'>> {
  return { moreFields: [pointField], gather: surfaceGather({ surfaces, isClear, light: null, toEye: () => [0, 0, 1], refinements, stylesOf }) };
}
