import cutOut from '../../../../shaders/chunks/cut-out.glsl?raw';
import planes from '../../../../shaders/chunks/plane-slices.glsl?raw';
import { minSliceOpacity } from '../../../optics/plane-slices.ts';
import type { PlaneSlice } from '../../../optics/plane-slices.ts';
import type { Uniforms } from '../../inputs.ts';
import type { RayText, SliceModule } from '../ray-module.ts';

export { planeInterval as twin } from '../../../optics/plane-slices.ts';

export const planesText: RayText = {
  name: 'planes',
  stage: 'interval',
  defines: { MIN_SLICE_OPACITY: minSliceOpacity.toExponential(1) },
  chunks: [cutOut, planes],
  samplers: [],
};

/** Whiter than any window is narrow: a window without a width is a threshold. */
const steepest = 1e30;

/** Planes through a volume end rays, and stand behind what is before them: grey by a window, or in the volume's colours. At most four. */
export function createPlanes(): SliceModule<PlaneSlice> {
  return {
    ...planesText,
    stage: 'interval',
    slices: [],
    sparesRays: false,
    order: Infinity,
    inputs({ domain }) {
      return { uniforms: planeUniforms(this.slices, domain), units: [] };
    },
  };
}

/** @param domain - the data values that are 0 and 1 of the transfer function's domain */
function planeUniforms(planes: readonly PlaneSlice[], [low, high]: readonly [number, number]): Uniforms {
  const fill = (numbers: readonly number[]): number[] => Array.from({ length: 16 }, (_, i) => numbers[i] ?? 0);
  return {
    uPlanes: fill(planes.flatMap(({ normal, offset }) => [...normal, offset])),
    uPlanePaints: fill(planes.flatMap(({ window }) => {
      if (!window) return [2, 0, 0, 0];
      const [black, white] = window.map((value) => (value - low) / (high - low));
      return [1, black, white > black ? 1 / (white - black) : steepest, 0];
    })),
  };
}
