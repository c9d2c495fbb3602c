import type { LabelStyle, ShownLabels } from '../../volume/labels.ts';
import type { RayStages, Sample, SecondFieldStage, ShadeStage } from '../rays/ray-stages.ts';
import { composite } from '../rays/segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';
import { voteOfCorners } from '../rays/vote.ts';

/** What is known of a place of a labelled volume. */
export interface LabelledSample extends Sample {
  /** The label's id. */
  readonly label: number;
  readonly style: LabelStyle;
}

/** What labels add to rays. @param projects - whether these show values, to which neither opacity nor labels' colours matter */
export function labelStages(labels: ShownLabels, projects: boolean): Pick<RayStages, 'moreFields' | 'shades'> {
  return { moreFields: [labelField(labels, projects)], shades: projects ? [] : [labelShade] };
}

/**
 * The label of each place, by the vote of the eight voxels around it.
 * @param hides - what is hidden counts as without data, as it does to projections
 * Twin: shaders/chunks/attachments/labels.glsl
 */
export function labelField({ map, styles }: ShownLabels, hides = false): SecondFieldStage {
  return (place, known): LabelledSample => {
    const number = voteOfCorners(map.numbers, map.dimensions, place);
    const found = { ...known, label: map.ids[number], style: styles[number] };
    return hides && found.style.opacityFactor <= 0 ? { ...found, valid: false, value: NaN } : found;
  };
}

/**
 * Labels colour what is seen, and multiply its extinction. Where the ends of a piece of a ray have different looks, its front
 * half has that of its front end and its back half that of its back end. Beside a place without data there is one half alone.
 * Twin: shaders/chunks/attachments/label-looks.glsl
 */
export const labelShade: ShadeStage = ({ front, back }, seen) => {
  const [first, last] = labelledEnds(front, back).map(({ style }) => style);
  if (isAlike(first, last)) return wear(seen, first, 1);
  const both = wear(seen, first, 0.5);
  composite(both, wear(seen, last, 0.5));
  return both;
};

/** What is known of both ends of a piece of a ray, of which one stands for the other where that has no data. */
export function labelledEnds(front: Sample, back: Sample): [LabelledSample, LabelledSample] {
  return [(front.valid ? front : back) as LabelledSample, (back.valid ? back : front) as LabelledSample];
}

/** Whether a place's label hides it, where it has one. */
export function isHidden({ style }: Sample): boolean {
  return (style as LabelStyle | undefined)?.opacityFactor === 0;
}

/** Which of the labels' transfer functions a place has, from 1; 0 for the volume's own. */
export function groupOf({ style }: Sample): number {
  return (style as LabelStyle | undefined)?.group ?? 0;
}

function isAlike(a: LabelStyle, b: LabelStyle): boolean {
  return a.opacityFactor === b.opacityFactor && a.color.every((x, c) => x === b.color[c]);
}

/** What a share of a piece of a ray shows in a label's look: extinction times the factor, colours times the label's. */
export function wear([red, green, blue, alpha]: Premultiplied, { color, opacityFactor }: LabelStyle, share: number): Premultiplied {
  if (!(alpha > 0)) return [0, 0, 0, 0];
  const opacity = opacityFactor > 0 ? -Math.expm1(opacityFactor * share * Math.log1p(-alpha)) : 0;
  const ratio = opacity / alpha;
  return [red * color[0] * ratio, green * color[1] * ratio, blue * color[2] * ratio, opacity];
}
