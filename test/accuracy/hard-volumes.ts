// Volumes that are hard to draw right, or to tell the error of.
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { PolarVolume, Volume } from '../../src/volume/volume.ts';
import { radarVolume } from '../helpers/synthetic-radar.ts';
import { obliqueAffine, randomNumbers, syntheticVolume } from '../helpers/synthetic.ts';
import type { SyntheticOptions } from '../helpers/synthetic.ts';

/** A value, 0..1, of each voxel. */
type OfVoxel = (i: number, j: number, k: number) => number;

/** A volume whose voxels are told by their index. */
export function byIndex(dimensions: Vector3, of: OfVoxel, more: Partial<SyntheticOptions> = {}): Volume {
  const [nx, ny, nz] = dimensions;
  return syntheticVolume({
    ...more,
    dimensions,
    field: (x, y, z) => of(Math.floor(x * nx), Math.floor(y * ny), Math.floor(z * nz)),
  });
}

/** One value, but for some voxels. */
export function withVoxels(
  dimensions: Vector3,
  places: readonly Vector3[],
  {
    value = 1,
    around = 0,
    ...more
  }: Partial<SyntheticOptions> & { readonly value?: number; readonly around?: number } = {},
): Volume {
  const set = new Set(places.map(String));
  return byIndex(dimensions, (...at) => (set.has(String(at)) ? value : around), more);
}

/** So many places inside of a grid, the same in every run. */
export function scatter(dimensions: Vector3, count: number, { seed = 7, margin = 3 } = {}): Vector3[] {
  const random = randomNumbers(seed);
  return Array.from(
    { length: count },
    () =>
      dimensions.map((n) =>
        Math.min(n - 1, Math.floor(margin + random() * Math.max(1, n - 2 * margin))),
      ) as unknown as Vector3,
  );
}

/** No two neighbours have anything in common. */
export function noise(dimensions: Vector3, seed = 3, more: Partial<SyntheticOptions> = {}): Volume {
  const random = randomNumbers(seed);
  return syntheticVolume({ ...more, dimensions, field: random });
}

/** A ball with a soft rim so many voxels wide. */
export function ball(edge: number, radius: number, rim: number): Volume {
  const middle = (edge - 1) / 2;
  return byIndex([edge, edge, edge], (i, j, k) =>
    Math.min(1, Math.max(0, 0.5 + (radius - Math.hypot(i - middle, j - middle, k - middle)) / rim)),
  );
}

/** Values that rise along one axis, and 0 where a mask has holes. */
export function masked(edge: number): Volume {
  const at = (n: number): number => n / edge - 0.5;
  return byIndex([edge, edge, edge], (i, j, k) =>
    Math.hypot(at(i), at(j), at(k)) < 0.42 ? 0.2 + (0.6 * (i + 0.3 * j + 0.1 * k)) / (1.4 * edge) : 0,
  );
}

/** Specks with holes without data next to them. */
export function holes(edge: number, count: number): Volume {
  const places = scatter([edge, edge, edge], count);
  const volume = withVoxels([edge, edge, edge], places, { kind: 'float32', around: 0.3 });
  for (const [i, j, k] of places) volume.samples[i + 1 + edge * (j + edge * k)] = NaN;
  return { ...volume, hasNoData: true, macrocells: buildMacrocells(volume.samples, [edge, edge, edge]) };
}

/** Of a grid that is sheared and turned. */
export function sheared(dimensions: Vector3, places: readonly Vector3[], spacing: Vector3 = [1, 1, 1]): Volume {
  return withVoxels(dimensions, places, { indexToWorld: obliqueAffine(randomNumbers(2), spacing) });
}

/** A radar that sees nothing near, and some gates far away. */
export function farGates(): PolarVolume {
  return radarVolume(
    {
      beamWidth: 1,
      sweeps: Array.from({ length: 6 }, (_, i) => ({
        elevation: 1 + 3 * i,
        gates: 40,
        gateLength: 500,
        firstGate: 60_000,
        kind: 'uint8',
        slope: 1 / 254,
        intercept: 0,
        stored: (azimuth, gate) => (gate === 20 && azimuth > 60 && azimuth < 100 ? 255 : 1),
      })),
    },
    { beamModel: 'straight', verticalExaggeration: 1 },
  );
}
