import type { RayModule, StageName } from './ray-module.ts';

/** Stages that have one module. */
const single: readonly StageName[] = ['field', 'classify', 'gather'];

/** Of stages that have one module the last one counts, and so it does of modules of one name. */
export function chooseModules(all: readonly RayModule[]): readonly RayModule[] {
  return all.filter((module, at) => !all.slice(at + 1).some(({ name, stage, members }) =>
    name === module.name || (stage === module.stage && !members && !module.members && single.includes(stage))));
}
