import box from '../../shaders/chunks/box.glsl?raw';
import decode from '../../shaders/chunks/decode.glsl?raw';
import ray from '../../shaders/chunks/ray.glsl?raw';
import volume3d from '../../shaders/chunks/volume-3d.glsl?raw';
import asPrinted from '../../shaders/study/as-printed.frag.glsl?raw';
import fetchedSamples from '../../shaders/study/fetched-samples.frag.glsl?raw';
import plainSamples from '../../shaders/study/plain-samples.frag.glsl?raw';
import shownSamples from '../../shaders/study/shown-samples.frag.glsl?raw';
import { composeRays, composeShader, composeStage, samplingChunks } from './compose.ts';
import type { ShaderTexts } from './compose.ts';
import type { ShaderFeatures } from './features.ts';

/**
 * What the accuracy study compares: the 2011 paper's method as printed, post-classified samples, and the ray-caster
 * that is shipped. Nothing of the package imports this.
 */
export type StudyMethod = 'printed' | 'plain' | 'shipped';

/** And what the benchmark holds it against: which samples show, and a loop that does nothing but fetch as many. */
export type StudyProgram = StudyMethod | 'shown' | 'fetched';

/** @param features - of a volume in a 3D texture; the paper's method reads 8-bit samples only */
export function composeStudyShader(program: StudyProgram, features: ShaderFeatures): ShaderTexts {
  if (program === 'shipped') return composeShader(features);
  const sampling = samplingChunks(features);
  const chunks = {
    printed: ['uniform vec3 uDimensions;\n', decode, volume3d, ray, box, asPrinted],
    plain: [...sampling, ray, box, plainSamples],
    shown: [...sampling, ray, box, shownSamples],
    fetched: [...sampling, ray, box, fetchedSamples],
  }[program];
  return {
    vertex: composeRays(features),
    fragment: composeStage(features, 'FRAGMENT_STAGE', chunks),
  };
}
