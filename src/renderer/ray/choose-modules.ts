import type { RayModule, StageName } from './ray-module.ts';

/** Stages that have exactly one module. */
const single: readonly StageName[] = ['field', 'classify', 'gather'];

/** Choose the modules of a ray: if several have the same name, or belong to a stage that has one module, the last one counts. */
export function chooseModules(all: readonly RayModule[]): readonly RayModule[] {
  return all.filter(
    (module, at) =>
      !all
        .slice(at + 1)
        .some(
          ({ name, stage, members }) =>
            name === module.name || (stage === module.stage && !members && !module.members && single.includes(stage)),
        ),
  );
}
