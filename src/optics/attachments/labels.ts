import type { LabelMap, LabelStyle, ShownLabels } from '../../volume/labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { innerBounds, turnOfCubic } from '../rays/cubic.ts';
import type { CubicValues } from '../rays/cubic.ts';
import type { RayStages, Sample, SecondFieldStage, ShadeStage } from '../rays/ray-stages.ts';
import { composite } from '../rays/segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';
import { countVotes, electCorner, voteOfCorners, weighCorners } from '../rays/vote.ts';

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
  const sampleAt = (place: Vector3, known: Sample): Sample => {
    const number = voteOfCorners(map.numbers, map.dimensions, place);
    const style = styles[number];
    known.label = map.ids[number];
    known.style = style;
    return hides && style.opacityFactor <= 0 ? { ...known, valid: false, value: NaN } : known;
  };
  return Object.assign(sampleAt, { turnBetween: (from: Vector3, to: Vector3) => labelTurn(map, from, to) });
}

/** A label needs more than this share of the votes to win against another one, or against two others. */
const wins = { againstOne: 1 / 2, againstTwo: 1 / 3 } as const;

/**
 * Where a ray may meet a label although it meets it at neither end of a way. If both ends have the same label, that is where the others
 * together have the most votes; if not, where the labels of both ends have as many votes as each other. Between two planes of voxels'
 * centres votes are cubics of the length.
 * @param from, to - places of the unit cube, between the same planes of voxels' centres
 * @returns a share of the way; null where no other label can win
 * Twin: shaders/chunks/attachments/label-turns.glsl
 */
export function labelTurn({ numbers, dimensions }: LabelMap, from: Vector3, to: Vector3): number | null {
  const [begin, end] = [from, to].map((place) =>
    place.map((x, axis) => Math.min(Math.max(x * dimensions[axis] - 0.5, 0), dimensions[axis] - 1)),
  );
  const low = begin.map((x, axis) => Math.floor((x + end[axis]) / 2));
  const corners = Array.from({ length: 8 }, (_, c) => {
    const [i, j, k] = low.map((x, axis) => Math.min(dimensions[axis] - 1, x + ((c >> axis) & 1)));
    return numbers[i + dimensions[0] * (j + dimensions[1] * k)];
  });
  if (corners.every((label) => label === corners[0])) return null;
  const weightsAt = [0, 1 / 3, 2 / 3, 1].map((t) =>
    weighCorners(begin.map((x, axis) => x + t * (end[axis] - x) - low[axis]) as unknown as Vector3),
  );
  const [first, last] = [weightsAt[0], weightsAt[3]].map((weights) => electCorner(corners, weights));
  const countAlong = (counts: (label: number) => boolean): CubicValues =>
    weightsAt.map((weights) => countVotes(weights, (c) => counts(corners[c]))) as unknown as CubicValues;
  const others = countAlong((label) => label !== first && label !== last);
  const max = Math.max(others[0], others[3], ...innerBounds(others));
  if (max <= (first === last ? wins.againstOne : wins.againstTwo)) return null;
  if (first === last) {
    const top = turnOfCubic(others, 1);
    return top > 0 && top < 3 ? top / 3 : 1 / 2;
  }
  const [ones, theirs] = [countAlong((label) => label === first), countAlong((label) => label === last)];
  return crossZero(ones.map((votes, i) => votes - theirs[i]) as unknown as CubicValues);
}

/** About where a cubic that is positive at first and negative at last is 0: a share of its way. */
function crossZero(values: CubicValues): number {
  const i = values[1] <= 0 ? 0 : values[2] <= 0 ? 1 : 2;
  const share = values[i] / Math.max(1e-9, values[i] - values[i + 1]);
  return (i + Math.min(1, Math.max(0, share))) / 3;
}

/**
 * Labels colour what is visible and multiply its extinction. If the two ends of a piece of a ray have different label styles, the
 * front half gets the style of the front end and the back half that of the back end. Next to a place without data, the other end's style
 * counts for both.
 * Twin: shaders/chunks/attachments/label-appearances.glsl
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

/** Whether two labelled samples belong to things that let different amounts of light through, or have different functions. */
export function differsInStyle({ style: a }: Sample, { style: b }: Sample): boolean {
  const [one, other] = [a, b] as readonly (LabelStyle | undefined)[];
  return one !== other && (one?.opacityFactor !== other?.opacityFactor || (one?.group ?? 0) !== (other?.group ?? 0));
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
