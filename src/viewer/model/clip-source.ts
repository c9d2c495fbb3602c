import type { Vector3 } from '../../volume/matrix.ts';

/** A half of the world, or a box. It uses the coordinates of `region`: heights of a radar before they are exaggerated. */
export type ClipShape = ClipPlane | ClipBox;

/** Keeps what lies in the direction of the normal, from `at` on. */
export interface ClipPlane {
  readonly kind: 'plane';
  /** Of length 1. */
  readonly normal: Vector3;
  /** World units along the normal; null for the middle of the volume. */
  readonly at: number | null;
}

export interface ClipBox {
  readonly kind: 'box';
  /** Two opposite corners. */
  readonly box: readonly number[];
  readonly keep: 'inside' | 'outside';
}
