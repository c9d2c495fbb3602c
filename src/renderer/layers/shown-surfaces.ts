import type { Color } from '../../optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Surface } from '../../volume/surface.ts';
import type { WorldCut } from '../../volume/world-cut.ts';

/** A surface that is shown together with a volume. */
export interface ShownSurface {
  readonly surface: Surface;
  /** The colour if its vertices have no colours of their own, or if these are not used. */
  readonly color: Color;
  readonly usesOwnColors: boolean;
  /** Whether the cuts of the volume also cut the surface. */
  readonly isCut?: boolean;
  /** Present if a part of it is cut away: `surface` is then the part that is left. */
  readonly cut?: { readonly whole: Surface; readonly away: WorldCut };
  /** Points in world coordinates that a camera has to show when it frames the surface; none if absent. */
  readonly places?: readonly Vector3[];
}
