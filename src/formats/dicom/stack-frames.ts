// Where the frames of a volume lie in the world, and whether some are missing between them.
import { axialIndexToWorld } from '../../volume/grid.ts';
import { add, length, scale, subtract } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { Frame } from './frame.ts';
import { placeAlong } from './group-frames.ts';

export interface Stack {
  /** In their order; null where a slice is missing. */
  readonly slices: readonly (Frame | null)[];
  readonly indexToWorld: Matrix4;
  /** Whether the files say where the patient's left and right are. */
  readonly anatomical: boolean;
  /** Set where the distances of the slices differ: for each slice that is to be made, its place among those that are there; NaN in a gap. */
  readonly resample?: readonly number[];
  /** What of this the picture shows in another way than the files say, in words. */
  readonly left: readonly string[];
}

/**
 * Slices may be so far from their places in an even stack, as a share of the distance of two slices: scanners write places
 * in tenths of a millimetre.
 */
const even = 0.02;

/** Distances up to so many times the thickness of a slice leave nothing out: files round both. */
const thicker = 1.1;

/** At most so many times as many slices as there are, and a few more, may be missing. */
const maxMissing = { times: 3, more: 16 };

/** Slices that lie further apart than so many times their thickness, and the usual step, have a gap between them. One may be lost. */
export const gap = 2.5;

/** Slices that are made of others are at most so many times as many. */
const maxResampled = 2;

/** Sideways shifts up to this share of a pixel are not worth words. */
const sideways = 0.5;

/**
 * Puts frames into one grid. The third axis leads from the first slice to the last one: where slices are shifted against
 * each other evenly, as those of a tilted gantry are, the grid is sheared, and no value is changed.
 * @param frames - at least one, with at most one at each place, in ascending order
 * @throws {VolumeViewError} `format/corrupt` where slices are too far apart
 */
export function stackFrames(frames: readonly Frame[]): Stack {
  const [first] = frames;
  const { plane, position } = first;
  const spacing = first.spacing ?? [1, first.aspect];
  const left = first.spacing ? [] : ['the size of a pixel, which the file does not say: 1 mm is taken'];
  if (!plane || !position) return stackInOrder(frames, spacing, left);
  const places = frames.map((frame) => placeAlong(frame, first)!);
  const count = frames.length;
  const range = places[count - 1] - places[0];
  if (count === 1) {
    const step = scale(plane.normal, first.step ?? Math.min(...spacing));
    return { slices: frames, indexToWorld: joinAxes(first, spacing, step), anatomical: first.ofPatient, left };
  }
  const lead = subtract(frames[count - 1].position!, position);
  const indices = findIndices(places);
  if (indices && !areGapsCovered(frames, places, indices)) {
    const total = indices[count - 1] + 1;
    checkMissing(count, total, range);
    const slices: (Frame | null)[] = Array.from({ length: total }, () => null);
    frames.forEach((frame, i) => (slices[indices[i]] = frame));
    const step = scale(lead, 1 / (total - 1));
    const missing = total - count;
    return {
      slices,
      indexToWorld: joinAxes(first, spacing, step),
      anatomical: first.ofPatient,
      left: [
        ...left,
        ...(missing > 0
          ? [
              `${missing.toLocaleString('en')} of ${total.toLocaleString('en')} slices are missing between the others, and shown as no data`,
            ]
          : []),
        ...describeShift(frames, indices, step, spacing),
      ],
    };
  }
  const reach = reachOver(frames, places);
  const steps = places.slice(1).map((place, i) => place - places[i]);
  const whole = steps.filter((_, i) => reach[i] === null);
  const gaps = steps.filter((_, i) => reach[i] !== null);
  const [least, largest] = [Math.min(...whole), Math.max(...whole)];
  const covered = whole.reduce((sum, step) => sum + step, 0);
  const made = Math.min(maxResampled * count, Math.round(covered / least) + 1);
  const finest = (maxResampled * count - 1) * (range / covered);
  const total = Math.round(Math.min(finest, range / least)) + 1;
  checkMissing(made, total, range);
  const step = scale(lead, 1 / (total - 1));
  const resample = resamplePlaces(places, total, reach);
  return {
    slices: frames,
    indexToWorld: joinAxes(first, spacing, step),
    anatomical: first.ofPatient,
    resample,
    left: [
      ...left,
      `the slices are ${[...new Set([least, largest].map(sayLength))].join(' to ')} mm apart: values are computed between them (linearly) for ${total} slices ${sayLength(range / (total - 1))} mm apart`,
      ...(gaps.length > 0
        ? [
            `${gaps.length > 1 ? `${gaps.length} gaps of up to` : 'a gap of'} ${sayLength(Math.max(...gaps))} mm between the slices, shown as no data`,
          ]
        : []),
      ...describeShift(
        frames,
        places.map((place) => ((place - places[0]) / range) * (total - 1)),
        step,
        spacing,
      ),
    ],
  };
}

/** @throws {VolumeViewError} `format/corrupt` where many more are missing than are there */
function checkMissing(count: number, total: number, range: number): void {
  if (total <= (1 + maxMissing.times) * count + maxMissing.more) return;
  throw corruptFile(
    'the DICOM series',
    `has ${count} slices over ${Math.round(range).toLocaleString('en')} mm, of which ${(total - count).toLocaleString('en')} are missing between the others; expected the files of one scan. Choose them alone`,
  );
}

