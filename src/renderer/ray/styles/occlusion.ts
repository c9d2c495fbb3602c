// Light with ambient occlusion. The first picture with it loads this file.
import { isPolar } from '../../../volume/volume.ts';
import { hasRoomFor } from '../has-room.ts';
import { AmbientRays } from '../modules/ambient.ts';
import { cutsOf } from '../modules/lit-cuts.ts';
import { createLight } from './light.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

const leftOut =
  'this device has no room for ambient occlusion in addition to shapes, a transfer function of steep stops, and labels or a layer. It is left out.';

/** A radar is only lit: its gates have no grid of cells. The light from all sides changes little from voxel to voxel, so samples are as for light. */
export function createOccludedLight(layer: StyledLayer): StyleModules {
  const light = createLight(layer);
  const rays = new AmbientRays(layer.gl, layer.device);
  return {
    ...light,
    modules: (others) => {
      const lit = light.modules(others);
      const fits = lit.length > 0 && !isPolar(layer.volume!) && hasRoomFor(leftOut, [...others, ...lit], layer.device);
      return fits ? [...lit, rays.module(cutsOf(layer.plan.cuts))] : lit;
    },
    dispose: () => {
      light.dispose();
      rays.dispose();
    },
  };
}
