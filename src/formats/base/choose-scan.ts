import { VolumeViewError } from '../../core/errors.ts';
import { readScanTime } from '../../core/scan-time.ts';

/**
 * Which of several scans to load: by its number, from 0, or the last one that is not after a time: ms since 1970 (UTC), or a text
 * with the unit of the file, '12.5 s'.
 */
export type ScanTarget = { readonly index: number } | { readonly time: number | string };

/** When each scan began, in the scans' order: ISO 8601, or a number with its unit; null for one without a time, undefined if it is not known yet. */
export type ScanTimes = readonly (string | null | undefined)[];

export interface ScanChoice {
  readonly index: number;
  /** False if this scan's time has to be known first. Look it up, then choose again. */
  readonly certain: boolean;
}

/**
 * Chooses a scan. A time before all scans gives the first one; scans without a time are skipped. Where times are
 * unknown, it asks for as few as it can, by bisection.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function chooseScan(times: ScanTimes, wanted: ScanTarget): ScanChoice {
  if ('index' in wanted) return { index: checkIndex(wanted.index, times.length), certain: true };
  const target = typeof wanted.time === 'number' ? { value: wanted.time, unit: 'UTC' } : readScanTime(wanted.time);
  let last = 0;
  let after = times.length;
  for (const [i, time] of times.entries()) {
    if (!time) continue;
    const { value, unit } = readScanTime(time) ?? {};
    if (unit !== target?.unit) throw refuse(wanted.time, times.length);
    if (value! <= target!.value) last = i;
    else after = Math.min(after, i);
  }
  const unknown = times.flatMap((time, i) => (time === undefined && i > last && i < after ? [i] : []));
  return unknown.length > 0 ? { index: unknown[unknown.length >> 1], certain: false } : { index: last, certain: true };
}

function checkIndex(index: number, count: number): number {
  if (index < count) return index;
  throw refuse(index, count);
}

function refuse(got: number | string, count: number): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    `time got "${got}"; expected the number of a scan, from 0 to ${count - 1}, or a time as the scans have them, such as "2018-12-20T06:06:28Z", or "12.5 s" where a file counts seconds.`,
  );
}
