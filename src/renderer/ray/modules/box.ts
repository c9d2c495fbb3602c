import box from '../../../../shaders/chunks/walk/box.glsl?raw';
import region from '../../../../shaders/chunks/walk/region.glsl?raw';
import type { RayModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Rays run through the volume's bounds and the region's bounds. The rays' own uniforms contain what it reads. */
export const boxModule: RayModule<'interval'> = {
  name: 'box',
  stage: 'interval',
  defines: {},
  chunks: [box, region],
  samplers: [],
  // At the edges of the box opacity grows from 0, so the picture does not jump.
  sparesRays: true,
  order: Infinity,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ boxInterval }, { rays }) => ({ intervals: [boxInterval(rays)] })),
};
