import compositeWalk from '../../../../shaders/chunks/composite-walk.glsl?raw';
import emptySpace from '../../../../shaders/chunks/empty-space.glsl?raw';
import gatheredPieces from '../../../../shaders/chunks/gathered-pieces.glsl?raw';
import jumpsChunk from '../../../../shaders/chunks/jumps.glsl?raw';
import crossings from '../../../../shaders/chunks/surface-crossings.glsl?raw';
import { surfaceRefinements, grazingProbes } from '../../../optics/surface-crossings.ts';
import { maxSurfaces } from '../../../optics/surface-limits.ts';
import type { Device, Gl } from '../../device.ts';
import { joinInputs } from '../../inputs.ts';
import type { RayModule, RayText } from '../ray-module.ts';
import { compositeText, createComposite } from './composite.ts';
import { kinkProbes, surfaceValues } from './surface-values.ts';

export { jumpGather as twin } from '../../../optics/jump-gather.ts';

/** @param isOne - one value alone, which takes less to look for than several */
export function jumpsText(isOne: boolean): RayText {
  return {
    name: 'jumps',
    stage: 'gather',
    defines: { ...compositeText.defines, LOOKS: 1, VALUES_ALONE: 1, SURFACE_COUNT: isOne ? 1 : maxSurfaces, KINKS: 1, SURFACE_REFINEMENTS: surfaceRefinements, GRAZING_PROBES: grazingProbes, KINK_PROBES: kinkProbes },
    chunks: [emptySpace, crossings, gatheredPieces, jumpsChunk, compositeWalk],
    samplers: compositeText.samplers,
  };
}

/** Emission and absorption that finds what is opaque at once wherever a ray touches it, on cartesian grids. Its modules for one volume differ by their texts alone. */
export function createJumps(gl: Gl, device: Device): { of(values: readonly number[]): RayModule<'gather'>; dispose(): void } {
  const composite = createComposite(gl, device);
  return {
    of: (values) => ({
      ...jumpsText(values.length === 1),
      stage: 'gather',
      sparesRays: true,
      // Of segments that are exact the picture is.
      order: Infinity,
      inputs: (frame) => joinInputs(composite.inputs(frame), { uniforms: { uSurfaceValues: surfaceValues(values, frame) }, units: [] }),
    }),
    dispose: () => composite.dispose!(),
  };
}
