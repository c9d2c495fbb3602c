import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import type { RadarFile, RadarMoment, RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { skipRadials } from './skip-radials.ts';
import { anyFileBytes, refuseGates, refuseScale, refuseShown } from './radar-limits.ts';

/** Sweeps nearer to each other than this, degrees, have the same elevation, however narrow the beam is. */
const nearestSweeps = 0.02;

/** Maximum bytes of a gate, when it is read. */
const maxBytesPerGate = 4;

/** Steps for comparing a sweep with others, or for reading it. */
const stepsPerSweep = 256;

/** A sweep that is shown. */
export interface ChosenSweep {
  readonly sweep: RadarSweep;
  /** Their bytes are taken from the budget. */
  readonly data: SweepData;
}

interface Candidate {
  readonly sweep: RadarSweep;
  /** The sweep's name in messages. */
  readonly name: string;
  readonly grid: SweepGates;
}

interface Kept extends ChosenSweep {
  readonly name: string;
}

/** What of a file says which moments it has. */
interface FileOfMoments extends Pick<RadarFile, 'format' | 'moments'> {
  readonly sweeps: readonly Pick<RadarSweep, 'moments'>[];
}

/**
 * Chooses the moment to show.
 * @param name - the file's name of it. If undefined: the reflectivity that most sweeps hold, and among equals the
 * first; if there is no reflectivity, the same among all moments
 * @throws {VolumeViewError} `attribute/invalid` if the file has no moment of that name, `format/unsupported` if it has
 * no moments
 */
export function chooseMoment(file: FileOfMoments, name: string | undefined): RadarMoment {
  const { moments } = file;
  if (moments.length === 0) {
    throw new VolumeViewError(
      'format/unsupported',
      `the ${file.format} file holds no quantity that can be shown; expected one such as reflectivity`,
    );
  }
  if (name === undefined) {
    const reflectivities = moments.filter(({ kind }) => kind === 'reflectivity');
    const among = reflectivities.length > 0 ? reflectivities : moments;
    return among.reduce((best, one) => (countSweeps(file, one) > countSweeps(file, best) ? one : best));
  }
  const moment = moments.find((one) => one.name === name);
  if (moment) return moment;
  const names = moments
    .slice(0, 40)
    .map((one) => one.name.slice(0, 40))
    .join(', ');
  throw new VolumeViewError('attribute/invalid', `moment got "${name}"; expected one that the file holds: ${names}`);
}

function countSweeps({ sweeps }: FileOfMoments, { name }: RadarMoment): number {
  return sweeps.reduce((count, { moments }) => count + Number(moments.includes(name)), 0);
}

/** A note about a moment that was chosen by default, if some sweeps lack it and the file has others of its kind. */
export function describeChoice(file: RadarFile, moment: RadarMoment): string[] {
  const others = file.moments.filter(({ kind, name }) => kind === moment.kind && name !== moment.name);
  const count = countSweeps(file, moment);
  if (others.length === 0 || count === file.sweeps.length) return [];
  const words = others
    .slice(0, 8)
    .map((one) => `${one.name.slice(0, 40)} ${countSweeps(file, one)}`)
    .join(', ');
  return [`${moment.name} is shown, as most sweeps hold it: ${count} of ${file.sweeps.length} (${words})`];
}

/**
 * The sweeps of a moment to show, by ascending elevation. Of several at one elevation one is kept. (One elevation
 * means: within a fifth of the beam. Such sweeps see the same air, and an antenna points no more exactly.) The rules,
 * in this order: a sweep that holds any data (converted files fill what a surveillance scan did not measure), that
 * reaches farthest, that has the most radials, the first. The gates of other sweeps are read only if it is needed to
 * know whether they hold data. Gates are counted, and taken from the budget, before they are read.
 * @param beamWidth - degrees
 * @param budget - of the load
 * @throws {VolumeViewError} `format/unsupported` if no sweep holds the moment, `format/corrupt`, `format/too-large`
 */
export function chooseSweeps(
  file: RadarFile,
  moment: string,
  beamWidth: number,
  budget = Budget.ofFile(anyFileBytes),
): { chosen: ChosenSweep[]; left: string[]; details: string[] } {
  const { candidates, unused, left, details } = listCandidates(file, moment);
  if (candidates.length === 0) {
    throw new VolumeViewError(
      'format/unsupported',
      `the ${file.format} file lists the moment ${moment}, but none of its ${file.sweeps.length} sweeps holds any; choose another moment`,
    );
  }
  const nearest = Math.max(nearestSweeps, beamWidth / 5);
  const kept: Kept[] = [];
  const findSame = ({ elevation }: RadarSweep): Kept | undefined =>
    kept.find((other) => Math.abs(other.sweep.elevation - elevation) < nearest);
  const add = (one: Candidate, mayBeEmpty: boolean): boolean => {
    budget.step(stepsPerSweep, one.name);
    const same = findSame(one.sweep);
    if (same) details.push(`${one.name} is left out for ${same.name}`);
    const data = same ? null : readSweep(one, moment, [...kept, one], budget);
    if (data && !mayBeEmpty && !hasAny(data)) {
      budget.giveBack(data.samples.byteLength);
      return false;
    }
    if (data) kept.push({ sweep: one.sweep, name: one.name, data });
    return true;
  };
  // Sweeps without data are used only if an elevation has no other sweep.
  const empty = candidates.filter((one) => !add(one, false));
  for (const one of empty) add(one, true);
  kept.sort((a, b) => a.sweep.elevation - b.sweep.elevation);
  // Where another sweep shows the same air, nothing is missing.
  for (const { sweep, why } of unused) (findSame(sweep) ? details : left).push(why);
  return { chosen: kept, left, details };
}

/** A sweep that is not shown. */
interface Unused {
  readonly sweep: RadarSweep;
  readonly why: string;
}

interface Candidates {
  /** Best first. */
  readonly candidates: readonly Candidate[];
  readonly unused: readonly Unused[];
  /** What is to be said, where it changes what is seen, and where not. */
  readonly left: string[];
  readonly details: string[];
}

/** Sweeps that hold the moment, best first, and of the others what is to be said. Those that their radar calls faulty are not shown, unless all are. */
function listCandidates({ sweeps }: RadarFile, moment: string): Candidates {
  const sound: Candidate[] = [];
  const faulty: (Candidate & { readonly fault: string })[] = [];
  const unused: Unused[] = [];
  let inTransition = 0;
  sweeps.forEach((whole, i) => {
    const sweep = whole.transitions ? skipRadials(whole, whole.transitions) : whole;
    inTransition += whole.azimuths.length - sweep.azimuths.length;
    const name = `sweep ${i + 1} at ${formatDegrees(sweep.elevation)}`;
    if (!(Math.abs(sweep.elevation) <= 90))
      return void unused.push({ sweep, why: `${name} is left out: no antenna looks there; expected -90° to 90°` });
    const grid = sweep.gridOf(moment);
    if (!grid || grid.gates < 1 || sweep.azimuths.length < 1 || !(grid.gateLength > 0))
      return void unused.push({ sweep, why: `${name} holds no ${moment}` });
    const fault = sweep.faultOf?.(moment);
    if (fault) faulty.push({ sweep, name, grid, fault });
    else sound.push({ sweep, name, grid });
  });
  const isAllFaulty = sound.length === 0;
  const candidates: Candidate[] = isAllFaulty ? faulty : sound;
  const left =
    faulty.length > 0 && isAllFaulty
      ? [
          `all sweeps are faulty, as their radar says (${[...new Set(faulty.map(({ fault }) => fault))].slice(0, 4).join('; ')}): they are shown all the same`,
        ]
      : [];
  if (!isAllFaulty)
    unused.push(
      ...faulty.map(({ sweep, name, fault }) => ({
        sweep,
        why: `${name} is left out: its radar says that it is faulty (${fault})`,
      })),
    );
  const details: string[] = [];
  if (inTransition > 0)
    details.push(
      `${inTransition} radials are left out: the antenna was on its way between sweeps (antenna_transition)`,
    );
  const reachOf = ({ firstGate, gates, gateLength }: SweepGates): number => firstGate + gates * gateLength;
  candidates.sort((a, b) => reachOf(b.grid) - reachOf(a.grid) || b.sweep.azimuths.length - a.sweep.azimuths.length);
  return { candidates, unused, left, details };
}

/** @param all - the sweeps that are shown, including this one */
function readSweep(
  { sweep, name, grid }: Candidate,
  moment: string,
  all: readonly (Candidate | Kept)[],
  budget: Budget,
): SweepData | null {
  refuseGates(name, grid);
  const gates = sweep.azimuths.length * grid.gates;
  refuseShown({
    sweeps: all.length,
    radials: all.reduce((max, { sweep: { azimuths } }) => Math.max(max, azimuths.length), 0),
    gates: all.reduce((sum, one) => sum + one.sweep.azimuths.length * ('grid' in one ? one.grid : one.data).gates, 0),
  });
  budget.take(maxBytesPerGate * gates, name);
  const data = sweep.read(moment);
  budget.giveBack(maxBytesPerGate * gates - (data?.samples.byteLength ?? 0));
  if (data) refuseScale(name, data);
  return data;
}

/** Whether any gate holds data. */
function hasAny({ samples }: SweepData): boolean {
  return samples instanceof Float32Array ? samples.some(Number.isFinite) : samples.some((value) => value !== 0);
}

function formatDegrees(angle: number): string {
  return `${Number(angle.toFixed(2))}°`;
}
