import { emptyOf } from './gate-samples.ts';
import type { RadarSweep } from './radar-file.ts';

/**
 * Removes the radials that the file marks as not part of the sweep: those that the antenna measured while it moved to
 * another elevation. If all are marked, they stay: then the mark means nothing.
 * @param skipped - for each radial, in the file's order, not 0 if it is left out
 */
export function skipRadials(sweep: RadarSweep, skipped: ArrayLike<number>): RadarSweep {
  const kept = Array.from(sweep.azimuths.keys()).filter((radial) => !skipped[radial]);
  const count = sweep.azimuths.length - kept.length;
  if (count === 0 || kept.length === 0) return sweep;
  const pick = (angles: Float64Array): Float64Array<ArrayBuffer> => Float64Array.from(kept, (radial) => angles[radial]);
  return {
    ...sweep,
    azimuths: pick(sweep.azimuths),
    ...(sweep.elevations ? { elevations: pick(sweep.elevations) } : {}),
    read: (moment) => {
      const data = sweep.read(moment);
      if (!data) return null;
      const { gates, samples } = data;
      kept.forEach((radial, i) => samples.copyWithin(i * gates, radial * gates, (radial + 1) * gates));
      return { ...data, samples: samples.fill(emptyOf(samples), kept.length * gates).subarray(0, kept.length * gates) };
    },
  };
}
