// Where the frames of a segmentation lie: in one grid, which has all slices between the first and the last one.
import { add, dot, length, scale, subtract } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { Frame } from './frame.ts';
import { placeAlong } from './group-frames.ts';
import { gap, joinAxes, usualStep } from './stack-frames.ts';

/** What is known of the place of a slice with labels. */
export type LabelSlice = Pick<Frame, 'plane' | 'position' | 'spacing' | 'step' | 'columns' | 'rows'>;

export interface PlacedSegments<Slice> {
  readonly dimensions: Vector3;
  readonly indexToWorld: Matrix4;
  /** The slices that a frame is shown in: one, except where their distances differ. */
  slicesOf(frame: Slice): readonly number[];
  /** What is shown in another way than the file says, in words. */
  readonly left: readonly string[];
}

/** Frames closer together than this share of a pixel are of one slice, and slices may be so far from their places in an even stack. */
const [samePlace, even] = [0.01, 0.02];

/** Sideways shifts up to this share of a pixel are not seen. */
const sideways = 0.5;

/** Cosine of a quarter of a degree. */
const sameDirection = 1 - 1e-5;

/** More slices than any scan has. */
const maxSlices = 2 ** 14;

/**
 * Finds the grid of a segmentation. Slices without any segment may be missing in the file, also between others.
 * @param frames - at least one, in any order, several of them at one place
 * @param what - for messages
 * @throws {VolumeViewError} `format/unsupported`, `format/corrupt`
 */
export function placeSegments<Slice extends LabelSlice>(frames: readonly Slice[], what: string): PlacedSegments<Slice> {
  const [any] = frames;
  const { plane, columns, rows } = any;
  const alike = ({ plane: other, position }: LabelSlice): boolean =>
    position !== null &&
    other !== null &&
    dot(other.row, plane!.row) > sameDirection &&
    dot(other.column, plane!.column) > sameDirection;
  if (!plane || !frames.every(alike))
    throw unsupportedFile(
      what,
      'has frames of several orientations, or does not say where they lie; expected slices of one stack. Convert it: segimage2itkimage (dcmqi)',
    );
  const spacing = any.spacing ?? [1, 1];
  const pixel = Math.min(...spacing);
  const sorted = frames.map((frame) => ({ frame, place: placeAlong(frame, any)! }));
  sorted.sort((a, b) => a.place - b.place);
  /** The slices of the file, and for each frame the number of its own. */
  const slices: typeof sorted = [];
  const numberOf = new Map<Slice, number>();
  for (const [i, one] of sorted.entries()) {
    if (i === 0 || one.place - sorted[i - 1].place > samePlace * pixel) slices.push(one);
    numberOf.set(one.frame, slices.length - 1);
  }
  const places = slices.map(({ place }) => place);
  const [first, last] = [slices[0], slices[slices.length - 1]];
  const range = last.place - first.place;
  const guess = guessSteps(places, any.step);
  const stated = guess
    .map((step) => Math.max(1, Math.round(range / step)))
    .find((steps) => isEven(places, range / steps));
  const usual = Math.max(places.length > 1 ? usualStep(places) : 0, any.step ?? 0);
  const covered = sumWithoutGaps(places, usual);
  const most = 2 * (slices.length - 1) * (range / covered);
  const steps = range === 0 ? 0 : (stated ?? Math.round(Math.min(most, range / Math.min(...guess))));
  if (!(steps < maxSlices))
    throw corruptFile(
      what,
      `has ${slices.length} slices over ${Math.round(range).toLocaleString('en')} mm, ${guess[0].toLocaleString('en')} mm apart; expected at most ${maxSlices.toLocaleString('en')}`,
    );
  const lead = subtract(last.frame.position!, first.frame.position!);
  const step = steps === 0 ? scale(plane.normal, any.step ?? pixel) : scale(lead, 1 / steps);
  const indexOf = (place: number): number => (steps === 0 ? 0 : ((place - first.place) / range) * steps);
  for (const { frame, place } of sorted) {
    const straight = add(first.frame.position!, scale(step, indexOf(place)));
    if (length(subtract(frame.position!, straight)) > sideways * pixel)
      throw unsupportedFile(
        what,
        'has frames that do not lie above each other, as those of a microscope; expected slices of one stack',
      );
  }
  const isUneven = stated === undefined && steps > 0;
  const shown = isUneven
    ? nearestOf(places.map(indexOf), steps, (usual / range) * steps)
    : places.map((place) => [Math.round(indexOf(place))]);
  return {
    dimensions: [columns, rows, steps + 1],
    indexToWorld: joinAxes(first.frame, spacing, step),
    slicesOf: (frame) => shown[numberOf.get(frame)!],
    left: [
      ...(any.spacing ? [] : ['the size of a pixel, which the file does not say: 1 mm is taken']),
      ...(isUneven
        ? [`the slices are not evenly spaced: each of ${steps + 1} even ones has the labels of the nearest slice`]
        : []),
    ],
  };
}

/** What the distance of two slices may be, the most trusted one first. @param stated - by the file */
function guessSteps(places: readonly number[], stated: number | null): number[] {
  const apart = places.slice(1).map((place, i) => place - places[i]);
  apart.sort((a, b) => a - b);
  const found = apart.length > 0 ? [apart[0], apart[apart.length >> 1]] : [];
  return [...(stated ? [stated] : []), ...found];
}

/** How much of a stack has slices. */
function sumWithoutGaps(places: readonly number[], usual: number): number {
  return places
    .slice(1)
    .map((place, i) => place - places[i])
    .filter((step) => step <= gap * usual)
    .reduce((sum, step) => sum + step, 0);
}

function isEven(places: readonly number[], step: number): boolean {
  return places.every((place) => {
    const at = (place - places[0]) / step;
    return Math.abs(at - Math.round(at)) <= even;
  });
}

/**
 * For each of some places in ascending order, counted in slices, the even slices that are nearest to it. Where slices are missing, those
 * between have no label; none that is there is lost.
 */
function nearestOf(places: readonly number[], steps: number, usual: number): number[][] {
  const slices: number[][] = places.map(() => []);
  const apart = places.slice(1).map((place, i) => place - places[i]);
  for (let k = 0, at = 0; k <= steps; k++) {
    while (at + 1 < places.length && places[at + 1] - k < k - places[at]) at++;
    const step = apart[k < places[at] ? at - 1 : at] ?? 0;
    if (step <= gap * usual || Math.abs(k - places[at]) <= Math.max(1, usual) / 2) slices[at].push(k);
  }
  return slices;
}
