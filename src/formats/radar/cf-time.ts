const milliseconds: readonly (readonly [number, readonly string[]])[] = [
  [1e-6, ['nanosecond', 'nanosec', 'nsec', 'ns']],
  [1e-3, ['microsecond', 'microsec']],
  [1, ['millisecond', 'millisec', 'msec', 'ms']],
  [1000, ['second', 'sec', 's']],
  [60_000, ['minute', 'min']],
  [3_600_000, ['hour', 'hr', 'h']],
  [86_400_000, ['day', 'd']],
];

/** By each name of a unit. Source: UDUNITS 2.2, accepted units; CF conventions 1.11, 4.4 */
const millisecondsOf = new Map(milliseconds.flatMap(([unit, names]) => names.map((name) => [name, unit] as const)));

/** A date, and perhaps a time of day with a zone: '2024-05-01 12:00:00.5 -6:00'. */
const written =
  /^\s*(\d{1,4})-(\d{1,2})-(\d{1,2})(?:[T ]+(\d{1,2}):(\d{1,2})(?::(\d{1,2}(?:\.\d+)?))?(?:\s*([+-])(\d{1,2}):?(\d{2})?(?!\d))?)?/i;

/**
 * Reads the origin and the unit of a CF time.
 * @param units - such as 'seconds since 2016-06-01T15:00:25Z'
 * @returns milliseconds since 1970 of the origin, and milliseconds per unit; undefined if the text says something else
 * Source: CF conventions 1.11, 4.4; times without a zone are in UTC
 */
export function parseTimeUnits(units: string): { from: number; unit: number } | undefined {
  const [, name = '', from = ''] = /^\s*([a-z]+)\s+since\s+(.*)$/i.exec(units) ?? [];
  const lower = name.toLowerCase();
  const unit = millisecondsOf.get(lower) ?? millisecondsOf.get(lower.replace(/s$/, ''));
  const parts = written.exec(from);
  if (!parts || unit === undefined) return undefined;
  const [year, month, day, hour, minute, second] = parts.slice(1, 7).map((part) => Number(part ?? 0));
  const [sign, hours, minutes] = parts.slice(7);
  // East of Greenwich it is later than in UTC.
  const ahead = (sign === '-' ? -1 : 1) * (60 * Number(hours ?? 0) + Number(minutes ?? 0));
  return { from: Date.UTC(year, month - 1, day, hour, minute - ahead) + 1000 * second, unit };
}

/** ISO 8601 in UTC, rounded down to a second; undefined if it is not a time. */
export function isoTime(milliseconds: number): string | undefined {
  if (!(Math.abs(milliseconds) < 8.64e15)) return undefined;
  return new Date(milliseconds).toISOString().replace(/\.\d+Z$/, 'Z');
}
