import { VolumeViewError } from '../../errors.ts';

// More than any radar makes, and little enough to be held: what a damaged or hostile file may not exceed.
const mostGates = 2 ** 26;
const mostSweeps = 4096;
const mostRays = 100_000;

/** @throws {VolumeViewError} `format/too-large` */
export function refuseManySweeps(sweeps: number): void {
  if (sweeps > mostSweeps) throw tooLarge(`${sweeps} sweeps`, `at most ${mostSweeps}`);
}

/** @throws {VolumeViewError} `format/too-large` for a sweep that is no sane one, `format/corrupt` for an empty one */
export function refuseSweep(where: string, rays: number, gates: number): void {
  if (!(rays >= 1 && gates >= 1)) {
    throw new VolumeViewError('format/corrupt', `${where} got ${rays} rays of ${gates} gates; expected at least one of each`);
  }
  if (rays > mostRays) throw tooLarge(`${rays} rays in ${where}`, `at most ${mostRays}`);
  if (rays * gates > mostGates) throw tooLarge(`${rays} rays of ${gates} gates in ${where}`, `at most ${mostGates.toLocaleString('en')} gates`);
}

function tooLarge(got: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/too-large', `the radar file got ${got}; expected ${expected}; check the file`);
}
