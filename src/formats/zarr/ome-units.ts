// Units of axes. Source: OME-Zarr 0.5, "axes" metadata: UDUNITS-2 names

/** Millimetres of units of length. */
const lengths: ReadonlyMap<string, number> = new Map([
  ['angstrom', 1e-7],
  ['picometer', 1e-9],
  ['nanometer', 1e-6],
  ['micrometer', 1e-3],
  ['micron', 1e-3],
  ['millimeter', 1],
  ['centimeter', 10],
  ['decimeter', 100],
  ['meter', 1e3],
  ['hectometer', 1e5],
  ['kilometer', 1e6],
  ['inch', 25.4],
  ['foot', 304.8],
  ['yard', 914.4],
  ['mile', 1_609_344],
]);

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
  nm: 'nanometer',
  um: 'micrometer',
  '\u00b5m': 'micrometer',
  '\u03bcm': 'micrometer',
  mm: 'millimeter',
  cm: 'centimeter',
  m: 'meter',
  ms: 'millisecond',
  s: 'second',
  min: 'minute',
  h: 'hour',
};

const wordOf = (unit: unknown): string => {
  const word = typeof unit === 'string' ? unit.trim().toLowerCase() : '';
  return (Object.hasOwn(short, word) ? short[word] : word).replace(/metre$/, 'meter');
};

/** Millimetres of a unit of length; undefined where it is none that is known. */
export const millimetresOf = (unit: unknown): number | undefined => lengths.get(wordOf(unit));

/** Seconds of a unit of time; undefined where it is none that is known. */
export const secondsOf = (unit: unknown): number | undefined => times.get(wordOf(unit));
