/**
 * What a reader of radar files returns: everything that the file says about its sweeps, and the values of each on
 * demand.
 */
export interface RadarFile {
  /** 'ODIM_H5 2.2', 'NEXRAD Level II', 'CfRadial 1.3', … */
  readonly format: string;
  /** Degrees north, degrees east, metres above sea level of the antenna; what the file does not say is absent. */
  readonly site: {
    readonly name?: string;
    readonly latitude?: number;
    readonly longitude?: number;
    readonly height?: number;
  };
  /** When the scan began, ISO 8601 in UTC with seconds ('2018-12-20T06:06:28Z'); absent if the file does not say it. */
  readonly time?: string;
  /** Width of the beam (3 dB), degrees. */
  readonly beamWidth?: number;
  /** Quantities in the file, in its order, each once. */
  readonly moments: readonly RadarMoment[];
  /** In the file's own order, including repeated ones. */
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
  /** The file's name of it: 'DBZH', 'REF', 'reflectivity', … */
  readonly name: string;
  /** 'dBZ', 'm/s', … ; '' where unknown. */
  readonly unit: string;
  readonly kind: MomentKind;
  /** Of kinds of echo: the smallest and the largest number that can occur, so that a kind has one colour in all files. */
  readonly numbers?: readonly [number, number];
}

/** The kind of a moment, whatever a file calls it. */
export type MomentKind =
  | 'reflectivity'
  | 'velocity'
  | 'spectrum-width'
  | 'differential-reflectivity'
  | 'differential-phase'
  | 'correlation'
  /** Numbers that stand for kinds of echo: nothing lies between two of them. */
  | 'kinds'
  | 'other';

/** One sweep as it is in the file: radials in the file's order. */
export interface RadarSweep {
  /** Degrees: the sweep's nominal ("fixed") elevation, or if there is none, the mean of its radials'. */
  readonly elevation: number;
  /** Middle of each radial, degrees clockwise from north, 0 <= azimuth < 360, in the file's order. */
  readonly azimuths: Float64Array<ArrayBuffer>;
  /** Elevation of each radial, degrees, in the file's order; absent if the file does not say it. */
  readonly elevations?: Float64Array<ArrayBuffer>;
  /**
   * For each radial 1 if the antenna was moving to another elevation: it is not part of the sweep. Absent if there are
   * none, or the file does not say it.
   */
  readonly transitions?: Uint8Array;
  /** ISO 8601, when the sweep began. */
  readonly time?: string;
  /** m/s: faster velocities fold. */
  readonly nyquist?: number;
  /** What of it is not used, or had to be assumed: shown with the sweep. */
  readonly left?: readonly string[];
  /** What is wrong with one of its moments, as the radar itself says; undefined where nothing is. */
  faultOf?(moment: string): string | undefined;
  /** The moments that this sweep holds. */
  readonly moments: readonly string[];
  /** Where the gates of one of its moments lie, before they are read; null if the sweep does not hold it. */
  gridOf(moment: string): SweepGates | null;
  /**
   * The gates of one of its moments; null if the sweep does not hold it. The budget counts them only while they are
   * read.
   */
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
  /**
   * Shape [radials, gates], in the file's radial order. No data is 0 for integers (readers shift or map the file's
   * values) and NaN for floats.
   */
  readonly samples: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>;
  /** Data value = slope * sample + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Gates whose values are outside of what the file calls valid, and are no data; absent for none. */
  readonly invalid?: number;
}
