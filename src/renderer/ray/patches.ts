// Transfer functions of value and gradient: loaded with the first of them.
import { depthOfPatches } from '../../optics/patches.ts';
import type { Patch } from '../../optics/patches.ts';
import { loadLight } from './load-light.ts';
import { pointsModule } from './modules/lit.ts';
import { createPatches } from './modules/patches.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

/** Volumes of labels have no gradients. Where labels have transfer functions of their own, all go by value. */
export async function createPatched(patches: readonly Patch[], layer: StyledLayer): Promise<StyleModules> {
  const lightOf = await loadLight(layer);
  const made = createPatches(layer.gl, patches);
  const depth = depthOfPatches(patches);
  return {
    projects: false,
    modules: (others) => {
      const light = lightOf();
      return light && !others.some(({ name }) => name === 'labelFunctions') ? [pointsModule, made.of(light.options, light.surroundings)] : [];
    },
    seen: (more) => ({ ...more, jumps: [...(more?.jumps ?? []), depth] }),
    dispose: () => made.dispose(),
  };
}
