import betweenPixels from '../../../shaders/chunks/depth/between-pixels.glsl?raw';
import betweenPixelsStage from '../../../shaders/programs/between-pixels.frag.glsl?raw';
import gathered from '../../../shaders/programs/gathered.frag.glsl?raw';
import wholePicture from '../../../shaders/programs/whole-picture.vert.glsl?raw';
import { composeStage } from './compose-stage.ts';
import type { ShaderTexts } from './compose-stage.ts';

/** Programs for pictures of any volume: `between` interpolates pixels, `gathered` shows a picture that has been drawn before. */
export type PictureProgram = 'between' | 'gathered';

/** The shader texts that draw a picture from another one. */
export function composePictureShader(program: PictureProgram, webgl2: boolean): ShaderTexts {
  const chunks = { between: [betweenPixels, betweenPixelsStage], gathered: [gathered] }[program];
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE' }, chunks),
  };
}
