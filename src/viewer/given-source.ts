import type { Vector3 } from '../volume/matrix.ts';
import type { Given } from './parse-attributes.ts';

/** What an author says of how a file is to be read, by attribute. */
export interface GivenSource {
  readonly mosaic: string | null;
  readonly slices: Given<number>;
  readonly spacing: Given<Vector3>;
  readonly coordinates: string | null;
  readonly elevations: Given<readonly number[]>;
  readonly range: Given<readonly [number, number]>;
  readonly azimuth: Given<readonly [number, number]>;
  readonly moment: string | null;
  readonly beamModel: string | null;
  readonly verticalExaggeration: Given<number>;
}

const names = ['mosaic', 'slices', 'spacing', 'coordinates', 'elevations', 'range', 'azimuth', 'moment', 'beamModel', 'verticalExaggeration'] as const;

/** That part of what an author says; null where there is nothing of it. */
export function pickSource(given: GivenSource): GivenSource | null {
  if (names.every((name) => given[name] === null)) return null;
  return Object.fromEntries(names.map((name) => [name, given[name]])) as unknown as GivenSource;
}
