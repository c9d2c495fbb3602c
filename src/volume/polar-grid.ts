import type { GridFrame } from './grid.ts';
import type { Vector3 } from './matrix.ts';

/**
 * A radar's grid. Its frame is the box around it, cut into cells about as fine as its gates; samples do not lie at the
 * cells' centres.
 * Local coordinates are metres at the radar's antenna: x east and y north along the ground's arc, z up (the height
 * above the antenna over a round Earth). Azimuths are degrees clockwise from north, elevations degrees above the
 * horizon.
 */
export interface PolarGrid extends GridFrame, SweepGeometry {
  readonly kind: 'polar';
  /** The volume's unit cube in local coordinates. */
  readonly box: LocalBox;
}

/** Positions of a radar's samples: sweeps, each a cone of radials at one elevation, each radial a row of gates. */
export interface SweepGeometry {
  /** By ascending elevation, no two closer than a fifth of the beam. */
  readonly sweeps: readonly Sweep[];
  /** Width of the beam, degrees: data reach half of it below the lowest and above the highest sweep. */
  readonly beamWidth: number;
  /** Metres; 4/3 of the Earth's in the standard model of refraction, Infinity for straight beams over a flat ground. */
  readonly earthRadius: number;
  /**
   * Velocities that differ by more than this are on two sides of a fold, in stored values; absent if values do not
   * fold. `nearestOnly` where values are kinds of things.
   */
  readonly foldFrom?: number;
}

/** As `foldFrom`: no two values are mixed, even equal ones, so the gate with the largest weight gives its value exactly. */
export const nearestOnly = -1;

/** One sweep of a radar. A gap of the antenna is filled with one or two radials without data. */
export interface Sweep {
  /** Degrees. If the radials have elevations of their own, it is the sweep's nominal elevation. */
  readonly elevation: number;
  /**
   * Elevation of each radial, degrees, if some differ from the sweep's. They lie between the elevations of the sweeps
   * below and above, so that only a few sweeps can be next to any point.
   */
  readonly elevations?: Float64Array<ArrayBuffer>;
  /** Middle of each radial, degrees, 0 <= azimuth < 360, ascending, all different. */
  readonly azimuths: Float64Array<ArrayBuffer>;
  /** Metres along the beam from the antenna to the middle of the first gate. */
  readonly firstGate: number;
  /** Metres. */
  readonly gateLength: number;
  readonly gates: number;
  /** Index of the first gate of the first radial in the volume's samples; radials follow one another without gaps. */
  readonly offset: number;
}

/** A box in local metres, x east, y north, z above the antenna: the unit cube of a polar volume. */
export interface LocalBox {
  readonly low: Vector3;
  readonly high: Vector3;
}
