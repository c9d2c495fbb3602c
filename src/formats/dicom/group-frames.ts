// Which frames make the volume: those of one series, orientation, pixel spacing and size, one at each place.
import { invalidAttribute } from '../../core/errors.ts';
import { dot, length, subtract } from '../../volume/matrix.ts';
import type { Budget } from '../base/budget.ts';
import { findPhases, listTimes } from './find-phases.ts';
import type { Phases } from './find-phases.ts';
import type { Frame, Plane } from './frame.ts';

export interface ChosenFrames {
  /** With at most one at each place, in their order along the normal; without places, in the order of their numbers. */
  readonly frames: readonly Frame[];
  /** What of the files is not among them, in words. */
  readonly left: readonly string[];
  /** Where places were measured several times: all of them, of which `frames` are one, and what of the files is not among these. */
  readonly phases?: Phases & { readonly left: readonly string[] };
}

const sameDirection = 1 - 1e-5; // Cosine of a quarter of a degree.
const sameSpacing = 1e-3; // Share of the spacing.
/** Steps from slice to slice differ by less than this share of their length. */
const sameStep = 0.1;
/** Places closer together than this share of a pixel are one. */
const samePlace = 0.01;

/** Frames of which one series is chosen. */
export interface ChosenSeries extends ChosenFrames {
  /** Of each series its frames; in the order of the scanner's numbers, and those that only show where slices lie last. */
  readonly series: readonly (readonly Frame[])[];
}

/**
 * Chooses a group of frames, and of those one at each place.
 * @param wanted - which one, from 1; the one with the most voxels where undefined
 * @param before - so many volumes of other files are counted before them
 * @throws {VolumeViewError} `attribute/invalid` where there are fewer
 */
export function chooseFrames(
  frames: readonly Frame[],
  budget: Budget,
  { wanted, before = 0 }: { readonly wanted?: number; readonly before?: number } = {},
): ChosenSeries {
  const groups = groupFrames(frames, budget);
  const isScan = (group: readonly Frame[]): boolean => !group.every(({ isLocalizer }) => isLocalizer);
  groups.sort(
    (a, b) =>
      Number(isScan(b)) - Number(isScan(a)) ||
      compareNumbers(a[0].seriesNumber, b[0].seriesNumber) ||
      compareNumbers(findStart(a), findStart(b)),
  );
  const scans = groups.filter(isScan);
  const series = groups.map((group) => ({ group, ...takeOnePerPlace(group) }));
  const candidates = scans.length > 0 ? series.slice(0, scans.length) : series;
  const all = before + series.length;
  if (wanted !== undefined && wanted > all)
    throw invalidAttribute(
      'series',
      String(wanted),
      all > 1
        ? `a number from 1 to ${all}, as the files hold ${all} ${before > 0 ? 'volumes' : 'series'}`
        : '1, as the files hold one series',
    );
  // Pictures in colours are mostly reports of a scan, or pictures of it.
  const gray = candidates.filter(({ group: [{ picture }] }) => !picture.colors);
  const chosen = wanted
    ? series[wanted - before - 1]
    : (gray.length > 0 ? gray : candidates).reduce((best, one) =>
        countVoxels(one.frames) > countVoxels(best.frames) ? one : best,
      );
  const isCandidate = candidates.includes(chosen);
  const localizers = isCandidate ? series.slice(candidates.length).flatMap(({ group }) => group).length : 0;
  const others = (isCandidate ? candidates : series).filter((one) => one !== chosen).map(({ group }) => group.length);
  const size = chosen.group[0].flat ? ', size, view or film' : ' or size';
  const elsewhere = [
    ...(others.length > 0
      ? [
          `${others.length > 1 ? `${others.length} other series, or parts of other orientation${size}` : `another series, or a part of another orientation${size}`}, with ${listCounts(others)}: ${wanted ? `number ${wanted}` : `the one with the most voxels${gray.length > 0 && gray.length < candidates.length ? ' that is in gray' : ''}`} is shown`,
        ]
      : []),
    ...(localizers > 0
      ? [`${count(localizers, 'picture')} that only show${localizers > 1 ? '' : 's'} where the slices lie (LOCALIZER)`]
      : []),
  ];
  const { phases } = chosen;
  return {
    frames: chosen.frames,
    series: series.map(({ frames }) => frames),
    left: [...chosen.left, ...elsewhere],
    ...(phases ? { phases: { ...phases, left: [...phases.left, ...elsewhere] } } : {}),
  };
}

