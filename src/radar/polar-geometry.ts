import { scaleAndTranslate } from '../volume/matrix.ts';
import { unitToWorld } from '../volume/grid.ts';
import type { LocalBox } from '../volume/polar-grid.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { Grid } from '../volume/volume.ts';

/** Metres: the mean Earth radius that radar programs use (Py-ART, and wradlib's default). */
export const meanEarthRadius = 6_371_000;

/**
 * Metres: the radius of an Earth on which a beam through the standard atmosphere would be straight, 4/3 of the real radius.
 * Source: Doviak and Zrnic, *Doppler Radar and Weather Observations*, 1993, eq. 2.28
 */
export const standardEarthRadius = (4 / 3) * meanEarthRadius;

/** A place in a radar's coordinates. */
export interface BeamPoint {
  /** Metres along the beam from the antenna. */
  readonly range: number;
  /** Degrees clockwise from north, 0 <= azimuth < 360; 0 straight above and below the antenna. */
  readonly azimuth: number;
  /** Degrees above the horizon, -90..90; 0 at the antenna itself. */
  readonly elevation: number;
}

const radians = Math.PI / 180;

/**
 * The place of a gate.
 * @param earthRadius - metres; Infinity for straight beams over a flat ground
 * @returns metres east and north along the ground's arc, and above the antenna
 * Source: Doviak and Zrnic 1993, eq. 2.28 b and c, written with 1 / radius and without differences of large numbers
 */
export function beamToLocal({ range, azimuth, elevation }: BeamPoint, earthRadius: number): Vector3 {
  const curvature = 1 / earthRadius;
  const up = range * Math.sin(elevation * radians);
  const along = range * Math.cos(elevation * radians);
  const stretch = Math.sqrt(1 + curvature * (2 * up + curvature * range * range));
  const height = (2 * up + curvature * range * range) / (1 + stretch);
  const arc = curvature > 0 ? Math.atan2(curvature * along, 1 + curvature * up) / curvature : along;
  return [arc * Math.sin(azimuth * radians), arc * Math.cos(azimuth * radians), height];
}

/**
 * Range, azimuth and elevation of a place: the inverse of `beamToLocal`, in a form that is exact enough in float32.
 * @param local - metres east and north along the ground's arc, and above the antenna
 */
export function localToBeam([x, y, z]: Vector3, earthRadius: number): BeamPoint {
  const { up, along } = climbAt(Math.hypot(x, y), 1 / earthRadius)(z);
  const azimuth = Math.atan2(x, y) / radians;
  return {
    range: Math.hypot(up, along),
    // A place just west of north would be rounded to 360.
    azimuth: azimuth < 0 ? (azimuth + 360) % 360 : azimuth,
    elevation: Math.atan2(up, along) / radians,
  };
}

/**
 * How far a place is above the cone of beams of one elevation, perpendicular to the cone; negative if it is below.
 * @param local - metres east and north along the ground's arc, and above the antenna
 * @param elevation - degrees
 * @returns metres
 */
export function heightOverCone([x, y, z]: Vector3, elevation: number, earthRadius: number): number {
  const { up, along } = climbAt(Math.hypot(x, y), 1 / earthRadius)(z);
  return up * Math.cos(elevation * radians) - along * Math.sin(elevation * radians);
}

/**
 * Maps a height above the antenna to straight distances in metres, for places at one distance: above the antenna's horizontal plane, and
 * along it.
 */
type Climb = (height: number) => { up: number; along: number };

/**
 * By the law of cosines.
 * @param arc - metres along the ground
 * @param curvature - 1 / metres; 0 for flat ground
 */
function climbAt(arc: number, curvature: number): Climb {
  const angle = arc * curvature;
  const chord = curvature > 0 ? (2 / curvature) * Math.sin(angle / 2) : arc;
  const level = Math.cos(angle / 2);
  return (height) => {
    const stretch = 1 + height * curvature;
    return { up: height - 0.5 * stretch * chord * chord * curvature, along: stretch * chord * level };
  };
}

/** Maps a point of the unit cube to local metres. */
export function unitToLocal({ low, high }: LocalBox, p: Vector3): Vector3 {
  return [0, 1, 2].map((axis) => low[axis] + p[axis] * (high[axis] - low[axis])) as unknown as Vector3;
}

/**
 * The lattice that cuts a box into cells. World coordinates are local ones with stretched heights.
 * @param dimensions - number of cells along x, y and z
 * @param verticalExaggeration - world height = this times the height
 * @returns row-major: cell index, integers at cell centres, to world
 */
export function boxIndexToWorld({ low, high }: LocalBox, dimensions: Vector3, verticalExaggeration: number): Matrix4 {
  const stretch = [1, 1, verticalExaggeration];
  const cell = [0, 1, 2].map(
    (axis) => ((high[axis] - low[axis]) / dimensions[axis]) * stretch[axis],
  ) as unknown as Vector3;
  const first = [0, 1, 2].map((axis) => low[axis] * stretch[axis] + cell[axis] / 2) as unknown as Vector3;
  return scaleAndTranslate(cell, first);
}

/** World length of a metre of height: a radar's vertical exaggeration; 1 for other grids. */
export function stretchOf(grid: Grid): number {
  if (grid.kind !== 'polar') return 1;
  const { low, high } = grid.box;
  return unitToWorld(grid)[10] / (high[2] - low[2]);
}

/** Smallest and largest range (metres) and elevation (degrees) of all points of a ring around the antenna. */
export interface BeamSpan {
  readonly range: readonly [number, number];
  readonly elevation: readonly [number, number];
}

/**
 * The ranges and elevations of rings that lie one above another.
 * @param arcs - smallest and largest ground distance, metres
 * @returns a function of a ring's smallest and largest height above the antenna, metres
 */
export function spansOfRings(
  arcs: readonly [number, number],
  earthRadius: number,
): (heights: readonly [number, number]) => BeamSpan {
  const curvature = 1 / earthRadius;
  const clamp = (value: number, [low, high]: readonly [number, number]): number => Math.min(high, Math.max(low, value));
  const rangeOf = ({ up, along }: ReturnType<Climb>): number => Math.sqrt(up * up + along * along); // Math.hypot takes ten times as long.
  const elevationOf = ({ up, along }: ReturnType<Climb>): number => Math.atan2(up, along) / radians;
  const [near, far] = arcs.map((arc) => climbAt(arc, curvature));
  const chord = curvature > 0 ? (2 / curvature) * Math.sin((arcs[0] * curvature) / 2) : arcs[0];
  return (heights) => {
    // Range grows with the arc. Over the height, it is smallest where the place is level with the antenna's chord.
    const nearest = rangeOf(near(clamp((-chord * chord * curvature) / 2, heights)));
    const [low, high] = [far(heights[0]), far(heights[1])];
    // Elevation grows with the height. Above the antenna, it falls with the arc. Below, it first rises up to the place where
    // the line of sight is level with the ground.
    const levelArc =
      heights[1] < 0 && curvature > 0 ? Math.acos(Math.max(-1, 1 + heights[1] * curvature)) / curvature : 0;
    const steepest = heights[1] < 0 ? climbAt(clamp(curvature > 0 ? levelArc : Infinity, arcs), curvature) : near;
    return {
      range: [nearest, Math.max(rangeOf(low), rangeOf(high))],
      elevation: [Math.min(elevationOf(near(heights[0])), elevationOf(low)), elevationOf(steepest(heights[1]))],
    };
  };
}
