// The same ray in float64: what each module adds to it. The code that does so is loaded with the first ray that is cast.
import { loadPart } from '../../core/load-part.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import type { Ray, RaySetup } from '../../optics/rays/rays.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Optics, RayModule } from './ray-module.ts';

/** How a ray is walked, whatever it meets. */
type Walk = 'eyeT' | 'step' | 'maxSubsteps' | 'leastSubsteps';

/** The five stages of a ray in float64. */
export type TwinStages = Omit<RayStages, Walk>;

/** What a ray is cast through: what `RayFrame` is to the GPU. */
export interface TwinFrame {
  readonly volume: Volume;
  readonly optics: Optics;
  readonly rays: RaySetup;
  /** Whether places and opacities are all that matters, as to a pick: light, which changes neither, may be left out. */
  readonly placesOnly: boolean;
  /** t at which the nearest opaque shape of the scene stands, Infinity where there is none; absent where no shape ends rays. */
  readonly shapeT?: (ray: Ray) => number;
}

/** A module in float64. */
export interface RayTwin {
  /** Load its code. @throws {VolumeViewError} `format/unsupported` */
  load(frame: TwinFrame): Promise<unknown>;
  /**
   * What it adds, as soon as its code is there: lists are added to those of other modules, and single stages replace them.
   * @param before - the stages so far, which come in this order: field, interval, classify, shade, gather
   */
  parts(frame: TwinFrame, before: TwinStages): Partial<TwinStages>;
}

/** The modules of a picture's rays, as far as it takes to cast them in float64. They need no context, and so outlive a scene. */
export interface RayTwins {
  readonly volume: Volume;
  readonly optics: Optics;
  readonly modules: readonly Pick<RayModule, 'name' | 'stage' | 'members' | 'twin'>[];
}

/** Code that is loaded when it is needed. */
export interface Later<T> {
  load(): Promise<T>;
  /** Present when `load` has resolved. */
  readonly code: T;
}

export function later<T>(load: () => Promise<T>): Later<T> {
  let code: T;
  return {
    load: async () => (code ??= await load()),
    get code() {
      return code;
    },
  };
}

/** One thing of some code. */
export function partOf<T, P>(from: Later<T>, choose: (code: T) => P): Later<P> {
  return {
    load: async () => choose(await from.load()),
    get code() {
      return choose(from.code);
    },
  };
}

/**
 * The twin of a module. To be made outside of functions that know a context: a twin must not keep one alive.
 * @param parts - called with the code when that is there
 */
export function twinOf<T>(from: Later<T>, parts: (code: T, frame: TwinFrame, before: TwinStages) => Partial<TwinStages>): RayTwin {
  return { load: from.load, parts: (frame, before) => parts(from.code, frame, before) };
}

/** Code of the twins that many rays have. */
export const usualTwins = later(() => loadPart(import('../../optics/usual-twins.ts'), 'casts rays on the processor'));