/** Slices without places, in the order of their numbers. */
function stackInOrder(frames: readonly Frame[], spacing: readonly [number, number], left: readonly string[]): Stack {
  const [{ columns, rows, step }] = frames;
  const apart = step ?? Math.min(...spacing);
  return {
    slices: frames,
    indexToWorld: axialIndexToWorld([columns, rows, frames.length], [...spacing, apart]),
    anatomical: false,
    left: [
      ...left,
      ...(frames.length > 1
        ? [
            `where the slices lie, which the files do not say: they are shown in the order of their numbers, ${sayLength(apart)} mm apart`,
          ]
        : []),
    ],
  };
}

/** The affine of a grid, in our world: x to the right and y to the front, where DICOM's go to the left and to the back. */
export function joinAxes(
  { plane, position }: Pick<Frame, 'plane' | 'position'>,
  [dx, dy]: readonly [number, number],
  step: Vector3,
): Matrix4 {
  const [i, j, k, origin] = [scale(plane!.row, dx), scale(plane!.column, dy), step, position!];
  return [-i[0], -j[0], -k[0], -origin[0], -i[1], -j[1], -k[1], -origin[1], i[2], j[2], k[2], origin[2], 0, 0, 0, 1];
}

/** The numbers of slices in an even stack, in which some may be missing; null where they are not even. */
function findIndices(places: readonly number[]): readonly number[] | null {
  const [start] = places;
  const last = places.length - 1;
  const range = places[last] - start;
  const steps = places.slice(1).map((place, i) => place - places[i]);
  steps.sort((a, b) => a - b);
  for (const guess of [range / last, steps[steps.length >> 1], steps[0]]) {
    const total = Math.round(range / guess);
    const step = range / total;
    const indices = places.map((place) => Math.round((place - start) / step));
    const isEven = indices.every(
      (index, i) => Math.abs(places[i] - start - index * step) <= even * step && (i === 0 || index > indices[i - 1]),
    );
    if (isEven) return indices;
  }
  return null;
}

/**
 * Whether nothing is missing where slices lie further apart than others, as these are thicker: heads are scanned in 5 mm, and
 * above in 10 mm. Where all are equally thick, as of a scan with overlaps, a slice is missing.
 */
function areGapsCovered(frames: readonly Frame[], places: readonly number[], indices: readonly number[]): boolean {
  const thick = frames.map(({ thickness }) => thickness ?? 0);
  const usual = thicker * Math.min(...thick);
  const gaps = indices.flatMap((index, i) => (i > 0 && index - indices[i - 1] > 1 ? [i] : []));
  return (
    gaps.length > 0 &&
    gaps.every((i) => {
      const covered = Math.max(thick[i - 1], thick[i]);
      return covered > usual && places[i] - places[i - 1] <= thicker * covered;
    })
  );
}

/**
 * For each step from slice to slice null, or where it is a gap, such as that between two slabs, how far into it slices are shown: half
 * of their thickness, or of the usual step.
 */
function reachOver(frames: readonly Frame[], places: readonly number[]): (number | null)[] {
  const isThickKnown = frames.every(({ thickness }) => thickness !== null);
  const usual = usualStep(places, isThickKnown ? 1 / 2 : most);
  return places.slice(1).map((place, i) => {
    const step = place - places[i];
    const covered = Math.max(usual, frames[i].thickness ?? 0, frames[i + 1].thickness ?? 0);
    return step > gap * covered ? covered / 2 : null;
  });
}

/** The share of steps that are none longer than the usual one: of two scans that lie between each other, every other step is long. */
const most = 3 / 4;

/** A step that so many of all are not longer than. @param places - in ascending order */
export function usualStep(places: readonly number[], share = most): number {
  const steps = places.slice(1).map((place, i) => place - places[i]);
  steps.sort((a, b) => a - b);
  return steps[Math.floor(share * (steps.length - 1))];
}

/** For each slice of an even stack, its place among uneven ones: 1.25 lies after a quarter of the way from the second to the third. */
function resamplePlaces(places: readonly number[], total: number, reach: readonly (number | null)[]): number[] {
  const last = places.length - 1;
  const [start, end] = [places[0], places[last]];
  // No slice between two gaps is lost between two that are made.
  const half = (0.5001 * (end - start)) / (total - 1);
  let before = 0;
  return Array.from({ length: total }, (_, k) => {
    const place = start + (k / (total - 1)) * (end - start);
    while (before < last - 1 && places[before + 1] <= place) before++;
    const reached = reach[before];
    const near = Math.max(reached ?? 0, half);
    if (reached !== null)
      return place - places[before] <= near ? before : places[before + 1] - place <= near ? before + 1 : NaN;
    return Math.min(last, before + (place - places[before]) / (places[before + 1] - places[before]));
  });
}

/** Slices that do not lie on the line from the first one to the last one are drawn as if they did. */
function describeShift(
  frames: readonly Frame[],
  indices: readonly number[],
  step: Vector3,
  spacing: readonly [number, number],
): string[] {
  const origin = frames[0].position!;
  const shift = Math.max(
    ...frames.map(({ position }, i) => length(subtract(position!, add(origin, scale(step, indices[i]))))),
  );
  const limit = Math.max(sideways * Math.min(...spacing), even * length(step));
  return shift > limit
    ? [`slices that are up to ${sayLength(shift)} mm away from their places in a straight stack`]
    : [];
}

function sayLength(millimetres: number): string {
  return String(Number(millimetres.toPrecision(4)));
}
