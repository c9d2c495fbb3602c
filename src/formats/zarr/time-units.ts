// Units of time. Source: OME-Zarr 0.5, "axes" metadata: UDUNITS-2 names

/** Seconds of units of time. */
const times: ReadonlyMap<string, number> = new Map([
  ['picosecond', 1e-12],
  ['nanosecond', 1e-9],
  ['microsecond', 1e-6],
  ['millisecond', 1e-3],
  ['second', 1],
  ['minute', 60],
  ['hour', 3600],
  ['day', 86_400],
]);

/** Short names, which some programs write. */
const short: Readonly<Record<string, string>> = {
  ms: 'millisecond',
  s: 'second',
  min: 'minute',
  h: 'hour',
};

/** Seconds of a unit of time; undefined where it is none that is known. */
export function secondsOf(unit: unknown): number | undefined {
  const word = typeof unit === 'string' ? unit.trim().toLowerCase() : '';
  return times.get(Object.hasOwn(short, word) ? short[word] : word);
}
