import type { Vector3 } from '../../volume/matrix.ts';

/** A half of the world, or a box, in the coordinates of `region`: of a radar, heights before they are exaggerated. */
export type ClipShape = ClipPlane | ClipBox;

/** What lies where the normal points to, from `at` on, is kept. */
export interface ClipPlane {
  readonly kind: 'plane';
  /** Of length 1. */
  readonly normal: Vector3;
  /** World units along it; null for the middle of the volume. */
  readonly at: number | null;
}

export interface ClipBox {
  readonly kind: 'box';
  /** Two opposite corners. */
  readonly box: readonly number[];
  readonly keep: 'inside' | 'outside';
}
