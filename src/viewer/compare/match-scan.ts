/**
 * The scan that belongs to one of another view: the nearest in time, where both know their times, else the one of the same number.
 * @param time - of the other view's scan, ISO 8601; null where it is not known
 * @param index - its number, from 0
 * @param times - of the scans to choose from
 */
export function matchScan(time: string | null, index: number, times: readonly (string | null)[]): number {
  const at = time === null ? NaN : Date.parse(time);
  let best = Math.min(index, times.length - 1);
  let least = Infinity;
  if (Number.isNaN(at) || times.some((one) => one === null)) return best;
  times.forEach((one, i) => {
    const apart = Math.abs(Date.parse(one!) - at);
    if (apart < least) [best, least] = [i, apart];
  });
  return best;
}
