// Rays through volumes in which groups of labels have transfer functions of their own.
import { dataEnds } from './rays/cast-ray.ts';
import { groupOf, labelledEnds, labelShade, apply } from './attachments/labels.ts';
import type { LabelledSample } from './attachments/labels.ts';
import { transferFunctionClassify } from './rays/ray-classify.ts';
import type { RayOptics } from './rays/ray-classify.ts';
import type { ClassifyStage, FieldStage, RayStages, ShadeStage } from './rays/ray-stages.ts';
import type { RaySetup } from './rays/rays.ts';
import { opticsOf, stagesOf } from './reference.ts';
import type { ReferenceScene } from './reference.ts';
import { composite } from './rays/segment.ts';
import type { TransferFunction } from './transfer/transfer-function.ts';

/** The optics of each group's transfer function. @param scene - its own transfer function is replaced */
export function groupOptics(functions: readonly TransferFunction[], scene: ReferenceScene): RayOptics[] {
  return functions.map((transferFunction) => opticsOf({ ...scene, transferFunction }));
}

/** The stages of a scene's rays when groups of labels have transfer functions of their own. @param groups - by group from 1 */
export function groupedStagesOf(
  scene: ReferenceScene,
  setup: RaySetup,
  groups: readonly RayOptics[],
  own?: RayOptics,
): RayStages {
  const stages = stagesOf(scene, setup, own);
  const opticalScale = (setup.diameter * scene.opacityFactor) / scene.referenceLength;
  return groups.length > 0
    ? groupStages(
        stages,
        groups.map((one) => transferFunctionClassify(one, stages.field, opticalScale)),
      )
    : stages;
}

/**
 * Adds the transfer functions of groups of labels to stages.
 * @param others - the classification by each group's transfer function, by group from 1
 */
export function groupStages(stages: RayStages, others: readonly ClassifyStage[]): RayStages {
  const classify = groupClassify([stages.classify, ...others]);
  return {
    ...stages,
    classify,
    shades: stages.shades.map((shade) => (shade === labelShade ? groupShade(classify, stages.field) : shade)),
  };
}

/**
 * If a piece of a ray lies in one group, it has the means of that group's function. The function that needs the most substeps decides how
 * a step is cut.
 * @param all - by group from 0
 * Twin: shaders/chunks/classify/label-functions.glsl
 */
export function groupClassify(all: readonly ClassifyStage[]): ClassifyStage {
  return {
    classifySegment: (segment) => all[groupOf(labelledEnds(segment.front, segment.back)[0])].classifySegment(segment),
    classifyValue: all[0].classifyValue,
    countSubsteps: (ends, visible, samples) =>
      Math.max(...labelledEnds(...samples).map((end) => all[groupOf(end)].countSubsteps(ends, visible, samples))),
  };
}

/**
 * If the two ends of a piece of a ray are in different groups, each half is classified by itself. The values of each half end in the middle
 * between both ends.
 * Twin: shaders/chunks/attachments/label-looks.glsl
 */
export function groupShade(classify: ClassifyStage, field: FieldStage): ShadeStage {
  return (segment, seen, ray) => {
    const { front, back, begin, span } = segment;
    const [first, last] = labelledEnds(front, back);
    if (groupOf(first) === groupOf(last)) return labelShade(segment, seen, ray);
    const [from, to] = dataEnds(first, last);
    const isFolded = field.isFolded(from, to);
    const see = (end: LabelledSample): ReturnType<typeof apply> => {
      const middle = { ...end, value: isFolded ? end.value : (from + to) / 2 };
      return apply(classify.classifySegment({ front: end, back: middle, begin, span: span / 2 }), end.style, 1);
    };
    const both = see(first);
    composite(both, see(last));
    return both;
  };
}
