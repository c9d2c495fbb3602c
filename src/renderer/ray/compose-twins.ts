import { composeStages } from '../../optics/rays/compose-stages.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import type { TwinFrame } from './ray-module.ts';
import type { RayTwins } from './ray-twin.ts';

/** How rays are walked. */
export interface TwinWalk {
  /** World length of a step. */
  readonly stepLength: number;
  /** The maximum number of substeps of a step. */
  readonly maxSubsteps: number;
  /** See `RayStages`. */
  readonly minSubsteps?: RayStages['minSubsteps'];
}

/** Load the code that casts the rays of a frame. @throws {VolumeViewError} `format/unsupported` */
export async function loadTwins({ modules }: Pick<RayTwins, 'modules'>, frame: TwinFrame): Promise<void> {
  await Promise.all(modules.flatMap(({ twin }) => (twin ? [twin.load(frame)] : [])));
}

/**
 * Compose the stages of a picture's rays in float64, from the twins of the modules that draw the picture.
 * @throws {TypeError} as `composeStages` does
 */
export function composeTwins(
  { modules }: Pick<RayTwins, 'modules'>,
  frame: TwinFrame,
  { stepLength, maxSubsteps, minSubsteps }: TwinWalk,
): RayStages {
  const givers = modules.map(({ name, stage, members, twin }) => ({
    name,
    stage,
    isSecond: members !== undefined,
    parts: (before: Parameters<NonNullable<typeof twin>['parts']>[1]) => twin?.parts(frame, before) ?? {},
  }));
  const { rays } = frame;
  return composeStages(givers, { eyeT: rays.eyeT, step: stepLength / rays.diameter, maxSubsteps, minSubsteps });
}
