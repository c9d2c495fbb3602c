/** What a reader of radar files gives: everything that the file says of its sweeps, and the values of each on demand. */
export interface RadarFile {
  /** 'ODIM_H5 2.2', 'NEXRAD Level II', 'CfRadial 1.3', … */
  readonly format: string;
  /** Degrees north, degrees east, metres above sea level of the antenna; what the file does not say is absent. */
  readonly site: { readonly name?: string; readonly latitude?: number; readonly longitude?: number; readonly height?: number };
  /** When the scan began, ISO 8601 in UTC with seconds ('2018-12-20T06:06:28Z'); absent where the file does not say. */
  readonly time?: string;
  /** Width of the beam (3 dB), degrees. */
  readonly beamWidth?: number;
  /** Quantities in the file, in its order, each once. */
  readonly moments: readonly RadarMoment[];
  /** In the file's own order, duplicates and all. */
  readonly sweeps: readonly RadarSweep[];
  /** What of the file is not used, and what had to be assumed, in an author's words, where that changes what is seen. */
  readonly left?: readonly string[];
  /** The same where it changes nothing that is seen. */
  readonly details?: readonly string[];
  /** Set where the file was cut short or damaged and only its first part could be read: says what is missing. */
  readonly partial?: string;
}

/** A quantity that a radar measures. */
export interface RadarMoment {
  /** As the file names it: 'DBZH', 'REF', 'reflectivity', … */
  readonly name: string;
  /** 'dBZ', 'm/s', … ; '' where unknown. */
  readonly unit: string;
  readonly kind: MomentKind;
}

/** What a moment is, whatever a file calls it. */
export type MomentKind =
  | 'reflectivity'
  | 'velocity'
  | 'spectrum-width'
  | 'differential-reflectivity'
  | 'differential-phase'
  | 'correlation'
  | 'other';

/** One sweep as it is in the file: radials in the file's order. */
export interface RadarSweep {
  /** Degrees: the sweep's nominal ("fixed") elevation, or the mean of its radials' where there is none. */
  readonly elevation: number;
  /** Middle of each radial, degrees clockwise from north, 0 <= azimuth < 360, in the file's order. */
  readonly azimuths: Float64Array<ArrayBuffer>;
  /** Elevation of each radial, degrees, in the file's order; absent where the file does not say. */
  readonly elevations?: Float64Array<ArrayBuffer>;
  /** Of each radial, 1 where the antenna was on its way to another elevation: it is no part of the sweep. Absent where there are none, or the file does not say. */
  readonly transitions?: Uint8Array;
  /** ISO 8601, when the sweep began. */
  readonly time?: string;
  /** m/s: speeds beyond fold over. */
  readonly nyquist?: number;
  /** What of it is not used, or had to be assumed: said where the sweep is shown. */
  readonly left?: readonly string[];
  /** What is wrong with one of its moments, as the radar itself says; undefined where nothing is. */
  faultOf?(moment: string): string | undefined;
  /** The moments that this sweep holds. */
  readonly moments: readonly string[];
  /** Where the gates of one of its moments lie, before they are read; null where the sweep does not hold it. */
  gridOf(moment: string): SweepGates | null;
  /** The gates of one of its moments; null where the sweep does not hold it. The budget counts them only while they are read. */
  read(moment: string): SweepData | null;
}

/** Where gates lie along each radial of a sweep. */
export interface SweepGates {
  /** Metres along the beam to the middle of the first gate. */
  readonly firstGate: number;
  /** Metres. */
  readonly gateLength: number;
  readonly gates: number;
}

/** The values of one moment in one sweep. */
export interface SweepData extends SweepGates {
  /** Shape [radials, gates], the file's radial order. Integers: 0 means no data (a reader shifts or maps what stands for it);
   * floats: NaN does. */
  readonly samples: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>;
  /** Data value = slope * sample + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Gates whose values are outside of what the file calls valid, and are no data; absent for none. */
  readonly invalid?: number;
}
