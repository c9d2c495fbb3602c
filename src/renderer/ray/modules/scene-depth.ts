import needsRays from '../../../../shaders/chunks/walk/needs-rays.glsl?raw';
import quadPlace from '../../../../shaders/chunks/walk/quad-place.glsl?raw';
import sceneDepth from '../../../../shaders/chunks/depth/scene-depth.glsl?raw';
import { faint } from '../../../optics/rays/depth-jumps.ts';
import { DepthJumps } from '../../passes/depth-jumps.ts';
import type { Gl } from '../../device/device.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import type { RayText, Surfaces, SurfacesModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

export const sceneDepthText: RayText = {
  name: 'sceneDepth',
  stage: 'interval',
  defines: {},
  chunks: [sceneDepth],
  samplers: ['uSceneDepth'],
  between: {
    defines: {},
    chunks: [quadPlace, needsRays],
    samplers: ['uDepthJumps'],
    needsRays: 'needsRaysAtJumps(place, around)',
  },
};

const twin = twinOf(usualTwins, ({ shapeInterval }, { shapeT }) =>
  shapeT ? { intervals: [shapeInterval(shapeT)] } : {},
);

/** The scene's opaque shapes end rays. */
export function createSceneDepth(gl: Gl): SurfacesModule {
  let jumps: DepthJumps | null = null;
  return {
    ...sceneDepthText,
    stage: 'interval',
    sparesRays: true,
    twin,
    order: Infinity,
    inputs({ rays, surfaces, fades }): ProgramInputs {
      if (!surfaces) return { uniforms: {}, units: [] };
      const depth = depthInputs(surfaces, [rays.planeDepth, rays.diameter]);
      if (!surfaces.lattice.half)
        return { ...depth, units: [...depth.units, { ...depth.units[0], samplerName: 'uDepthJumps' }] };
      const units = (jumps ??= new DepthJumps(gl)).draw(rays, surfaces, depth);
      return { uniforms: { ...depth.uniforms, uFaint: fades ? faint : -1 }, units: [...depth.units, ...units] };
    },
    readJumps: () => jumps!.read(),
    dispose: () => jumps?.dispose(),
  };
}

/** Uniforms that say where a lattice's pixels are in the picture's depth buffer, and how to convert its values. */
export function depthInputs(
  {
    depths,
    projection,
    picture: { width, height },
    lattice: { stride, first, isCoarse },
  }: Omit<Surfaces, 'stepLength'>,
  uDepthToT: readonly [number, number],
): ProgramInputs {
  const shift = (begin: number): number => begin + 0.5 - 0.5 * stride;
  return {
    uniforms: {
      uPixelToDepth: [stride / width, stride / height, shift(first[0]) / width, shift(first[1]) / height],
      uDepthTerms: [projection[10], projection[11], projection[14], projection[15]],
      uDepthToT,
      // The ray's shift from the pixel's middle, if pixels have several rays: see edge-rays.ts.
      uRayShift: stride === 1 ? first.map((begin) => begin - Math.round(begin)) : [0, 0],
    },
    units: (isCoarse ? depths.solid : depths.all).units.slice(0, 1),
  };
}
