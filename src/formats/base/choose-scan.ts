import { VolumeViewError } from '../../core/errors.ts';

/** Which of several scans is wanted: by its number, from 0, or the last one that is not after a time (ms since 1970, UTC). */
export type ScanTarget = { readonly index: number } | { readonly time: number };

/** When scans began, one a scan, in this order: ISO 8601; null for one without a time, undefined where it is not known yet. */
export type ScanTimes = readonly (string | null | undefined)[];

export interface ScanChoice {
  readonly index: number;
  /** False where this scan's time has to be known first; then choose again. */
  readonly certain: boolean;
}

/**
 * The scan that is wanted. Before all of them it is the first one; scans without a time are passed over. Of unknown times
 * it asks for as few as it can, by halves.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function chooseScan(times: ScanTimes, wanted: ScanTarget): ScanChoice {
  if ('index' in wanted) return { index: checkIndex(wanted.index, times.length), certain: true };
  let last = 0;
  let after = times.length;
  for (const [i, time] of times.entries()) {
    if (!time) continue;
    if (Date.parse(time) <= wanted.time) last = i;
    else after = Math.min(after, i);
  }
  const unknown = times.flatMap((time, i) => (time === undefined && i > last && i < after ? [i] : []));
  return unknown.length > 0 ? { index: unknown[unknown.length >> 1], certain: false } : { index: last, certain: true };
}

function checkIndex(index: number, count: number): number {
  if (index < count) return index;
  throw new VolumeViewError('attribute/invalid', `time got "${index}"; expected the number of a scan, from 0 to ${count - 1}, or a time such as "2018-12-20T06:06:28Z".`);
}
