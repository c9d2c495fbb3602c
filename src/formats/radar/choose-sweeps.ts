import { VolumeViewError } from '../../errors.ts';
import type { RadarFile, RadarMoment, RadarSweep, SweepData } from './radar-file.ts';

/** Sweeps nearer than this, degrees, have the same elevation, however narrow the beam. */
const nearestSweeps = 0.02;

/** A sweep that is shown. */
export interface ChosenSweep {
  readonly sweep: RadarSweep;
  readonly data: SweepData;
}

interface Candidate extends ChosenSweep {
  /** In an author's words. */
  readonly name: string;
  /** Metres. */
  readonly reach: number;
  readonly isFilled: boolean;
}

/**
 * The moment that is shown.
 * @param name - as the file names it; undefined: the first reflectivity, else the first moment
 * @throws {VolumeViewError} `attribute/invalid` where the file has none of that name, `format/unsupported` where it has none
 */
export function chooseMoment(file: RadarFile, name: string | undefined): RadarMoment {
  const { moments } = file;
  if (moments.length === 0) {
    throw new VolumeViewError('format/unsupported', `the ${file.format} file holds no quantity that can be shown; expected one such as reflectivity`);
  }
  if (name === undefined) return moments.find(({ kind }) => kind === 'reflectivity') ?? moments[0];
  const moment = moments.find((one) => one.name === name);
  if (moment) return moment;
  const names = moments.map((one) => one.name).join(', ');
  throw new VolumeViewError('attribute/invalid', `moment got "${name}"; expected one that the file holds: ${names}`);
}

/**
 * The sweeps of a moment to show, by ascending elevation. Of several at one elevation (within a fifth of the beam: they
 * see the same air, and an antenna points no better) one is kept: one that holds any data (converted files fill what
 * a surveillance scan did not measure), that reaches farthest, that has the most radials, the first.
 * @param beamWidth - degrees
 * @throws {VolumeViewError} `format/unsupported` where no sweep holds the moment
 */
export function chooseSweeps(file: RadarFile, moment: string, beamWidth: number): { chosen: ChosenSweep[]; left: string[] } {
  const candidates: Candidate[] = [];
  const left: string[] = [];
  file.sweeps.forEach((sweep, i) => {
    const name = `sweep ${i + 1} at ${formatDegrees(sweep.elevation)}`;
    const data = Math.abs(sweep.elevation) <= 90 ? sweep.read(moment) : null;
    if (!data || data.gates < 1 || sweep.azimuths.length < 1 || !(data.gateLength > 0)) left.push(`${name} holds no ${moment}`);
    else candidates.push({ sweep, data, name, reach: data.firstGate + data.gates * data.gateLength, isFilled: hasAny(data) });
  });
  if (candidates.length === 0) {
    throw new VolumeViewError('format/unsupported', `the ${file.format} file lists the moment ${moment}, but none of its ${file.sweeps.length} sweeps holds any; choose another moment`);
  }
  const nearest = Math.max(nearestSweeps, beamWidth / 5);
  const kept: Candidate[] = [];
  candidates.sort((a, b) =>
    Number(b.isFilled) - Number(a.isFilled) || b.reach - a.reach || b.sweep.azimuths.length - a.sweep.azimuths.length);
  for (const one of candidates) {
    const same = kept.find(({ sweep }) => Math.abs(sweep.elevation - one.sweep.elevation) < nearest);
    if (same) left.push(`${one.name} is left out for ${same.name}`);
    else kept.push(one);
  }
  kept.sort((a, b) => a.sweep.elevation - b.sweep.elevation);
  return { chosen: kept, left };
}

/** Whether any gate holds data. */
function hasAny({ samples }: SweepData): boolean {
  return samples instanceof Float32Array ? samples.some(Number.isFinite) : samples.some((value) => value !== 0);
}

function formatDegrees(angle: number): string {
  return `${Number(angle.toFixed(2))}°`;
}
