import type { RayStages } from '../../optics/rays/ray-stages.ts';
import type { StageName, TwinFrame, TwinStages } from './ray-module.ts';
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

/** Stages in the order in which they are built: each may use the stages before it. */
const order: readonly StageName[] = ['field', 'interval', 'classify', 'shade', 'gather'];

/** The parts of `TwinStages` that modules of each stage may add to. */
const own: Record<StageName, readonly (keyof TwinStages)[]> = {
  field: ['field', 'moreFields'],
  interval: ['intervals'],
  classify: ['classify'],
  shade: ['shades'],
  gather: ['gather'],
};

/** The stages before any module has added to them. */
const nothing: Partial<TwinStages> = { intervals: [], moreFields: [], shades: [] };

/** Load the code that casts the rays of a frame. @throws {VolumeViewError} `format/unsupported` */
export async function loadTwins({ modules }: Pick<RayTwins, 'modules'>, frame: TwinFrame): Promise<void> {
  await Promise.all(modules.flatMap(({ twin }) => (twin ? [twin.load(frame)] : [])));
}

/**
 * Compose the stages of a picture's rays in float64, from the twins of the modules that draw the picture.
 * @throws {TypeError} if no module of a stage has a twin, or if a twin gives parts of a stage that is not its module's stage
 */
export function composeTwins(
  { modules }: Pick<RayTwins, 'modules'>,
  frame: TwinFrame,
  { stepLength, maxSubsteps, minSubsteps }: TwinWalk,
): RayStages {
  const first = modules.filter(isFirst);
  const sorted = [
    ...first,
    ...order.flatMap((stage) => modules.filter((module) => module.stage === stage && !first.includes(module))),
  ];
  const all = sorted.reduce((before, module) => join(before, partsOf(module, frame, before)), nothing as TwinStages);
  for (const stage of ['field', 'classify', 'gather'] as const) {
    if (!all[stage])
      throw new TypeError(`no module of the stage ${stage} has a twin: ${modules.map(({ name }) => name).join(', ')}`);
  }
  const { rays } = frame;
  return { ...all, eyeT: rays.eyeT, step: stepLength / rays.diameter, maxSubsteps, minSubsteps };
}

/** A twin may give only parts of its module's own stage: else modules would act in another order than on the GPU. */
function partsOf(
  { name, stage, twin }: RayTwins['modules'][number],
  frame: TwinFrame,
  before: TwinStages,
): Partial<TwinStages> {
  const parts = twin?.parts(frame, before) ?? {};
  const other = (Object.keys(parts) as (keyof TwinStages)[]).find((key) => !own[stage].includes(key));
  if (other)
    throw new TypeError(
      `the twin of ${name} got "${other}"; expected what the stage ${stage} has: ${own[stage].join(' or ')}`,
    );
  return parts;
}

/** Whether a module is the one that gives the values of the field. */
function isFirst({ stage, members }: RayTwins['modules'][number]): boolean {
  return stage === 'field' && !members;
}

function join(
  before: TwinStages,
  { intervals = [], moreFields = [], shades = [], ...single }: Partial<TwinStages>,
): TwinStages {
  return {
    ...before,
    ...single,
    intervals: [...before.intervals, ...intervals],
    moreFields: [...before.moreFields, ...moreFields],
    shades: [...before.shades, ...shades],
  };
}
