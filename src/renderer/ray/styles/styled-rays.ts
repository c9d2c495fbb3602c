// X3D's rendering styles. The first volume with one of them loads this file.
import { rangeStyles } from '../../../optics/cells/style-detail.ts';
import type { StyleChain } from '../../../optics/transfer/volume-styles.ts';
import { pointsModule } from '../modules/points.ts';
import { hasRoom, StyledRays, withLight } from '../modules/styled.ts';
import { lightLayer } from './layer-light.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

/** @param isLit - whether the volume is lit too */
export function createStyled(
  chains: readonly StyleChain[],
  isLit: boolean | undefined,
  layer: StyledLayer,
): StyleModules {
  const lightOf = lightLayer(layer);
  const all = isLit ? withLight(chains) : chains;
  const rays = new StyledRays(layer.gl, all);
  return {
    projects: false,
    prepare: lightOf.prepare,
    modules: (others) => {
      const light = lightOf();
      return light && hasRoom(others, layer.device)
        ? [pointsModule, rays.module(light.options, light.surroundings)]
        : [];
    },
    seen: (more, appearance) => ({ ...more, style: rangeStyles(all, appearance) }),
    dispose: () => rays.dispose(),
  };
}
