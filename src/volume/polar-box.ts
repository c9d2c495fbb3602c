import type { Vector3 } from './matrix.ts';
import { beamToLocal } from './polar-geometry.ts';
import type { LocalBox } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from './polar-grid.ts';
import type { Samples } from './volume.ts';

/** Most cells along x, y and z, as many as a texture of a cartesian volume of this kind would have. */
const mostCells: Vector3 = [1024, 1024, 128];

const degrees = 180 / Math.PI;

/**
 * The box around everything that can be shown. Across it holds all gates, so that scans of one radar have one width; up
 * it ends above the highest gate with data, as the sky that a radar scans is ten times as high as any weather.
 * @param samples - no data is 0 (integers) or NaN (floats)
 */
export function boxAround(grid: Omit<PolarGrid, 'box'>, samples: Samples): LocalBox {
  const { sweeps, earthRadius } = grid;
  const curvature = 1 / earthRadius;
  const extent = { width: 0, reach: 0, top: -Infinity };
  sweeps.forEach((sweep, i) => {
    const end = rangeOfEnd(sweep, sweep.gates);
    const below = i > 0 ? sweeps[i - 1].elevation : lowestElevation(grid);
    // On a round Earth a beam reaches farthest along the ground when it points a little below the horizon.
    const flattest = Math.min(sweep.elevation, Math.max(below, -Math.asin(Math.min(1, curvature * end)) * degrees));
    extent.width = Math.max(extent.width, beamToLocal({ range: end, azimuth: 90, elevation: flattest }, earthRadius)[0]);
    extent.reach = Math.max(extent.reach, end);
    const above = i + 1 < sweeps.length ? (sweep.elevation + sweeps[i + 1].elevation) / 2 : highestElevation(grid);
    const filled = countFilledGates(sweep, samples);
    if (filled > 0) extent.top = Math.max(extent.top, heightAt(rangeOfEnd(sweep, filled + 1), above, earthRadius));
  });
  const low = lowestHeight(lowestElevation(grid), extent.reach, earthRadius);
  const top = Number.isFinite(extent.top) ? extent.top : heightAt(extent.reach, highestElevation(grid), earthRadius);
  const high = Math.max(top, low + sweeps[0].gateLength);
  return { low: [-extent.width, -extent.width, low], high: [extent.width, extent.width, high] };
}

/**
 * Cells that the box is cut into: about a gate long, half a gate high.
 * @param gateLength - metres
 */
export function boxDimensions({ low, high }: LocalBox, gateLength: number): Vector3 {
  const cell = [gateLength, gateLength, gateLength / 2];
  return [0, 1, 2].map((axis) => {
    const cells = Math.ceil((high[axis] - low[axis]) / cell[axis]);
    return Math.min(mostCells[axis], Math.max(1, cells));
  }) as unknown as Vector3;
}

/** Degrees: half a beam below the lowest sweep, down to the nadir. */
export function lowestElevation({ sweeps, beamWidth }: Omit<PolarGrid, 'box'>): number {
  return Math.max(-90, sweeps[0].elevation - beamWidth / 2);
}

/** Degrees: half a beam above the highest sweep, up to the zenith. */
export function highestElevation({ sweeps, beamWidth }: Omit<PolarGrid, 'box'>): number {
  return Math.min(90, sweeps.at(-1)!.elevation + beamWidth / 2);
}

/** Metres to the far end of the first so many gates. */
function rangeOfEnd({ firstGate, gateLength, gates }: Sweep, count: number): number {
  return firstGate + (Math.min(count, gates) - 0.5) * gateLength;
}

function heightAt(range: number, elevation: number, earthRadius: number): number {
  return beamToLocal({ range, azimuth: 0, elevation }, earthRadius)[2];
}

/** Beams that point down come nearest to the Earth on their way, where it bends away under them. */
function lowestHeight(elevation: number, reach: number, earthRadius: number): number {
  if (elevation >= 0) return 0;
  const nearest = Math.min(reach, Math.sin(-elevation / degrees) * earthRadius);
  return heightAt(nearest, elevation, earthRadius);
}

/** Gates up to the last one that holds data in any ray. */
function countFilledGates({ azimuths, gates, offset }: Sweep, samples: Samples): number {
  const isFloat = samples instanceof Float32Array;
  let filled = 0;
  for (let ray = 0; ray < azimuths.length; ray++) {
    const first = offset + ray * gates;
    for (let gate = gates - 1; gate >= filled; gate--) {
      const value = samples[first + gate];
      if (isFloat ? Number.isFinite(value) : value !== 0) filled = gate + 1;
    }
  }
  return filled;
}
