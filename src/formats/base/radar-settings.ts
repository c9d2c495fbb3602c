/** What attributes say about a radar file. */
export interface PolarSettings {
  /** The file's name of the moment. If undefined: the reflectivity that most sweeps hold. */
  readonly moment?: string;
  /** How beams travel: bent by the standard atmosphere over a round Earth, or straight over a flat one. */
  readonly beamModel?: 'standard' | 'straight';
  /** World heights = this factor times the heights. If undefined: a factor that suits the radar's reach. */
  readonly verticalExaggeration?: number;
}

/** What attributes say about radar scans, and about mosaics that hold one. */
export interface RadarSettings extends PolarSettings {
  /** The mosaic is a radar's. */
  readonly spherical?: boolean;
  /** Degrees, one per tile. A mosaic that has elevations is a radar's. */
  readonly elevations?: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /** Middle of the first radial, and the step to the next one, degrees clockwise from north. */
  readonly azimuth?: readonly [number, number];
}

/** Degrees north, degrees east, metres of the antenna above sea level. */
export interface ManifestSite {
  readonly name?: string;
  readonly latitude?: number;
  readonly longitude?: number;
  readonly height?: number;
}

/** The values of one tile; what is absent is the same as for all tiles. */
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

/** What attributes or a manifest say about a radar's mosaic. */
export interface PolarMosaicSettings {
  /** Tiles per row and column, one sweep per tile, row by row from the top left. */
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  /** Number of tiles in use; if undefined, the number of elevations. */
  readonly slices?: number;
  /** Degrees, one per tile. */
  readonly elevations: readonly number[];
  /** Metres to the middle of the first gate, and from gate to gate. */
  readonly range?: readonly [number, number];
  /**
   * Middle of the first radial, and the step to the next one, degrees clockwise from north. If undefined, the radials
   * go evenly around, from north.
   */
  readonly azimuth?: readonly [number, number];
  /** Data value = slope * pixel + intercept. */
  readonly slope: number;
  readonly intercept: number;
  readonly unit: string;
  /** What was measured. */
  readonly moment?: string;
  /** Degrees. */
  readonly beamWidth?: number;
  /** m/s. If set, the values are velocities that fold at this speed. */
  readonly nyquist?: number;
  /** If set, the values are kinds of echo, whole numbers between which nothing lies; those that are listed can occur. */
  readonly labels?: readonly { readonly id: number }[];
  readonly site?: ManifestSite;
  /** ISO 8601 in UTC. */
  readonly time?: string;
  /** Values of single tiles that differ. */
  readonly sweeps?: readonly ManifestSweep[];
}

/** What only a manifest can say about a radar's mosaic. */
export type MosaicValues = Partial<
  Pick<
    PolarMosaicSettings,
    'slope' | 'intercept' | 'unit' | 'beamWidth' | 'nyquist' | 'labels' | 'site' | 'time' | 'sweeps' | 'moment'
  >
>;
