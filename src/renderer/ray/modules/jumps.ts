import finishColor from '../../../../shaders/chunks/gather/finish-color.glsl?raw';
import cubic from '../../../../shaders/chunks/field/cubic.glsl?raw';
import emptySpace from '../../../../shaders/chunks/walk/empty-space.glsl?raw';
import labelTurns from '../../../../shaders/chunks/attachments/label-turns.glsl?raw';
import jumpsChunk from '../../../../shaders/chunks/gather/jumps.glsl?raw';
import surfaceValuesChunk from '../../../../shaders/chunks/gather/surface-values.glsl?raw';
import voxelPlanes from '../../../../shaders/chunks/walk/voxel-planes.glsl?raw';
import walkParts from '../../../../shaders/chunks/walk/walk-parts.glsl?raw';
import { maxHalvings, maxHidden, maxHiddenAtLabels, maxLooks } from '../../../optics/surfaces/jump-gather.ts';
import { maxSurfaces } from '../../../optics/transfer/surface-limits.ts';
import { findOpaqueJumps } from '../../../optics/transfer/opaque-jumps.ts';
import { finestSpacing } from '../../../volume/grid.ts';
import { isPolar } from '../../../volume/volume.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import { Kept } from '../../device/kept.ts';
import type { Optics, RayModule, RayText, RayTwin } from '../ray-module.ts';
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
      MAX_HIDDEN_AT_LABELS: maxHiddenAtLabels,
      MIN_SHARE: 0.5 ** maxHalvings,
      MAX_LOOKS: maxLooks,
    },
    chunks: [surfaceValuesChunk, cubic, voxelPlanes, labelTurns, jumpsChunk, emptySpace, finishColor],
    samplers: compositeText.samplers,
  };
}

const jumpsTwin = (values: readonly number[]): RayTwin =>
  twinOf(usualTwins, ({ jumpGather }, { volume, rays }) => ({
    gather: jumpGather(values, finestSpacing(volume.finer?.grid ?? volume.grid) / rays.diameter),
  }));

/** Searches for places where a volume becomes opaque at once. */
export interface Jumps {
  /** The module that does it; none if there are no such values. */
  modulesFor(volume: VolumeData, optics: Optics): readonly RayModule[];
  dispose(): void;
}

/**
 * Emission and absorption on cartesian grids that also finds every place where a ray touches a value at which the volume becomes opaque
 * at once. Its modules for one volume differ only by their texts.
 */
export function createJumps(gl: Gl, device: Device): Jumps {
  const composite = createComposite(gl, device);
  const kept = new Kept<readonly RayModule[]>();
  const of = (values: readonly number[]): RayModule<'gather'> => ({
    ...jumpsText(values.length === 1),
    stage: 'gather',
    sparesRays: true,
    found: values,
    twin: jumpsTwin(values),
    // If segments are exact, the picture is exact too.
    order: Infinity,
    inputs: (frame) =>
      joinInputs(composite.inputs(frame), {
        uniforms: {
          uSurfaceValues: surfaceValues(values, frame),
          uVoxelLength: finestSpacing(frame.volume.finer?.grid ?? frame.volume.grid) / frame.rays.diameter,
        },
        units: [],
      }),
  });
  return {
    modulesFor: (volume, { transferFunction, referenceLength, opacityFactor }) => {
      const voxelRatio = (finestSpacing(volume.finer?.finest ?? volume.grid) / referenceLength) * opacityFactor;
      return kept.get([volume, transferFunction, voxelRatio], () => {
        const values = isPolar(volume) || volume.isDiscrete ? [] : findOpaqueJumps(transferFunction, voxelRatio);
        return values.length > 0 ? [of(values)] : [];
      });
    },
    dispose: () => composite.dispose!(),
  };
}
