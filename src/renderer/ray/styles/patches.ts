// Transfer functions of value and gradient. The first of them loads this file.
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import { contributionOfGradients } from '../../../optics/cells/patch-cells.ts';
import { depthOfPatches } from '../../../optics/transfer/patches.ts';
import type { Patch } from '../../../optics/transfer/patches.ts';
import { Kept } from '../../device/kept.ts';
import { lightLayer } from './layer-light.ts';
import { pointsModule } from '../modules/points.ts';
import { createPatches } from '../modules/patches.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

/** Volumes of labels have no gradients. If labels have their own transfer functions, only values count for all of them. */
export async function createPatched(patches: readonly Patch[], layer: StyledLayer): Promise<StyleModules> {
  const lightOf = lightLayer(layer);
  const made = createPatches(layer.gl, patches);
  const depth = depthOfPatches(patches);
  const byGradient = new Kept<Contribution>();
  return {
    projects: false,
    prepare: lightOf.prepare,
    modules: (others) => {
      const light = lightOf();
      return light && !others.some(({ name }) => name === 'labelFunctions')
        ? [pointsModule, made.of(light.options, light.surroundings)]
        : [];
    },
    // A separate contribution, in addition to that of values: cells that are empty for different reasons can't be skipped together.
    contributions: (all, optics) => {
      const shows = all.flatMap((module) => module.contributes?.(optics) ?? []);
      return all.some(({ name }) => name === 'patches')
        ? [...shows, byGradient.get([layer.volume], () => contributionOfGradients(patches, layer.volume!))]
        : shows;
    },
    seen: (more) => ({ ...more, jumps: [...(more?.jumps ?? []), depth] }),
    dispose: () => made.dispose(),
  };
}
