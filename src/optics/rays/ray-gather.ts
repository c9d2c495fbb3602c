import { dataEnds } from './cast-ray.ts';
import type { GatherStage } from './ray-stages.ts';
import { composite } from './segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/** Emission and absorption, front to back. Twin: shaders/chunks/gather/composite.glsl */
export const compositeGather: GatherStage = ({ classify, seeSegment }) => {
  const gathered: Premultiplied = [0, 0, 0, 0];
  return {
    add: (segment) => composite(gathered, seeSegment(segment)),
    chooseSubsteps: (front, back) => classify.countSubsteps(dataEnds(front, back), 1 - gathered[3], [front, back]),
    finish: () => gathered,
  };
};
