import type { RayStages } from './ray-stages.ts';

/** The stages of a ray, in the order in which a ray goes through them. */
export type StageName = 'interval' | 'field' | 'classify' | 'shade' | 'gather';

/** How a ray is divided into steps. */
export type RayWalk = Pick<RayStages, 'eyeT' | 'step' | 'maxSubsteps' | 'minSubsteps'>;

/** The five stages of a ray, without its division into steps. */
export type StageParts = Omit<RayStages, keyof RayWalk>;

/** Something that adds to a stage of rays. */
export interface StageGiver {
  /** For messages. */
  readonly name: string;
  readonly stage: StageName;
  /** Of the stage `field`: whether it adds to the samples of the field that gives the values. */
  readonly isSecond?: boolean;
  /**
   * What it adds. Lists are added to those before, and single stages replace them.
   * @param before - the stages so far
   */
  parts(before: StageParts): Partial<StageParts>;
}

/** Stages in the order in which they are built: each may use the stages before it. */
const order: readonly StageName[] = ['field', 'interval', 'classify', 'shade', 'gather'];

/** What may be added to each stage. */
const own: Record<StageName, readonly (keyof StageParts)[]> = {
  field: ['field', 'moreFields'],
  interval: ['intervals'],
  classify: ['classify'],
  shade: ['shades'],
  gather: ['gather'],
};

/** The stages before anything has been added to them. */
const nothing: Partial<StageParts> = { intervals: [], moreFields: [], shades: [] };

/**
 * Composes the stages of rays. Pictures, picks, checks and the reference of tests all use it.
 * @throws {TypeError} if nothing gives a stage that rays need, or if something gives parts of another stage than its own
 */
export function composeStages(givers: readonly StageGiver[], walk: RayWalk): RayStages {
  // The field with the values comes first.
  const first = givers.filter(({ stage, isSecond }) => stage === 'field' && !isSecond);
  const sorted = [
    ...first,
    ...order.flatMap((stage) => givers.filter((giver) => giver.stage === stage && !first.includes(giver))),
  ];
  const all = sorted.reduce((before, giver) => join(before, partsOf(giver, before)), nothing as StageParts);
  for (const stage of ['field', 'classify', 'gather'] as const) {
    if (!all[stage])
      throw new TypeError(`no module of the stage ${stage} has a twin: ${givers.map(({ name }) => name).join(', ')}`);
  }
  return { ...all, ...walk };
}

/** Only parts of its own stage may be given: else modules would act in another order than on the GPU. */
function partsOf(giver: StageGiver, before: StageParts): Partial<StageParts> {
  const { name, stage } = giver;
  const parts = giver.parts(before);
  const other = (Object.keys(parts) as (keyof StageParts)[]).find((key) => !own[stage].includes(key));
  if (other)
    throw new TypeError(
      `the twin of ${name} got "${other}"; expected what the stage ${stage} has: ${own[stage].join(' or ')}`,
    );
  return parts;
}

function join(
  before: StageParts,
  { intervals = [], moreFields = [], shades = [], ...single }: Partial<StageParts>,
): StageParts {
  return {
    ...before,
    ...single,
    intervals: [...before.intervals, ...intervals],
    moreFields: [...before.moreFields, ...moreFields],
    shades: [...before.shades, ...shades],
  };
}