/** The number of a thing, with an s where there are several. */
export function count(n: number, what: string): string {
  return `${n.toLocaleString('en')} ${what}${n === 1 ? '' : 's'}`;
}

/** When the first of several frames was measured: a scanner may give several series one number. */
function findStart(group: readonly Frame[]): number {
  const times = group.map(({ traits }) => traits.get('time of the acquisition'));
  return times.reduce<number>((least, time) => (typeof time === 'number' ? Math.min(least, time) : least), Infinity);
}

/** Those without a number come last. */
function compareNumbers(a = Infinity, b = Infinity): number {
  return a === b ? 0 : a - b;
}

function listCounts(counts: readonly number[]): string {
  const named = counts.slice(0, 4).map(String).join(', ');
  return `${named}${counts.length > 4 ? ' …' : ''} ${counts.length === 1 && counts[0] === 1 ? 'picture' : 'pictures'}`;
}

function countVoxels(frames: readonly Frame[]): number {
  return frames.reduce((sum, { columns, rows }) => sum + columns * rows, 0);
}

function groupFrames(all: readonly Frame[], budget: Budget): Frame[][] {
  const groups: Frame[][] = [];
  const byKey = new Map<string, Frame[][]>();
  for (const frame of all) {
    const { series, columns, rows, unit, isLocalizer, position, picture, flat } = frame;
    const isPlaced = position !== null;
    const key = [series, columns, rows, unit, isLocalizer, isPlaced, picture.colors !== null, flat?.group].join('\n');
    const alike = byKey.get(key) ?? [];
    byKey.set(key, alike);
    budget.step(alike.length, 'the DICOM files');
    const found = alike.find(([first]) => isAlike(first, frame));
    if (found) {
      found.push(frame);
      continue;
    }
    const group = [frame];
    alike.push(group);
    groups.push(group);
  }
  return groups.flatMap(divideStacks);
}

/**
 * A file may have several stacks of one orientation, such as those of several discs of a spine. Where stacks share places, or have a frame
 * each, they are none: programs count other things by them. Those that continue each other, as slabs do, are one volume.
 */
function divideStacks(group: Frame[]): Frame[][] {
  const stacks = new Map<string, Frame[]>();
  for (const frame of group) {
    const known = stacks.get(frame.stack);
    if (known) known.push(frame);
    else stacks.set(frame.stack, [frame]);
  }
  if (stacks.size === 1) return [group];
  const all = [...stacks.values()];
  const placesOf = (frames: readonly Frame[]): Set<string> =>
    new Set(frames.map(({ position }) => (position ?? []).map((at) => at.toFixed(2)).join()));
  const places = all.map(placesOf);
  const distinct = new Set(places.flatMap((some) => [...some])).size;
  const areApart = distinct === places.reduce((sum, { size }) => sum + size, 0);
  return areApart && places.every(({ size }) => size > 1) && !areOneRow(group) ? all : [group];
}

/** Whether all frames lie in one row, as far apart from each other. */
function areOneRow(group: readonly Frame[]): boolean {
  const [first] = group;
  if (group.some((frame) => placeAlong(frame, first) === null)) return true;
  const positions = findPlaces(group).map(([{ position }]) => position!);
  const steps = positions.slice(1).map((position, i) => subtract(position, positions[i]));
  return steps.every((step) => length(subtract(step, steps[0])) <= sameStep * length(steps[0]));
}

function isAlike(a: Frame, b: Frame): boolean {
  return arePlanesAlike(a.plane, b.plane) && areSpacingsAlike(a.spacing, b.spacing);
}

function arePlanesAlike(a: Plane | null, b: Plane | null): boolean {
  if (!a || !b) return a === b;
  return dot(a.row, b.row) > sameDirection && dot(a.column, b.column) > sameDirection;
}

function areSpacingsAlike(a: Frame['spacing'], b: Frame['spacing']): boolean {
  if (!a || !b) return a === b;
  return a.every((size, axis) => Math.abs(size - b[axis]) <= sameSpacing * size);
}

