// How a timeline names scans and their times, all in UTC.

/** The day: `20 Dec 2018`. */
export function formatDay(time: string | null): string {
  if (time === null) return '';
  return new Date(time).toLocaleDateString('en-GB', { day: 'numeric', month: 'short', year: 'numeric', timeZone: 'UTC' });
}

/** One short name a scan: its clock time, with seconds where minutes don't tell them apart; its number without a time. */
export function labelScans(times: readonly (string | null)[]): string[] {
  const known = times.filter((time) => time !== null);
  const minutes = known.map((time) => formatClock(time, false));
  const needSeconds = new Set(known.map((time) => time.slice(0, 16))).size < minutes.length;
  return times.map((time, i) => (time === null ? `${i + 1}` : formatClock(time, needSeconds)));
}

/** One scan in words, for those who hear it: `15:10 UTC, 20 Jun 2011, scan 2 of 3`. */
export function formatScan(times: readonly (string | null)[], index: number): string {
  const time = times[index];
  const when = time === null ? [] : [`${labelScans(times)[index]} UTC`, formatDay(time)];
  return [...when, ...(times.length > 1 ? [`scan ${index + 1} of ${times.length}`] : [])].join(', ');
}

function formatClock(time: string, withSeconds: boolean): string {
  return new Date(time).toISOString().slice(11, withSeconds ? 19 : 16);
}
