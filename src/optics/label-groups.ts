// Rays through volumes in which groups of labels have transfer functions of their own.
import { dataEnds } from './rays/cast-ray.ts';
import { groupOf, labelledEnds, labelShade, apply } from './attachments/labels.ts';
import type { LabelledSample } from './attachments/labels.ts';
import type { ClassifyStage, FieldStage, ShadeStage } from './rays/ray-stages.ts';
import { composite } from './rays/segment.ts';

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
 * Twin: shaders/chunks/attachments/label-appearances.glsl
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
