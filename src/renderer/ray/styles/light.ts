// Light on a volume. The first lit volume loads this file.
import { rangeLight } from '../../../optics/cells/style-detail.ts';
import { createLit } from '../modules/lit.ts';
import { pointsModule } from '../modules/points.ts';
import { lightLayer } from './layer-light.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

/** Light. Volumes of labels have no gradients, so they have no surfaces that could face a light. */
export function createLight(layer: StyledLayer): StyleModules {
  const lightOf = lightLayer(layer);
  return {
    projects: false,
    prepare: lightOf.prepare,
    modules: () => {
      const light = lightOf();
      return light ? [pointsModule, createLit(light.options, light.surroundings)] : [];
    },
    seen: (more, appearance) => ({ ...more, style: rangeLight(appearance) }),
    dispose: () => {},
  };
}
