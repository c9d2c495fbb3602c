/** The attributes that say how a file is to be read, by property. The region only counts for sources of which no more is read. */
export const sourceNames = [
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
  'region',
  'maxBytes',
  'maxGpuBytes',
  'crossOrigin',
] as const;

/** One of them. */
export type SourceName = (typeof sourceNames)[number];

export type GivenSource = Readonly<Record<SourceName, string | null>>;

/** The attributes that say how to read a file; null where the author gives none of them. */
export function pickSource(given: GivenSource): GivenSource | null {
  if (sourceNames.every((name) => given[name] === null)) return null;
  return Object.fromEntries(sourceNames.map((name) => [name, given[name]])) as GivenSource;
}
