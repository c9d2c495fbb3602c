import type { PolarMosaicSettings } from '../radar/polar-mosaic.ts';

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

/** What a manifest alone says of a radar's mosaic. */
export type MosaicValues = Partial<Pick<PolarMosaicSettings, 'slope' | 'intercept' | 'unit' | 'beamWidth' | 'nyquist' | 'site' | 'time' | 'sweeps' | 'moment'>>;
