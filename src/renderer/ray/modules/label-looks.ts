import depths from '../../../../shaders/chunks/depth/depths.glsl?raw';
import looks from '../../../../shaders/chunks/attachments/label-looks.glsl?raw';
import type { RayModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Labels colour what is seen, and multiply its extinction. What it reads comes with the labels. */
export const labelLooks: RayModule<'shade'> = {
  name: 'labelLooks',
  stage: 'shade',
  defines: {},
  chunks: [depths, looks],
  samplers: [],
  sparesRays: true,
  // Where one thing begins and another ends is known to a part of a step.
  order: 1,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ labelShade }) => ({ shades: [labelShade] })),
};

/** The same where groups of labels have transfer functions of their own, which what classifies knows. */
export const groupLooks: RayModule<'shade'> = {
  ...labelLooks,
  twin: twinOf(usualTwins, ({ groupShade }, _, { classify, field }) => ({ shades: [groupShade(classify, field)] })),
};
