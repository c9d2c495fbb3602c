import outlines from '../../../shaders/chunks/attachments/outlines.glsl?raw';
import quadPlace from '../../../shaders/chunks/walk/quad-place.glsl?raw';
import type { Outline } from '../../optics/attachments/plane-outlines.ts';
import type { Uniforms } from '../device/inputs.ts';
import type { BetweenText } from './ray-module.ts';

/** A program has room for no more; of 128 vectors that WebGL 1 guarantees to vertices. */
const maxOutlines = 48;

/** Quads of pixels at the edges of planes get rays. */
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
