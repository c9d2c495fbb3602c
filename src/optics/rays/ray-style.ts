import type { Patch } from '../transfer/patches.ts';
import type { Color } from '../transfer/transfer-function.ts';
import type { StyleChain, VolumeStyle } from '../transfer/volume-styles.ts';

/** Which value of a ray is shown, instead of emission and absorption. */
export type ProjectionKind = 'max' | 'min' | 'average';

export const projectionKinds: readonly ProjectionKind[] = ['max', 'min', 'average'];

/** How rays show one value each. */
export interface ProjectedRays {
  /** Whether the value is exact, whatever the steps; else it is one of the sampled values. */
  readonly isExact: boolean;
  /** Whether values change gradually. Labels do not: they jump from one value to another. */
  readonly hasValuesBetween: boolean;
}

/** Whether the surfaces that a field has everywhere are lit, and whether what is hidden from most sides is darker. */
export type Shading = 'lit' | 'ambient-occlusion' | 'unlit';

export const shadings: readonly Shading[] = ['lit', 'ambient-occlusion', 'unlit'];

/** An iso-surface: where a field has a given value. */
export interface IsoSurface {
  /** Data units. */
  readonly value: number;
  readonly color: Color;
  /** 0..1, for each time that a ray passes through it. */
  readonly opacity: number;
}

/** The iso-surfaces of a volume. */
export interface SurfaceStyle {
  /** By ascending value. */
  readonly surfaces: readonly IsoSurface[];
  /** Whether the surfaces have their own colours, without light. */
  readonly plain?: true;
  /** Whether only the surfaces are drawn, without emission and absorption. */
  readonly clear?: true;
  /** For surfaces alone: X3D's rendering styles, one after the other. They also light the surfaces. */
  readonly surfaceStyles?: readonly VolumeStyle[];
}

/** How rays are drawn if not by emission and absorption alone. What is absent has its default. Two styles with the same JSON are the same. */
export interface RayStyle extends Partial<SurfaceStyle> {
  /** Shows one value of each ray. Then nothing else of the style counts. */
  readonly projection?: ProjectionKind;
  /** If given, the first local maximum (or minimum) from this value on counts, in data units. If absent, that of the whole ray. */
  readonly intensityThreshold?: number;
  /** Whether emission is lit, and whether what is around a place hides light from it. */
  readonly lit?: true | 'ambient-occlusion';
  /** X3D's rendering styles. */
  readonly styles?: readonly StyleChain[];
  /** If given, emission and absorption depend on value and gradient. */
  readonly patches?: readonly Patch[];
}

/** Whether two styles are the same; null is no style. */
export function isSameStyle(a: RayStyle | null, b: RayStyle | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
