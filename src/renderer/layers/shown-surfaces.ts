import type { Color } from '../../optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Surface } from '../../volume/surface.ts';
import type { WorldCut } from '../../volume/world-cut.ts';

/** A surface among a volume. */
export interface ShownSurface {
  readonly surface: Surface;
  /** Where its vertices have no colours of their own, or these are not wanted. */
  readonly color: Color;
  readonly usesOwnColors: boolean;
  /** Whether it is cut by what cuts the volume. */
  readonly isCut?: boolean;
  /** Where something of it is cut away: `surface` is what is left. */
  readonly cut?: { readonly whole: Surface; readonly away: WorldCut };
  /** World places that a camera which frames it has in its picture; none where absent. */
  readonly places?: readonly Vector3[];
}
