import gathered from '../../../shaders/programs/gathered.frag.glsl?raw';
import wholePicture from '../../../shaders/programs/whole-picture.vert.glsl?raw';
import { composeStage } from './compose-stage.ts';
import type { ShaderTexts } from './compose-stage.ts';

/** The chunks that show a picture that has been drawn before. */
export const gatheredPicture: readonly string[] = [gathered];

/** The shader texts that draw a picture from another one. @param chunks - of the fragment shader */
export function composePictureShader(chunks: readonly string[], webgl2: boolean): ShaderTexts {
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE' }, chunks),
  };
}
