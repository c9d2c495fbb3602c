import type { LabelStyle, ShownLabels } from '../../volume/labels.ts';
import type { RayStages, Sample, SecondFieldStage, ShadeStage } from '../rays/ray-stages.ts';
import { composite } from '../rays/segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';
import { voteOfCorners } from '../rays/vote.ts';

/** A sample of a labelled volume. */
export interface LabelledSample extends Sample {
  /** The label's id. */
  readonly label: number;
  readonly style: LabelStyle;
}

/**
 * The stages that labels add to rays.
 * @param projects - whether the rays are projections: these show values, so neither opacity nor the labels' colours matter
 */
export function labelStages(labels: ShownLabels, projects: boolean): Pick<RayStages, 'moreFields' | 'shades'> {
  return { moreFields: [labelField(labels, projects)], shades: projects ? [] : [labelShade] };
}

/**
 * The label of each place, by the vote of the eight voxels around it.
 * @param hides - whether hidden labels count as places without data, as they do for projections
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
 * Labels colour what is visible and multiply its extinction. If the two ends of a piece of a ray have different label styles, the
 * front half gets the style of the front end and the back half that of the back end. Next to a place without data, the other end's style
 * counts for both.
 * Twin: shaders/chunks/attachments/label-looks.glsl
 */
export const labelShade: ShadeStage = ({ front, back }, seen) => {
  const [first, last] = labelledEnds(front, back).map(({ style }) => style);
  if (isAlike(first, last)) return apply(seen, first, 1);
  const both = apply(seen, first, 0.5);
  composite(both, apply(seen, last, 0.5));
  return both;
};

/** The samples at both ends of a piece of a ray. If one end has no data, the other end stands for it. */
export function labelledEnds(front: Sample, back: Sample): [LabelledSample, LabelledSample] {
  return [(front.valid ? front : back) as LabelledSample, (back.valid ? back : front) as LabelledSample];
}

/** Whether the place has a label that is hidden. */
export function isHidden({ style }: Sample): boolean {
  return (style as LabelStyle | undefined)?.opacityFactor === 0;
}

/** The number of the labels' transfer function at this place, from 1; 0 for the volume's own. */
export function groupOf({ style }: Sample): number {
  return (style as LabelStyle | undefined)?.group ?? 0;
}

function isAlike(a: LabelStyle, b: LabelStyle): boolean {
  return a.opacityFactor === b.opacityFactor && a.color.every((x, c) => x === b.color[c]);
}

/** Applies a label's style to a share of a piece of a ray: extinction times the factor, colours times the label's colour. */
export function apply(
  [red, green, blue, alpha]: Premultiplied,
  { color, opacityFactor }: LabelStyle,
  share: number,
): Premultiplied {
  if (!(alpha > 0)) return [0, 0, 0, 0];
  const opacity = opacityFactor > 0 ? -Math.expm1(opacityFactor * share * Math.log1p(-alpha)) : 0;
  const ratio = opacity / alpha;
  return [red * color[0] * ratio, green * color[1] * ratio, blue * color[2] * ratio, opacity];
}
