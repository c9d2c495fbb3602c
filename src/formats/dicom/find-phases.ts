// Series in which each place was measured several times: phases of a heart, or a contrast agent on its way.
import { timeText } from '../series/scan-times.ts';
import type { Frame } from './frame.ts';
import { lastTrait } from './traits.ts';

/** Several times of a volume. */
export interface Phases {
  /** Of each time its frames, at the same places in the same order. */
  readonly frames: readonly (readonly Frame[])[];
  /** When each was measured, from the first on: '12.5 s'; null where the files do not say it. */
  readonly times: readonly (string | null)[];
}

/** The names of what differs between times, and how their numbers become seconds; null where they only count. */
const timeTraits: ReadonlyMap<string, ((value: number) => number) | null> = new Map([
  ['trigger time', (milliseconds: number) => milliseconds / 1e3],
  ['time from the start', asTheyAre],
  ['time of the acquisition', asTheyAre],
  ['date and time of the acquisition', asTheyAre],
  ['reference time', asTheyAre],
  ['position in time', null],
  ['part of a heartbeat', null],
  ['part of the scan', null],
  ['share of a heartbeat', null],
  ['share of a breath', null],
  ['number of the acquisition', null],
  // Scanners count pictures in the order of time. When the content of a file was made is not always when it was measured.
  [lastTrait, null],
  ['time of the content', null],
]);

function asTheyAre(seconds: number): number {
  return seconds;
}

/**
 * The frames of each time, where a trait of theirs is one of time. If several frames of a place have the same, another trait of time may differ:
 * the number of the acquisition may change once, when a contrast agent is given.
 * @param places - of each place its frames
 * @param traits - in their order, that in which the frames differ first
 * @returns null where the first is no time, and where no two times have all places; times that lack some are left out, which `lost` says
 */
export function findPhases(
  places: readonly (readonly Frame[])[],
  traits: readonly string[],
): (Phases & { readonly trait: string; readonly lost: readonly string[] }) | null {
  const [first, ...others] = traits;
  if (!timeTraits.has(first)) return null;
  const candidates = [first, ...others.filter((one) => timeTraits.has(one) && !isLastResort(one))];
  for (const trait of candidates) {
    const phases = divideByTime(places, trait);
    if (phases) return { ...phases, trait, lost: [] };
  }
  for (const trait of candidates) {
    const phases = findCompleteTimes(places, trait) ?? cutAtEnd(places, trait);
    if (phases) return { ...phases, trait, lost: [sayLost(places, phases)] };
  }
  return null;
}

function sayLost(places: readonly (readonly Frame[])[], { frames }: Phases): string {
  const all = places.reduce((sum, at) => sum + at.length, 0);
  const lost = all - frames.length * places.length;
  return `${lost} ${lost > 1 ? 'pictures' : 'picture'} of times in which some slices are missing: ${frames.length} complete times are shown`;
}

/** What says no time by itself, and differs between all pictures: also between those that differ in something else. */
const isLastResort = (trait: string): boolean => trait === lastTrait || trait === 'time of the content';

function divideByTime(places: readonly (readonly Frame[])[], trait: string): Phases | null {
  const count = places[0].length;
  if (count < 2) return null;
  const sorted: (readonly Frame[])[] = [];
  for (const at of places) {
    const values = new Set(at.map((frame) => numberOf(frame, trait)));
    if (at.length !== count || values.size !== count || values.has(undefined)) return null;
    const frames = [...at];
    frames.sort((a, b) => numberOf(a, trait)! - numberOf(b, trait)!);
    sorted.push(frames);
  }
  const frames = Array.from({ length: count }, (_, phase) => sorted.map((at) => at[phase]));
  return { frames, times: findTimes(frames) };
}

/** The times that all places have, where slices of one time have the same number, and half of the times or more are complete. */
function findCompleteTimes(places: readonly (readonly Frame[])[], trait: string): Phases | null {
  const byTime = new Map<number, Frame[]>();
  for (const at of places) {
    const here = new Map(at.map((frame) => [numberOf(frame, trait), frame]));
    if (here.size !== at.length || here.has(undefined)) return null;
    for (const [time, frame] of here) {
      const known = byTime.get(time!);
      if (known) known.push(frame);
      else byTime.set(time!, [frame]);
    }
  }
  const complete = [...byTime].filter(([, frames]) => frames.length === places.length);
  if (complete.length < 2 || 2 * complete.length < byTime.size) return null;
  complete.sort(([a], [b]) => a - b);
  const frames = complete.map(([, some]) => some);
  return { frames, times: findTimes(frames) };
}

/**
 * The times of a scan that was stopped. Its slices have numbers or times of their own: in the same order in each time, from one end of the
 * stack on, all of one time before those of the next one. The last time has only the first ones. Another slice that is missing would change
 * the order, or mix times.
 */
function cutAtEnd(places: readonly (readonly Frame[])[], trait: string): Phases | null {
  const count = Math.min(...places.map(({ length }) => length));
  if (count < 2 || places.some(({ length }) => length > count + 1)) return null;
  const sorted = places.map((at) => {
    const frames = at.map((frame) => ({ frame, value: numberOf(frame, trait) ?? NaN }));
    frames.sort((a, b) => a.value - b.value);
    return frames;
  });
  const measured = [...sorted];
  measured.sort((a, b) => a[0].value - b[0].value);
  const all = Array.from({ length: count + 1 }, (_, time) => measured.flatMap((at) => at.slice(time, time + 1))).flat();
  const isStopped = measured.every((at, i) => i === 0 || at.length <= measured[i - 1].length);
  const isFromEnd = [sorted[0], sorted[sorted.length - 1]].includes(measured[0]);
  if (!isStopped || !isFromEnd || !all.every(({ value }, i) => value >= (all[i - 1]?.value ?? -Infinity))) return null;
  const frames = Array.from({ length: count }, (_, time) => sorted.map((at) => at[time].frame));
  return { frames, times: findTimes(frames) };
}

const numberOf = ({ traits }: Frame, trait: string): number | undefined => {
  const value = traits.get(trait);
  return typeof value === 'number' ? value : undefined;
};

/** Each picture as a time of its own, in their order. */
export function listTimes(frames: readonly Frame[]): Phases {
  const seconds = frames.map(({ flat }) => flat?.seconds ?? NaN);
  const areTimes = areAscending(seconds);
  const all = frames.map((frame) => [frame]);
  return { frames: all, times: areTimes ? seconds.map((at) => sayTime(at - seconds[0])) : findTimes(all) };
}

/** Times of the day are rounded to microseconds. */
const sayTime = (seconds: number): string | null => timeText(Math.round(1e6 * seconds) / 1e6, 's');

const areAscending = (starts: readonly number[]): boolean =>
  starts.every((start, i) => Number.isFinite(start) && (i === 0 || start > starts[i - 1]));

/** Seconds from the first time on. The slices of one time may be measured one after another: the earliest of them counts. */
function findTimes(phases: readonly (readonly Frame[])[]): (string | null)[] {
  for (const [trait, toSeconds] of timeTraits) {
    if (!toSeconds) continue;
    const starts = phases.map((frames) => Math.min(...frames.map((frame) => toSeconds(numberOf(frame, trait) ?? NaN))));
    if (areAscending(starts)) return starts.map((start) => sayTime(start - starts[0]));
  }
  return phases.map(() => null);
}
