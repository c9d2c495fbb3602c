import { VolumeViewError } from '../../errors.ts';

// More than any radar makes, and little enough to be held: what a damaged or hostile file may not exceed.
const maxGates = 2 ** 26;
const maxSweeps = 4096;
const maxRadials = 100_000;

/** @throws {VolumeViewError} `format/too-large` */
export function refuseManySweeps(sweeps: number): void {
  if (sweeps > maxSweeps) throw tooLarge(`${sweeps} sweeps`, `at most ${maxSweeps}`);
}

/** @throws {VolumeViewError} `format/too-large` for a sweep that is no sane one, `format/corrupt` for an empty one */
export function refuseSweep(where: string, radials: number, gates: number): void {
  if (!(radials >= 1 && gates >= 1)) {
    throw new VolumeViewError('format/corrupt', `${where} got ${radials} radials of ${gates} gates; expected at least one of each`);
  }
  if (radials > maxRadials) throw tooLarge(`${radials} radials in ${where}`, `at most ${maxRadials}`);
  if (radials * gates > maxGates) throw tooLarge(`${radials} radials of ${gates} gates in ${where}`, `at most ${maxGates.toLocaleString('en')} gates`);
}

function tooLarge(got: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/too-large', `the radar file got ${got}; expected ${expected}; check the file`);
}
