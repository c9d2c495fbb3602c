import sceneDepth from '../../../../shaders/chunks/scene-depth.glsl?raw';
import type { ProgramInputs } from '../../inputs.ts';
import type { RayModule } from '../ray-module.ts';

export { shapeInterval as twin } from '../../../optics/ray-intervals.ts';

/** The scene's opaque shapes end rays. */
export const sceneDepthModule: RayModule<'interval'> = {
  name: 'sceneDepth',
  stage: 'interval',
  defines: {},
  chunks: [sceneDepth],
  samplers: ['uSceneDepth'],
  sparesRays: false,
  order: Infinity,
  inputs({ rays, surfaces }): ProgramInputs {
    if (!surfaces) return { uniforms: {}, units: [] };
    const { depth, projection, picture: { width, height }, lattice: { stride, first } } = surfaces;
    const shift = (begin: number): number => begin + 0.5 - 0.5 * stride;
    return {
      uniforms: {
        // Where a lattice's pixels lie in the picture's depth buffer, and what its values mean.
        uPixelToDepth: [stride / width, stride / height, shift(first[0]) / width, shift(first[1]) / height],
        uDepthTerms: [projection[10], projection[11], projection[14], projection[15]],
        uDepthToT: [rays.planeDepth, rays.diameter],
      },
      units: depth.units.slice(0, 1),
    };
  },
};
