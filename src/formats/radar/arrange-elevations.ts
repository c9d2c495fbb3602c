import type { RadarSweep } from './radar-file.ts';

/** Radials that differ from their sweep's elevation by less than this, degrees, get the sweep's: it is 8 m at 460 km. */
const nearestRadials = 0.001;

/**
 * Elevations of a sweep's radials from the file; undefined if they are equal to the sweep's own.
 * @returns degrees, in the file's order; for a radial without one, the sweep's
 */
export function ownElevations({ elevation, elevations }: RadarSweep): Float64Array<ArrayBuffer> | undefined {
  const own = elevations?.map((one) => (Math.abs(one) <= 90 ? one : elevation));
  return own?.some((one) => Math.abs(one - elevation) > nearestRadials) ? own : undefined;
}

/**
 * Elevations of the radials of a volume's sweep. A radial without data gets that of its neighbour, or the mean of both.
 * @param radials - index of each in the file, by azimuth; -1 for one without data
 * @param limits - degrees: the elevations of the sweeps below and above. Elevations are clamped to them
 */
export function arrangeElevations(
  sweep: RadarSweep,
  radials: Int32Array,
  [low, high]: readonly [number, number],
): Float64Array<ArrayBuffer> | undefined {
  const own = ownElevations(sweep);
  if (!own) return undefined;
  const arranged = Float64Array.from(radials, (radial) =>
    radial < 0 ? NaN : Math.min(high, Math.max(low, own[radial])),
  );
  const at = (i: number): number => arranged[(i + radials.length) % radials.length];
  return arranged.map((one, i) => (radials[i] < 0 ? meanOf([at(i - 1), at(i + 1)].filter(Number.isFinite)) : one));
}

function meanOf(numbers: readonly number[]): number {
  return numbers.reduce((sum, one) => sum + one, 0) / numbers.length;
}
