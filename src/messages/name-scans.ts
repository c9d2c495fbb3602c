// Names of scans and their times, in the zone of the language.
import type { Language } from './language.ts';

/** A short name for each scan: its clock time, with seconds where minutes are not enough to differ; its number where it has no time. */
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
    return time === null ? language.number(index + 1) : language.clock(time, needSeconds);
  };
}

/** One scan in words, for screen readers: `15:10 UTC, 20 Jun 2011, scan 2 of 3`. */
export function describeScan(times: readonly (string | null)[], index: number, language: Language): string {
  const { messages } = language;
  const time = times[index];
  const when =
    time === null ? [] : [`${scanLabeller(times, language)(index)} ${language.zone(time)}`, language.day(time)];
  const which = times.length > 1 ? [messages.scanOf(language.number(index + 1), language.number(times.length))] : [];
  return [...when, ...which].join(', ');
}
