import type { RayModule, StageName } from './ray-module.ts';

/** Stages that have one module. */
const single: readonly StageName[] = ['field', 'classify', 'gather'];

/** Of stages that have one module the last one counts. */
export function chooseModules(all: readonly RayModule[]): readonly RayModule[] {
  return all.filter((module, at) => module.members || !single.includes(module.stage) ||
    !all.slice(at + 1).some(({ stage, members }) => stage === module.stage && !members));
}
