import points from '../../../../shaders/chunks/walk/points.glsl?raw';
import type { RayModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Adds its place to each sample. */
export const pointsModule: RayModule<'field'> = {
  name: 'points',
  stage: 'field',
  defines: {},
  members: ['vec3 point'],
  chunks: [points],
  samplers: [],
  sparesRays: true,
  order: Infinity,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ pointField }) => ({ moreFields: [pointField] })),
};
