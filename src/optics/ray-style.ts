import type { StyleChain } from './volume-styles.ts';

/** What of a ray's values is shown, instead of emission and absorption. */
export type ProjectionKind = 'max' | 'min' | 'average';

export const projectionKinds: readonly ProjectionKind[] = ['max', 'min', 'average'];

/** Whether the surfaces that a field has everywhere are lit. */
export type Shading = 'lit' | 'unlit';

export const shadings: readonly Shading[] = ['lit', 'unlit'];

/** How rays are drawn where it is not by emission and absorption alone; what is absent is as usual. Styles that are written alike are one. */
export interface RayStyle {
  /** A value of each ray; nothing else of the style counts then. */
  readonly projection?: ProjectionKind;
  /** Light on what emits and absorbs. */
  readonly lit?: true;
  /** X3D's rendering styles. */
  readonly styles?: readonly StyleChain[];
}

/** Whether nothing changes between two styles, or none. */
export function isSameStyle(a: RayStyle | null, b: RayStyle | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
