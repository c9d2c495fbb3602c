// Rays in float64, which the modules' twins compose. The first ray that is cast on the processor loads the code of the twins.
import { loadPart } from '../../core/load-part.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Optics, RayModule, RayTwin, TwinFrame, TwinStages } from './ray-module.ts';

/** The modules of a picture's rays, reduced to what casting in float64 needs. They need no WebGL context, so they stay valid after the scene. */
export interface RayTwins {
  readonly volume: VolumeData;
  readonly optics: Optics;
  /** The only part of the volume that is shown; null for the whole volume. */
  readonly region: GridFrame | null;
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

/**
 * Make the twin of a module. Call it outside of functions that have a WebGL context in scope: a twin must not keep a context alive.
 * @param parts - called with the loaded code
 */
export function twinOf<T>(
  from: Later<T>,
  parts: (code: T, frame: TwinFrame, before: TwinStages) => Partial<TwinStages>,
): RayTwin {
  return { load: from.load, parts: (frame, before) => parts(from.code, frame, before) };
}

/** Code of the twins that many rays have. */
export const usualTwins = later(() => loadPart(import('../../optics/usual-twins.ts'), 'casts rays'));
