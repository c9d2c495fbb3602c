import { VolumeViewError } from '../../core/errors.ts';
import type { SweepData, SweepGates } from './radar-file.ts';

// More than any radar makes, and little enough to be held: what a damaged or hostile file may not exceed.

/** A file whose budget is as large as any: what was read before, and what was made by hand, has no bytes. */
export const anyFileBytes = 2 ** 22;

const maxGates = 2 ** 26;
const maxSweeps = 4096;
const maxRadials = 100_000;

/** Sweeps that are shown at most: ten times as many as radars make. Those of a file may be many more. */
const maxShownSweeps = 512;

/** Most sweeps times radials of the sweep with the most: a table on the GPU has room for these. */
const maxShownRadials = 2 ** 19;

/** Most gates that a volume may have: what browsers let a page allocate at once, as floats. */
const maxShownGates = 2 ** 28;

/** Metres: farther than any radar on Earth sees. */
const maxReach = 1e7;

/** @throws {VolumeViewError} `format/too-large` */
export function refuseManySweeps(sweeps: number, what = 'sweeps'): void {
  if (sweeps > maxSweeps) throw tooLarge(`${sweeps} ${what}`, `at most ${maxSweeps}`);
}

/** @throws {VolumeViewError} `format/too-large` for a sweep that is no sane one, `format/corrupt` for an empty one */
export function refuseSweep(where: string, radials: number, gates: number): void {
  if (!(radials >= 1 && gates >= 1)) {
    throw new VolumeViewError('format/corrupt', `${where} got ${radials} radials of ${gates} gates; expected at least one of each`);
  }
  if (radials > maxRadials) throw tooLarge(`${radials} radials in ${where}`, `at most ${maxRadials}`);
  if (radials * gates > maxGates) throw tooLarge(`${radials} radials of ${gates} gates in ${where}`, `at most ${maxGates.toLocaleString('en')} gates`);
}

/**
 * To be asked before the gates of each sweep that is shown are read.
 * @param all - those of the sweeps that were read before, and of this one
 * @throws {VolumeViewError} `format/too-large`
 */
export function refuseShown(all: { readonly sweeps: number; readonly radials: number; readonly gates: number }): void {
  const { sweeps, radials, gates } = all;
  if (sweeps > maxShownSweeps) throw tooLarge(`more than ${maxShownSweeps} sweeps of different elevations`, `at most ${maxShownSweeps}`);
  if (sweeps * radials > maxShownRadials) {
    throw tooLarge(`${sweeps} sweeps of up to ${radials} radials`, `at most ${maxShownRadials.toLocaleString('en')} radials`);
  }
  if (gates > maxShownGates) throw tooLarge(`${gates} gates of one moment`, `at most ${maxShownGates}. Use a file with fewer sweeps`);
}

/**
 * @param where - the sweep, in an author's words
 * @throws {VolumeViewError} `format/corrupt` for gates that lie where no radar sees
 */
export function refuseGates(where: string, { firstGate, gateLength, gates }: SweepGates): void {
  const end = firstGate + gates * gateLength;
  if (Math.abs(firstGate) <= maxReach && end > 0 && end <= maxReach) return;
  throw new VolumeViewError(
    'format/corrupt',
    `${where} got gates from ${firstGate} m to ${end} m; expected an end between 0 and ${maxReach.toLocaleString('en')} m. Check the program that wrote the file`,
  );
}

/**
 * @param where - the sweep, in an author's words
 * @throws {VolumeViewError} `format/corrupt` for a scale whose values are beyond float32
 */
export function refuseScale(where: string, { slope, intercept }: Pick<SweepData, 'slope' | 'intercept'>): void {
  const highest = Math.abs(slope) * 65535 + Math.abs(intercept);
  if (slope !== 0 && Number.isFinite(1 / slope) && Number.isFinite(Math.fround(highest))) return;
  throw new VolumeViewError('format/corrupt', `${where} got the scale ${slope} and the offset ${intercept}; expected numbers of a usual size. Check the program that wrote the file`);
}

function tooLarge(got: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/too-large', `the radar file got ${got}; expected ${expected}; check the file`);
}
