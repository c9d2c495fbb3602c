import { dataEnds } from './cast-ray.ts';
import type { SpanMeans } from '../transfer/emission.ts';
import { exactMeans } from '../transfer/exact-means.ts';
import { integrateForTable } from '../transfer/preintegration-table.ts';
import type { ClassifyStage, FieldStage } from './ray-stages.ts';
import { attenuate, countSubsteps } from './segment.ts';
import { buildSubstepTable } from '../transfer/substep-table.ts';
import type { SubstepTable } from '../transfer/substep-table.ts';
import { evaluate, largestOpacity } from '../transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../transfer/transfer-function.ts';

/** What a transfer function makes of values: worth keeping for many rays. */
export interface RayOptics {
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  readonly means: SpanMeans;
  readonly substeps: SubstepTable;
}

/**
 * @param transferFunction - brightened
 * @param voxelRatio - length of a voxel / reference length, times the opacity factor
 */
export function prepareOptics(transferFunction: TransferFunction, voxelRatio: number): RayOptics {
  return { transferFunction, means: exactMeans(transferFunction), substeps: buildSubstepTable(integrateForTable(transferFunction), voxelRatio) };
}

/**
 * A transfer function's means over spans of values: pre-integration.
 * @param opticalScale - reference lengths per bounding diameter, times the opacity factor
 * Twin: shaders/chunks/classify/classify.glsl
 */
export function transferFunctionClassify({ transferFunction, means, substeps }: RayOptics, field: FieldStage, opticalScale: number): ClassifyStage {
  const largest = largestOpacity(transferFunction);
  return {
    classifySegment: ({ front, back, span }) => {
      if (!front.valid && !back.valid) return [0, 0, 0, 0];
      const [from, to] = dataEnds(front, back);
      const ratio = span * opticalScale * (front.valid && back.valid ? 1 : 0.5);
      if (!field.isFolded(from, to)) return attenuate(means.mean(from, to), ratio);
      // Where a velocity folds in between, half of it is of either end.
      const [near, far] = [means.mean(from, from), means.mean(to, to)];
      return attenuate(near.map((x, c) => (x + far[c]) / 2) as Premultiplied, ratio);
    },
    classifyValue: (value) => evaluate(transferFunction, value).map((x) => x / largest) as Premultiplied,
    countSubsteps: (ends, visible) => countSubsteps(substeps, ends, visible),
  };
}
