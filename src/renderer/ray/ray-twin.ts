// The same ray in float64: what each module adds to it. The code that does so is loaded with the first ray that is cast.
import { loadPart } from '../../core/load-part.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Optics, RayModule, RayTwin, TwinFrame, TwinStages } from './ray-module.ts';

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
