import type { RadarSweep } from './radar-file.ts';

/** Radials nearer to their sweep's elevation than this, degrees, have it: that is 8 m at 460 km. */
const nearestRadials = 0.001;

/**
 * Elevations of the radials of a sweep as the file says them; undefined where they are the sweep's own.
 * @returns degrees, in the file's order; of a radial without any, the sweep's
 */
export function ownElevations({ elevation, elevations }: RadarSweep): Float64Array<ArrayBuffer> | undefined {
  const own = elevations?.map((one) => (Math.abs(one) <= 90 ? one : elevation));
  return own?.some((one) => Math.abs(one - elevation) > nearestRadials) ? own : undefined;
}

/**
 * Elevations of the radials of a volume's sweep. A radial without data has that of its neighbour, or the mean of both.
 * @param radials - index of each in the file, by azimuth; -1 for one without data
 * @param limits - degrees: the elevations of the sweeps below and above, beyond which no radial counts as one of this sweep
 */
export function arrangeElevations(sweep: RadarSweep, radials: Int32Array, [low, high]: readonly [number, number]): Float64Array<ArrayBuffer> | undefined {
  const own = ownElevations(sweep);
  if (!own) return undefined;
  const arranged = Float64Array.from(radials, (radial) => (radial < 0 ? NaN : Math.min(high, Math.max(low, own[radial]))));
  const at = (i: number): number => arranged[(i + radials.length) % radials.length];
  return arranged.map((one, i) => (radials[i] < 0 ? meanOf([at(i - 1), at(i + 1)].filter(Number.isFinite)) : one));
}

function meanOf(numbers: readonly number[]): number {
  return numbers.reduce((sum, one) => sum + one, 0) / numbers.length;
}
