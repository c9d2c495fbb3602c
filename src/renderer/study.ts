import box from '../../shaders/chunks/walk/box.glsl?raw';
import decode from '../../shaders/chunks/field/decode.glsl?raw';
import ray from '../../shaders/chunks/walk/ray.glsl?raw';
import volume3d from '../../shaders/chunks/field/volume-3d.glsl?raw';
import asPrinted from '../../shaders/study/as-printed.frag.glsl?raw';
import fetchedSamples from '../../shaders/study/fetched-samples.frag.glsl?raw';
import plainSamples from '../../shaders/study/plain-samples.frag.glsl?raw';
import shownSamples from '../../shaders/study/shown-samples.frag.glsl?raw';
import values from '../../shaders/chunks/field/values.glsl?raw';
import { composeStage } from './device/compose-stage.ts';
import type { Defines, ShaderTexts } from './device/compose-stage.ts';
import { composeRay, composeRays, fieldChunks, maxSteps } from './ray/compose-ray.ts';
import type { RayProgram } from './ray/compose-ray.ts';
import { maxSubsteps } from '../optics/transfer/substep-limits.ts';

/**
 * The methods that the accuracy study compares: the 2011 paper's method as printed, post-classified samples, and the ray-caster
 * that the package ships. No file of the package imports this one.
 */
export type StudyMethod = 'printed' | 'plain' | 'shipped';

/** Also the programs that the benchmark compares: one that draws only the samples that show, and a loop that only fetches as many samples. */
export type StudyProgram = StudyMethod | 'shown' | 'fetched';

/** @param shipped - the ray program for a volume in a 3D texture; the paper's method reads 8-bit samples only */
export function composeStudyShader(program: StudyProgram, shipped: RayProgram): ShaderTexts {
  if (program === 'shipped') return composeRay(shipped);
  const { webgl2, modules } = shipped;
  // All chunks of the classify stage except the last one, which computes the colour of a segment.
  const means = modules
    .filter(({ stage }) => stage === 'classify')
    .at(-1)!
    .chunks.slice(0, -1);
  const sampling = [...fieldChunks(modules), ...means];
  const chunks = {
    printed: [values, decode, volume3d, ray, box, asPrinted],
    plain: [...sampling, ray, box, plainSamples],
    shown: [...sampling, ray, box, shownSamples],
    fetched: [...sampling, ray, box, fetchedSamples],
  }[program];
  const defines = Object.assign(
    { MAX_SAMPLES: maxSteps * maxSubsteps },
    ...modules.map((module) => module.defines),
  ) as Defines;
  return {
    vertex: composeRays({ webgl2, adaptive: false, modules }),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines }, chunks),
  };
}
