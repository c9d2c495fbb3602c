import compositeWalk from '../../../../shaders/chunks/walk/composite-walk.glsl?raw';
import cubic from '../../../../shaders/chunks/field/cubic.glsl?raw';
import emptySpace from '../../../../shaders/chunks/walk/empty-space.glsl?raw';
import jumpsChunk from '../../../../shaders/chunks/gather/jumps.glsl?raw';
import surfaceValuesChunk from '../../../../shaders/chunks/gather/surface-values.glsl?raw';
import voxelPlanes from '../../../../shaders/chunks/walk/voxel-planes.glsl?raw';
import walkParts from '../../../../shaders/chunks/walk/walk-parts.glsl?raw';
import { maxHalvings, maxHidden, maxLooks } from '../../../optics/surfaces/jump-gather.ts';
import { maxSurfaces } from '../../../optics/transfer/surface-limits.ts';
import { finestSpacing } from '../../../volume/grid.ts';
import type { Device, Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import type { RayModule, RayText, RayTwin } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';
import { compositeText, createComposite } from './composite.ts';
import { surfaceValues } from './surface-values.ts';

/** @param isOne - whether there is only one value: the search for it costs less than for several */
export function jumpsText(isOne: boolean): RayText {
  return {
    name: 'jumps',
    stage: 'gather',
    walk: walkParts,
    defines: {
      ...compositeText.defines,
      SURFACE_COUNT: isOne ? 1 : maxSurfaces,
      MAX_HIDDEN: maxHidden,
      MIN_SHARE: 0.5 ** maxHalvings,
      MAX_LOOKS: maxLooks,
    },
    chunks: [emptySpace, surfaceValuesChunk, cubic, voxelPlanes, jumpsChunk, compositeWalk],
    samplers: compositeText.samplers,
  };
}

const twin = (values: readonly number[]): RayTwin =>
  twinOf(usualTwins, ({ jumpGather }, { volume, rays }) => ({
    gather: jumpGather(values, finestSpacing(volume.grid) / rays.diameter),
  }));

/**
 * Emission and absorption on cartesian grids that also finds every place where a ray touches a value at which the volume becomes opaque
 * at once. Its modules for one volume differ only by their texts.
 */
export function createJumps(
  gl: Gl,
  device: Device,
): { of(values: readonly number[]): RayModule<'gather'>; dispose(): void } {
  const composite = createComposite(gl, device);
  return {
    of: (values) => ({
      ...jumpsText(values.length === 1),
      stage: 'gather',
      sparesRays: true,
      twin: twin(values),
      // If segments are exact, the picture is exact too.
      order: Infinity,
      inputs: (frame) =>
        joinInputs(composite.inputs(frame), {
          uniforms: {
            uSurfaceValues: surfaceValues(values, frame),
            uVoxelLength: finestSpacing(frame.volume.grid) / frame.rays.diameter,
          },
          units: [],
        }),
    }),
    dispose: () => composite.dispose!(),
  };
}
