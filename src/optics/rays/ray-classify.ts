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

/** What rays need of a transfer function. Keep it to cast many rays. */
export interface RayOptics {
  /** Already brightened. */
  readonly transferFunction: TransferFunction;
  readonly means: SpanMeans;
  readonly substeps: SubstepTable;
}

/**
 * @param transferFunction - already brightened
 * @param voxelRatio - length of a voxel / reference length, times the opacity factor
 */
export function prepareOptics(transferFunction: TransferFunction, voxelRatio: number): RayOptics {
  return {
    transferFunction,
    means: exactMeans(transferFunction),
    substeps: buildSubstepTable(integrateForTable(transferFunction), voxelRatio),
  };
}

/**
 * Classifies values by a transfer function's means over spans of values: pre-integration.
 * @param opticalScale - reference lengths per bounding diameter, times the opacity factor
 * Twin: shaders/chunks/classify/classify.glsl
 */
export function transferFunctionClassify(
  { transferFunction, means, substeps }: RayOptics,
  field: FieldStage,
  opticalScale: number,
): ClassifyStage {
  const largest = largestOpacity(transferFunction);
  return {
    classifySegment: ({ front, back, span }) => {
      if (!front.valid && !back.valid) return [0, 0, 0, 0];
      const [from, to] = dataEnds(front, back);
      const ratio = span * opticalScale * (front.valid && back.valid ? 1 : 0.5);
      if (!field.isFolded(from, to)) return attenuate(means.mean(from, to), ratio);
      // If a velocity folds in between, each end counts for half.
      const [near, far] = [means.mean(from, from), means.mean(to, to)];
      return attenuate(near.map((x, c) => (x + far[c]) / 2) as Premultiplied, ratio);
    },
    classifyValue: (value) => evaluate(transferFunction, value).map((x) => x / largest) as Premultiplied,
    countSubsteps: (ends, visible) => countSubsteps(substeps, ends, visible),
  };
}