/** Where a frame lies along the normal of the first one, in mm; null where its place is not known. */
export function placeAlong(frame: Pick<Frame, 'position'>, { plane }: Pick<Frame, 'plane'>): number | null {
  return frame.position && plane ? dot(frame.position, plane.normal) : null;
}

/** Of several frames at one place, those that are alike in what differs there. */
function takeOnePerPlace(group: readonly Frame[]): ChosenFrames {
  const [first] = group;
  if (first.flat) return takeFlat(group);
  if (group.some((frame) => placeAlong(frame, first) === null)) return { frames: sortByOrder(group), left: [] };
  let places = findPlaces(group);
  const most = Math.max(...places.map((at) => at.length));
  if (most === 1) return { frames: places.flat(), left: [] };
  const names: string[] = [];
  let phases: ChosenFrames['phases'];
  const all = [...new Set(group.flatMap(({ traits }) => [...traits.keys()]))];
  for (const [i, one] of all.entries()) {
    if (places.every((at) => at.length === 1)) break;
    if (!places.some((at) => new Set(at.map(({ traits }) => traits.get(one))).size > 1)) continue;
    const found = phases ? null : findPhases(places, all.slice(i));
    if (found) {
      const left = [...(names.length > 0 ? [describeOne(most, names)] : []), ...found.lost];
      phases = { frames: found.frames, times: found.times, left };
    }
    const name = found?.trait ?? one;
    names.push(name);
    places = takeByTrait(places, name);
  }
  const left =
    names.length > 0
      ? describeOne(most, names)
      : 'pictures at the place of another one, from which they do not differ by what they say';
  return { frames: places.map(([frame]) => frame), left: [left], phases };
}

/** Of pictures that are no slices, one; all of them are times. */
function takeFlat(group: readonly Frame[]): ChosenFrames {
  const frames = sortByOrder(group);
  const left = frames[0].flat!.isTurned
    ? ['projections from several sides (raw data of a SPECT), which are no slices: reconstruct them to see a volume']
    : [];
  if (frames.length === 1) return { frames, left };
  const one = `${frames.length} pictures of other times or views, which are no slices of a volume: one of them is shown`;
  return { frames: frames.slice(0, 1), left: [one, ...left], phases: { ...listTimes(frames), left } };
}

function describeOne(most: number, names: readonly string[]): string {
  return `up to ${most} pictures at each place, which differ in: ${names.join(', ')}. One of them is shown`;
}

/**
 * Takes those of the value that most places have, of several such the smallest one; at places without it the smallest
 * value that is there.
 */
function takeByTrait(places: readonly Frame[][], name: string): Frame[][] {
  const counts = new Map<string | number | undefined, number>();
  for (const at of places) {
    for (const value of new Set(at.map(({ traits }) => traits.get(name))))
      counts.set(value, (counts.get(value) ?? 0) + 1);
  }
  const most = Math.max(...counts.values());
  const usual = [...counts.keys()].filter((value) => counts.get(value) === most);
  usual.sort(compareValues);
  return places.map((at) => {
    const found = at.filter(({ traits }) => traits.get(name) === usual[0]);
    if (found.length > 0) return found;
    const values = at.map(({ traits }) => traits.get(name));
    values.sort(compareValues);
    return at.filter(({ traits }) => traits.get(name) === values[0]);
  });
}

function compareValues(a: string | number | undefined, b: string | number | undefined): number {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return String(a ?? '').localeCompare(String(b ?? ''), 'en');
}

/** The frames at each place, the places in ascending order. */
function findPlaces(group: readonly Frame[]): Frame[][] {
  const [first] = group;
  const sorted = sortByOrder(group);
  sorted.sort((a, b) => placeAlong(a, first)! - placeAlong(b, first)!);
  const near = samePlace * Math.min(...(first.spacing ?? [1]));
  const places: Frame[][] = [];
  let last = -Infinity;
  for (const frame of sorted) {
    const along = placeAlong(frame, first)!;
    if (along - last > near) {
      places.push([]);
      last = along;
    }
    places[places.length - 1].push(frame);
  }
  return places;
}

function sortByOrder(group: readonly Frame[]): Frame[] {
  const sorted = [...group];
  sorted.sort((a, b) => {
    const differing = a.order.findIndex((one, i) => one !== b.order[i]);
    return differing < 0 ? 0 : a.order[differing] - b.order[differing];
  });
  return sorted;
}
