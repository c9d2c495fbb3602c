/**
 * Seconds of a time of the day, on its day where the file says it; undefined where it says no time.
 * @param date - such as 20240131 @param time - such as 142530.25
 */
export function secondsOf(date: string, time: string): number | undefined {
  const clock = /^(\d\d):?(\d\d):?(\d\d(?:\.\d+)?)?/.exec(time);
  if (!clock) return undefined;
  const day = /^(\d{4})(\d\d)(\d\d)$/.exec(date);
  const start = day ? Date.UTC(Number(day[1]), Number(day[2]) - 1, Number(day[3])) / 1e3 : 0;
  return start + 3600 * Number(clock[1]) + 60 * Number(clock[2]) + Number(clock[3] ?? 0);
}

/** The same; null where the day or the seconds are missing. */
export function wholeSecondsOf(date: string, time: string): number | null {
  const isWhole = /^\d{8}$/.test(date) && /^\d{6}/.test(time);
  return isWhole ? secondsOf(date, time)! : null;
}
