import { differ } from '../optics/rays/gradient.ts';
import type { GradientStage } from '../optics/rays/gradient.ts';
import type { FieldStage, Sample } from '../optics/rays/ray-stages.ts';
import { stretchOf, localToBeam, unitToLocal } from './polar-geometry.ts';
import type { BeamPoint } from './polar-geometry.ts';
import type { PolarGrid } from '../volume/polar-grid.ts';
import { add, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';

const radians = Math.PI / 180;

/** A radar's field, sampled by range, azimuth and elevation. */
export interface BeamField extends Pick<FieldStage, 'isFolded'> {
  sampleBeam(beam: BeamPoint): Sample;
}

/** Distances between taps: the smallest one along the beam in metres, and the angle in degrees. */
export interface BeamTaps {
  readonly range: number;
  readonly angle: number;
}

/** The resolution of a radar: the width of its beam, but at least one gate and one radial. */
export function beamTaps({ sweeps, beamWidth }: PolarGrid): BeamTaps {
  return {
    range: Math.min(...sweeps.map(({ gateLength }) => gateLength)),
    angle: Math.max(beamWidth, Math.min(...sweeps.map(({ azimuths }) => spacingOf(azimuths)))),
  };
}

/** Degrees between neighbouring radials, without the gap of a sector; 0 for a single radial. */
function spacingOf(azimuths: Float64Array): number {
  const widest = azimuths.reduce(
    (max, azimuth, i) => Math.max(max, azimuth - azimuths[i - 1] || 0),
    360 + azimuths[0] - azimuths[azimuths.length - 1],
  );
  return (360 - widest) / Math.max(1, azimuths.length - 1);
}

/**
 * The gradient of a field in a radar's coordinates: differences along range, azimuth and elevation over the beam's width
 * at the place, then the exact derivatives of the beam's formula, with heights as displayed.
 * Twin: shaders/chunks/radar/gradient-polar.glsl
 */
export function polarGradient(field: BeamField, grid: PolarGrid): GradientStage {
  const taps = beamTaps(grid);
  const stretch = stretchOf(grid);
  return (place, known) => {
    const local = unitToLocal(grid.box, place);
    const beam = localToBeam(local, grid.earthRadius);
    const steps: Vector3 = [Math.max(taps.range, beam.range * taps.angle * radians), taps.angle, taps.angle];
    const perVoxel = differ(
      known,
      (axis, side) => field.sampleBeam(moveBeam(beam, axis, side * steps[axis])),
      field.isFolded,
    );
    const [x, y, z] = beamToLocalGradient(
      [perVoxel[0] / steps[0], perVoxel[1] / (steps[1] * radians), perVoxel[2] / (steps[2] * radians)],
      local,
      grid.earthRadius,
    );
    return { perVoxel, world: [x, y, z / stretch] };
  };
}

function moveBeam({ range, azimuth, elevation }: BeamPoint, axis: number, by: number): BeamPoint {
  if (axis === 0) return { range: range + by, azimuth, elevation };
  if (axis === 1) return { range, azimuth: (azimuth + by + 360) % 360, elevation };
  return { range, azimuth, elevation: elevation + by };
}

/**
 * Converts a gradient by range, azimuth and elevation (per metre and radian) to one by metres east, north and up: the transpose of
 * the derivatives of `localToBeam`.
 * @param local - metres east and north along the ground's arc, and above the antenna
 */
export function beamToLocalGradient(
  [byRange, byAzimuth, byElevation]: Vector3,
  local: Vector3,
  earthRadius: number,
): Vector3 {
  const k = 1 / earthRadius;
  const { range, azimuth, elevation } = localToBeam(local, earthRadius);
  const [sine, cosine] = [Math.sin(elevation * radians), Math.cos(elevation * radians)];
  const [up, along] = [range * sine, range * cosine];
  const arc = Math.max(1e-3, Math.hypot(local[0], local[1]));
  const turn = byElevation / Math.max(1e-3, range);
  // First the derivatives by the height above the antenna's plane and by the distance along it, then from these those by arc and height.
  const [byUp, byAlong] = [byRange * sine + turn * cosine, byRange * cosine - turn * sine];
  const byArc = -byUp * along * k + byAlong * (1 + up * k);
  const byHeight = (byUp * (1 + up * k) + byAlong * along * k) / (1 + local[2] * k);
  const outward: Vector3 = [Math.sin(azimuth * radians), Math.cos(azimuth * radians), 0];
  const clockwise: Vector3 = [outward[1], -outward[0], 0];
  return add(add(scale(outward, byArc), scale(clockwise, byAzimuth / arc)), [0, 0, byHeight]);
}
