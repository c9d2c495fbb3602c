// What an estimate of what coarse bricks hide needs to know of a picture, and what it says.
import type { RaySetup } from '../optics/rays/rays.ts';
import type { Premultiplied } from '../optics/transfer/transfer-function.ts';
import type { DetailField } from './detail-field.ts';
import type { DetailLight } from './detail-light.ts';
import type { HiddenValues } from './hidden-values.ts';
import type { PaintedPlane } from './painted-plane.ts';
import type { SpanSums } from './span-sums.ts';
import type { SteepLooks } from './steep-looks.ts';

/** How rays show one value each: the largest or the smallest. */
export interface ExtremeLook {
  /** 1 for the largest, -1 for the smallest. */
  readonly sign: 1 | -1;
  /** What a stored value looks like. */
  readonly colorOf: (value: number) => Premultiplied;
  /** If given, the first local extreme from this value on counts: a stored value, times the sign. */
  readonly threshold?: number;
}

/** What the estimate needs to know. */
export interface DetailScene {
  readonly field: DetailField;
  readonly rays: RaySetup;
  readonly sums: SpanSums;
  /** Length of a step in bounding diameters: the same as in the sums. */
  readonly step: number;
  /** The same in voxels of the finest level; 1 if undefined. */
  readonly voxels?: number;
  /** What is known of the values near a place. */
  readonly hidden: HiddenValues;
  /** Rays across and down. */
  readonly across: number;
  /** The finest level that counts, by a ray's parameter, see `levelOfPixels`: what is finer is neither missing nor asked for. Undefined: all counts. */
  readonly finestAt?: (t: number) => number;
  /** Whether a place of the unit cube is cut away; nothing is if undefined. */
  readonly isAway?: (x: number, y: number, z: number) => boolean;
  /** Opaque planes on which values are painted. */
  readonly planes?: readonly PaintedPlane[];
  /** Undefined: colours do not depend on the direction in which values change. */
  readonly light?: DetailLight;
  /** Undefined: nothing else depends on how values change. */
  readonly steep?: SteepLooks;
  /** Undefined: rays show all that emits and absorbs. */
  readonly extreme?: ExtremeLook;
  /** Shifts rays within their pixels, 0..1. */
  readonly shift?: readonly [number, number];
}

/** Receives what is found, for each cell that a ray meets. Energies are sums over rays and four channels of squared differences, 0..1. */
export interface DetailListener {
  /** How much less the energy is if the cell has this level instead of its present one. The finest level that counts comes first. */
  gain(cell: number, level: number, energy: number): void;
  /** How much more the energy would be if the cell's brick were not there; undefined if nobody asks. */
  loss?(cell: number, energy: number): void;
}

/** What a ray says. */
export interface RayDetail {
  /** Sum over the channels of the squared difference that is expected, 0..1. */
  readonly energy: number;
  /** Whether it shows something, 1; else the opacity that is expected of it. */
  readonly cover: number;
  /** The finest level that counts anywhere on it. */
  readonly finest: number;
}

/** A ray through the unit cube. */
export interface DetailRay {
  readonly point: readonly number[];
  readonly direction: readonly number[];
  readonly entry: number;
  readonly exit: number;
  /** A step in the ray's parameter. */
  readonly dt: number;
}

/** Says to the listener what the cells of a ray bring. Null where it shows nothing. */
export type RayEstimate = (ray: DetailRay, listener: DetailListener) => RayDetail | null;

/** Steps of a ray; longer rays are cut. */
export const maxSteps = 8192;
