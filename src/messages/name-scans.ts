// Names of scans and their times, in the zone of the language.
import { readScanTime } from '../core/scan-time.ts';
import type { Language } from './language.ts';

/**
 * A short name for each scan: its clock time, with seconds where minutes are not enough to differ; the number and unit of its file; its
 * number among the scans where it has no time.
 */
export function labelScans(times: readonly (string | null)[], language: Language): string[] {
  const label = scanLabeller(times, language);
  return times.map((_, i) => label(i));
}

/** Returns a function that names one scan, so that a page with thousands of scans does not have to name all of them. */
export function scanLabeller(times: readonly (string | null)[], language: Language): (index: number) => string {
  const known = times.filter((time) => time !== null);
  const needSeconds = new Set(known.map((time) => time.slice(0, 16))).size < known.length;
  return (index) => {
    const time = times[index];
    if (time === null) return language.number(index + 1);
    if (isClock(time)) return language.clock(time, needSeconds);
    const { value, unit } = readScanTime(time)!;
    return language.value(value, unit, 6);
  };
}

/** Whether a time is one in UTC, with a day and a zone. */
export function isClock(time: string | null): time is string {
  return time !== null && readScanTime(time)?.unit === 'UTC';
}

/** One scan in words, for screen readers: `15:10 UTC, 20 Jun 2011, scan 2 of 3`. */
export function describeScan(times: readonly (string | null)[], index: number, language: Language): string {
  const { messages } = language;
  const time = times[index];
  const name = scanLabeller(times, language)(index);
  const when = time === null ? [] : isClock(time) ? [`${name} ${language.zone(time)}`, language.day(time)] : [name];
  const which = times.length > 1 ? [messages.scanOf(language.number(index + 1), language.number(times.length))] : [];
  return [...when, ...which].join(', ');
}
