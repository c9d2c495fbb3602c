import box from '../../../../shaders/chunks/walk/box.glsl?raw';
import region from '../../../../shaders/chunks/walk/region.glsl?raw';
import type { RayModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Rays run through the volume's bounds and the region's. What it reads comes with the rays. */
export const boxModule: RayModule<'interval'> = {
  name: 'box',
  stage: 'interval',
  defines: {},
  chunks: [box, region],
  samplers: [],
  // Opacity grows from 0 at its edges.
  sparesRays: true,
  order: Infinity,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ boxInterval }, { rays }) => ({ intervals: [boxInterval(rays)] })),
};
