/** What attributes say of a radar file. */
export interface PolarSettings {
  /** As the file names it; of the reflectivities the one that most sweeps hold where undefined. */
  readonly moment?: string;
  /** How beams run: bent by the standard atmosphere over a round Earth, or straight over a flat one. */
  readonly beamModel?: 'standard' | 'straight';
  /** World heights = this times the heights; what suits the radar's reach where undefined. */
  readonly verticalExaggeration?: number;
}

/** What attributes say of radar scans, and of mosaics that hold one. */
export interface RadarSettings extends PolarSettings {
  /** The mosaic is a radar's. */
  readonly spherical?: boolean;
  /** Degrees, one a tile; a mosaic that has some is a radar's. */
  readonly elevations?: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /** Middle of the first radial and step to the next one, degrees clockwise from north. */
  readonly azimuth?: readonly [number, number];
}

/** Degrees north, degrees east, metres of the antenna above sea level. */
export interface ManifestSite {
  readonly name?: string;
  readonly latitude?: number;
  readonly longitude?: number;
  readonly height?: number;
}

/** What a tile has of its own; what is absent is as for all. */
export interface ManifestSweep {
  /** Radials and gates in the tile, from its top left; the whole tile if absent. */
  readonly rays?: number;
  readonly gates?: number;
  readonly range?: readonly [number, number];
  readonly azimuth?: readonly [number, number];
  /** Middle of each radial, degrees clockwise from north, if they are not evenly spaced. */
  readonly azimuths?: readonly number[];
  /** Elevation of each radial, degrees, if they differ from the tile's. */
  readonly elevations?: readonly number[];
  readonly nyquist?: number;
  readonly time?: string;
}

/** What attributes or a manifest say of a radar's mosaic. */
export interface PolarMosaicSettings {
  /** Tiles per row and column, a sweep a tile, row by row from the top left. */
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  /** Tiles in use; as many as there are elevations where undefined. */
  readonly slices?: number;
  /** Degrees, one a tile. */
  readonly elevations: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /** Middle of the first radial and step to the next one, degrees clockwise from north; around from north where undefined. */
  readonly azimuth?: readonly [number, number];
  /** Data value = slope * pixel + intercept. */
  readonly slope: number;
  readonly intercept: number;
  readonly unit: string;
  /** What was measured. */
  readonly moment?: string;
  /** Degrees. */
  readonly beamWidth?: number;
  /** m/s: the values are velocities that fold over beyond. */
  readonly nyquist?: number;
  readonly site?: ManifestSite;
  /** ISO 8601 in UTC. */
  readonly time?: string;
  /** What is another for single tiles. */
  readonly sweeps?: readonly ManifestSweep[];
}

/** What a manifest alone says of a radar's mosaic. */
export type MosaicValues = Partial<Pick<PolarMosaicSettings, 'slope' | 'intercept' | 'unit' | 'beamWidth' | 'nyquist' | 'site' | 'time' | 'sweeps' | 'moment'>>;
