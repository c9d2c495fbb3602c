// Transfer functions of groups of labels.
import { dataEnds } from './rays/cast-ray.ts';
import { groupOf, labelledEnds, labelShade, wear } from './attachments/labels.ts';
import type { LabelledSample } from './attachments/labels.ts';
import { transferFunctionClassify } from './rays/ray-classify.ts';
import type { RayOptics } from './rays/ray-classify.ts';
import type { ClassifyStage, FieldStage, RayStages, ShadeStage } from './rays/ray-stages.ts';
import type { RaySetup } from './rays/rays.ts';
import { opticsOf, stagesOf } from './reference.ts';
import type { ReferenceScene } from './reference.ts';
import { composite } from './rays/segment.ts';
import type { TransferFunction } from './transfer/transfer-function.ts';

/** What each group's transfer function makes of values. @param scene - whose own transfer function does not matter */
export function groupOptics(functions: readonly TransferFunction[], scene: ReferenceScene): RayOptics[] {
  return functions.map((transferFunction) => opticsOf({ ...scene, transferFunction }));
}

/** The stages of a scene's rays in which groups of labels have transfer functions of their own. @param groups - by group from 1 */
export function groupedStagesOf(scene: ReferenceScene, setup: RaySetup, groups: readonly RayOptics[], own?: RayOptics): RayStages {
  const stages = stagesOf(scene, setup, own);
  const opticalScale = (setup.diameter * scene.opacityFactor) / scene.referenceLength;
  return groups.length > 0 ? groupStages(stages, groups.map((one) => transferFunctionClassify(one, stages.field, opticalScale))) : stages;
}

/**
 * Stages in which groups of labels look as transfer functions of their own say.
 * @param others - what these make of values, by group from 1
 */
export function groupStages(stages: RayStages, others: readonly ClassifyStage[]): RayStages {
  const classify = groupClassify([stages.classify, ...others]);
  return { ...stages, classify, shades: stages.shades.map((shade) => (shade === labelShade ? groupShade(classify, stages.field) : shade)) };
}

/**
 * A piece of a ray in one group has its function's means. Steps are cut by the function that wants more of them.
 * @param all - by group from 0
 * Twin: shaders/chunks/classify/label-functions.glsl
 */
export function groupClassify(all: readonly ClassifyStage[]): ClassifyStage {
  return {
    classifySegment: (segment) => all[groupOf(labelledEnds(segment.front, segment.back)[0])].classifySegment(segment),
    classifyValue: all[0].classifyValue,
    countSubsteps: (ends, visible, samples) => Math.max(...labelledEnds(...samples).map((end) => all[groupOf(end)].countSubsteps(ends, visible, samples))),
  };
}

/**
 * Where the ends of a piece of a ray are of different groups, each half is classified by itself: its values run to the middle of both.
 * Twin: shaders/chunks/attachments/label-looks.glsl
 */
export function groupShade(classify: ClassifyStage, field: FieldStage): ShadeStage {
  return (segment, seen, ray) => {
    const { front, back, begin, span } = segment;
    const [first, last] = labelledEnds(front, back);
    if (groupOf(first) === groupOf(last)) return labelShade(segment, seen, ray);
    const [from, to] = dataEnds(first, last);
    const isFolded = field.isFolded(from, to);
    const see = (end: LabelledSample): ReturnType<typeof wear> => {
      const middle = { ...end, value: isFolded ? end.value : (from + to) / 2 };
      return wear(classify.classifySegment({ front: end, back: middle, begin, span: span / 2 }), end.style, 1);
    };
    const both = see(first);
    composite(both, see(last));
    return both;
  };
}
