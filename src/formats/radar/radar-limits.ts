import { VolumeViewError } from '../../core/errors.ts';
import type { SweepData, SweepGates } from './radar-file.ts';

// Limits for damaged or hostile files: more than any radar makes, and little enough for memory.

/** A file length that gives the largest useful budget, for files that are in memory already, or were made by hand. */
export const anyFileBytes = 2 ** 22;

const maxGates = 2 ** 26;
const maxSweeps = 4096;
const maxRadials = 100_000;

/** Maximum number of sweeps that are shown: ten times as many as radars make. A file may have many more. */
const maxShownSweeps = 512;

/** Maximum number of sweeps times radials of the sweep with the most: the size of a table on the GPU. */
const maxShownRadials = 2 ** 19;

/** Maximum number of gates of a volume: what browsers let a page allocate at once, as floats. */
const maxShownGates = 2 ** 28;

/** Metres: farther than any radar on Earth sees. */
const maxReach = 1e7;

/** @throws {VolumeViewError} `format/too-large` */
export function refuseManySweeps(sweeps: number, what = 'sweeps'): void {
  if (sweeps > maxSweeps) throw tooLarge(`${sweeps} ${what}`, `at most ${maxSweeps}`);
}

/** @throws {VolumeViewError} `format/too-large` for an implausibly large sweep, `format/corrupt` for an empty one */
export function refuseSweep(where: string, radials: number, gates: number): void {
  if (!(radials >= 1 && gates >= 1)) {
    throw new VolumeViewError(
      'format/corrupt',
      `${where} got ${radials} radials of ${gates} gates; expected at least one of each`,
    );
  }
  if (radials > maxRadials) throw tooLarge(`${radials} radials in ${where}`, `at most ${maxRadials}`);
  if (radials * gates > maxGates)
    throw tooLarge(
      `${radials} radials of ${gates} gates in ${where}`,
      `at most ${maxGates.toLocaleString('en')} gates`,
    );
}

/**
 * Call this before the gates of each shown sweep are read.
 * @param all - totals of the sweeps that were read before, and of this one
 * @throws {VolumeViewError} `format/too-large`
 */
export function refuseShown(all: { readonly sweeps: number; readonly radials: number; readonly gates: number }): void {
  const { sweeps, radials, gates } = all;
  if (sweeps > maxShownSweeps)
    throw tooLarge(`more than ${maxShownSweeps} sweeps of different elevations`, `at most ${maxShownSweeps}`);
  if (sweeps * radials > maxShownRadials) {
    throw tooLarge(
      `${sweeps} sweeps of up to ${radials} radials`,
      `at most ${maxShownRadials.toLocaleString('en')} radials`,
    );
  }
  if (gates > maxShownGates)
    throw tooLarge(`${gates} gates of one moment`, `at most ${maxShownGates}. Use a file with fewer sweeps`);
}

/**
 * @param where - the sweep's name in messages
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
 * @param where - the sweep's name in messages
 * @throws {VolumeViewError} `format/corrupt` for a scale whose values are beyond float32
 */
export function refuseScale(where: string, { slope, intercept }: Pick<SweepData, 'slope' | 'intercept'>): void {
  const highest = Math.abs(slope) * 65535 + Math.abs(intercept);
  if (slope !== 0 && Number.isFinite(1 / slope) && Number.isFinite(Math.fround(highest))) return;
  throw new VolumeViewError(
    'format/corrupt',
    `${where} got the scale ${slope} and the offset ${intercept}; expected numbers of a usual size. Check the program that wrote the file`,
  );
}

function tooLarge(got: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/too-large', `the radar file got ${got}; expected ${expected}; check the file`);
}
