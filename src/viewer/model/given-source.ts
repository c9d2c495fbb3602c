const names = ['mosaic', 'slices', 'spacing', 'coordinates', 'elevations', 'range', 'azimuth', 'moment', 'beamModel', 'verticalExaggeration', 'clean'] as const;

/** An attribute that says how a file is to be read, by property. */
export type SourceName = (typeof names)[number];

export type GivenSource = Readonly<Record<SourceName, string | null>>;

/** That part of what an author says; null where there is nothing of it. */
export function pickSource(given: GivenSource): GivenSource | null {
  if (names.every((name) => given[name] === null)) return null;
  return Object.fromEntries(names.map((name) => [name, given[name]])) as GivenSource;
}
