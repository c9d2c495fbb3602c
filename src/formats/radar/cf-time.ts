const millisecondsOf = new Map([
  ['nanosecond', 1e-6],
  ['microsecond', 1e-3],
  ['millisecond', 1],
  ['second', 1000],
  ['sec', 1000],
  ['s', 1000],
  ['minute', 60_000],
  ['hour', 3_600_000],
  ['day', 86_400_000],
]);

/**
 * Reads the origin and the unit of a CF time.
 * @param units - such as 'seconds since 2016-06-01T15:00:25Z'
 * @returns milliseconds since 1970 of the origin, and milliseconds per unit; undefined if the text says something else
 * Source: CF conventions 1.11, 4.4; times without a zone are in UTC
 */
export function parseTimeUnits(units: string): { from: number; unit: number } | undefined {
  const [, name, from] = /^\s*([a-z]+?)s? since (.*)$/i.exec(units) ?? [];
  const unit = millisecondsOf.get((name ?? '').toLowerCase()) ?? (/^\s*s since/i.test(units) ? 1000 : undefined);
  const parts = /^\s*(\d{1,4})-(\d{1,2})-(\d{1,2})(?:[T ]+(\d{1,2}):(\d{1,2})(?::(\d{1,2}(?:\.\d+)?))?)?/.exec(
    from ?? '',
  );
  if (!parts || unit === undefined) return undefined;
  const [year, month, day, hour = 0, minute = 0, second = 0] = parts
    .slice(1)
    .map((part) => (part === undefined ? undefined : Number(part)));
  return { from: Date.UTC(year!, month! - 1, day, hour, minute) + 1000 * second, unit };
}

/** ISO 8601 in UTC, rounded down to a second; undefined if it is not a time. */
export function isoTime(milliseconds: number): string | undefined {
  if (!(Math.abs(milliseconds) < 8.64e15)) return undefined;
  return new Date(milliseconds).toISOString().replace(/\.\d+Z$/, 'Z');
}
