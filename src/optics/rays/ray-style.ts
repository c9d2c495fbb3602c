import type { Patch } from '../transfer/patches.ts';
import type { Color } from '../transfer/transfer-function.ts';
import type { StyleChain, VolumeStyle } from '../transfer/volume-styles.ts';

/** What of a ray's values is shown, instead of emission and absorption. */
export type ProjectionKind = 'max' | 'min' | 'average';

export const projectionKinds: readonly ProjectionKind[] = ['max', 'min', 'average'];

/** How rays show a value of their own. */
export interface ProjectedRays {
  /** Whether that is found whatever the steps; else it is one of the values that samples have. */
  readonly isExact: boolean;
  /** Whether values change gradually, and not from one to another as labels do. */
  readonly hasValuesBetween: boolean;
}

/** Whether the surfaces that a field has everywhere are lit. */
export type Shading = 'lit' | 'unlit';

export const shadings: readonly Shading[] = ['lit', 'unlit'];

/** A surface on which a field has a value. */
export interface IsoSurface {
  /** Data units. */
  readonly value: number;
  readonly color: Color;
  /** 0..1, of each time that a ray passes it. */
  readonly opacity: number;
}

/** Surfaces of some values in a volume. */
export interface SurfaceStyle {
  /** By ascending value. */
  readonly surfaces: readonly IsoSurface[];
  /** They have their own colours, without light. */
  readonly plain?: true;
  /** What emits and absorbs is left out: there are surfaces alone. */
  readonly clear?: true;
  /** Of surfaces alone: X3D's rendering styles, one after the other, which light them too. */
  readonly surfaceStyles?: readonly VolumeStyle[];
}

/** How rays are drawn where it is not by emission and absorption alone; what is absent is as usual. Styles that are written alike are one. */
export interface RayStyle extends Partial<SurfaceStyle> {
  /** A value of each ray; nothing else of the style counts then. */
  readonly projection?: ProjectionKind;
  /** Of the largest value, or the smallest: instead, the first local one from this on, in data units; absent for that of the whole ray. */
  readonly intensityThreshold?: number;
  /** Light on what emits and absorbs. */
  readonly lit?: true;
  /** X3D's rendering styles. */
  readonly styles?: readonly StyleChain[];
  /** What emits and absorbs goes by value and gradient. */
  readonly patches?: readonly Patch[];
}

/** Whether nothing changes between two styles, or none. */
export function isSameStyle(a: RayStyle | null, b: RayStyle | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
