import outlines from '../../../shaders/chunks/attachments/outlines.glsl?raw';
import quadPlace from '../../../shaders/chunks/walk/quad-place.glsl?raw';
import type { Outline } from '../../optics/attachments/plane-outlines.ts';
import type { Uniforms } from '../device/inputs.ts';
import type { BetweenText } from './ray-module.ts';

/** The maximum number of outlines in a program: WebGL 1 guarantees only 128 uniform vectors to vertex shaders. */
const maxOutlines = 48;

/** Gives rays to the quads of pixels at the edges of planes. */
export const outlinesText: BetweenText = {
  defines: { MAX_OUTLINES: maxOutlines },
  chunks: [quadPlace, outlines],
  samplers: [],
  needsRays: 'meetsOutlines(place)',
};

export function outlineUniforms(outlines: readonly Outline[]): Uniforms {
  const numbers = outlines.length > maxOutlines ? [] : outlines.flat();
  return {
    uOutlines: [...numbers, ...Array.from({ length: 4 * maxOutlines - numbers.length }, () => 0)],
    uOutlineCount: outlines.length > maxOutlines ? -1 : outlines.length,
  };
}
