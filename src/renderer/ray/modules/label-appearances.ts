import depths from '../../../../shaders/chunks/depth/depths.glsl?raw';
import looks from '../../../../shaders/chunks/attachments/label-appearances.glsl?raw';
import type { RayModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** Labels colour a segment, and multiply its extinction. The label module provides the inputs. */
export const labelAppearances: RayModule<'shade'> = {
  name: 'labelAppearances',
  stage: 'shade',
  defines: {},
  chunks: [depths, looks],
  samplers: [],
  sparesRays: true,
  // The place of a boundary between two labels is known only to a part of a step.
  order: 1,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ labelShade }) => ({ shades: [labelShade] })),
};

/** The same if groups of labels have their own transfer functions, which the classify module applies. */
export const groupAppearances: RayModule<'shade'> = {
  ...labelAppearances,
  twin: twinOf(usualTwins, ({ groupShade }, _, { classify, field }) => ({ shades: [groupShade(classify, field)] })),
};
