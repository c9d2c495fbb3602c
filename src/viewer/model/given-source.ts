const names = [
  'mosaic',
  'slices',
  'spacing',
  'coordinates',
  'elevations',
  'range',
  'azimuth',
  'moment',
  'beamModel',
  'verticalExaggeration',
  'clean',
  'series',
] as const;

/** An attribute that says how a file is to be read, by property. */
export type SourceName = (typeof names)[number];

export type GivenSource = Readonly<Record<SourceName, string | null>>;

/** The attributes that say how to read a file; null where the author gives none of them. */
export function pickSource(given: GivenSource): GivenSource | null {
  if (names.every((name) => given[name] === null)) return null;
  return Object.fromEntries(names.map((name) => [name, given[name]])) as GivenSource;
}
