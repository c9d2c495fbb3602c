import { readScanTime } from '../../core/scan-time.ts';

/**
 * The scan that belongs to one of another view: the nearest in time, where both know their times, else the one of the same number.
 * @param time - of the other view's scan, ISO 8601 or a number with its unit; null where it is not known
 * @param index - its number, from 0
 * @param times - of the scans to choose from
 */
export function matchScan(time: string | null, index: number, times: readonly (string | null)[]): number {
  const at = time === null ? null : readScanTime(time);
  let best = Math.min(index, times.length - 1);
  let least = Infinity;
  if (!at || times.some((one) => one === null || readScanTime(one)?.unit !== at.unit)) return best;
  times.forEach((one, i) => {
    const apart = Math.abs(readScanTime(one!)!.value - at.value);
    if (apart < least) [best, least] = [i, apart];
  });
  return best;
}
