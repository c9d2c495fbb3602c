import { VolumeViewError } from '../../core/errors.ts';
import type { PolarVolume } from '../../volume/volume.ts';

/**
 * Check that two moments of one scan can be read together: every gate of one must also be a gate of the other.
 * @throws {VolumeViewError} `format/unsupported`
 */
export function checkSameGates(over: PolarVolume, other: PolarVolume): void {
  const [here, there] = [over, other].map(({ grid: { sweeps } }) =>
    sweeps.map(({ azimuths, gates, firstGate, gateLength }) =>
      [azimuths.length, gates, firstGate, gateLength].join(' '),
    ),
  );
  if (here.join() === there.join() && over.samples.length === other.samples.length) return;
  const [first, second] = [over, other].map(
    ({ radar, grid: { sweeps } }) =>
      `${radar?.moment ?? 'one moment'} has ${sweeps.length} sweeps of up to ${Math.max(...sweeps.map(({ gates }) => gates))} gates`,
  );
  throw new VolumeViewError(
    'format/unsupported',
    `${second}, and ${first}; expected two moments of one scan on the same gates. Some radars measure the velocity in sweeps of its own: show it alone, with moment.`,
  );
}
