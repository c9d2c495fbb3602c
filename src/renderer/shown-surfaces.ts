import type { Color } from '../optics/transfer-function.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Surface } from '../volume/surface.ts';

/** A surface among a volume. */
export interface ShownSurface {
  readonly surface: Surface;
  /** Where its vertices have no colours of their own, or these are not wanted. */
  readonly color: Color;
  readonly usesOwnColors: boolean;
  /** World places that a camera which frames it has in its picture; none where absent. */
  readonly places?: readonly Vector3[];
}

/** An element in whose scene surfaces are, by the elements that show them: whichever scene it has looks here. */
export interface SurfacedElement extends Element {
  _surfaces?: ReadonlyMap<Element, ShownSurface>;
}
