import { cellSize, offLine } from '../volume/cell-size.ts';
import { emptyMacrocells } from '../volume/macrocells.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { highestElevation, lowestElevation } from './polar-box.ts';
import { spanOfRing } from './polar-geometry.ts';
import type { BeamSpan } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { countUpTo, spanOfSweep, sweepsAround } from './sweep-elevations.ts';
import type { ElevationSpan } from './sweep-elevations.ts';
import type { Samples } from '../volume/volume.ts';

/** What finding the radials of a sweep takes, in gates. */
const workPerSweep = 64;

/** Cells are taken so much larger on each side, as shares of their edges, that rounding brings no point out of them. */
const margin = 1e-3;

/** What is looked through. */
interface Gates {
  readonly samples: Samples;
  readonly grid: PolarGrid;
  readonly onWork: (gates: number) => void;
  /** Elevations of each sweep's radials. */
  readonly spans: readonly ElevationSpan[];
  /** Between which elevations there are data. */
  readonly reach: ElevationSpan;
}

/** Azimuths (degrees) from one to another, clockwise; `width` 360 is the whole circle. */
interface Sector {
  readonly from: number;
  readonly width: number;
}

/**
 * The range of every value that interpolation can give at a point of each cell of a polar volume's box: of all gates in
 * the smallest span of ranges, azimuths and elevations that holds the cell, and of the first ones around it.
 * `cellSize` cells of its frame make one macrocell's edge.
 * @param onWork - is told before so many gates are looked through: few radials of many gates, or sweeps by the hundred, are much
 * work for a few bytes
 */
export function buildPolarMacrocells(samples: Samples, grid: PolarGrid, onWork: (gates: number) => void = () => undefined): Macrocells {
  const { dimensions } = grid;
  const cells = dimensions.map((n) => Math.ceil(n / cellSize)) as unknown as Vector3;
  const { low, high, roughness } = emptyMacrocells(samples, cells);
  const gates: Gates = { samples, grid, onWork, spans: grid.sweeps.map(spanOfSweep), reach: [lowestElevation(grid), highestElevation(grid)] };
  const edges = [0, 1, 2].map((axis) => cutEdge(grid, axis, dimensions[axis], cells[axis]));
  for (let j = 0; j < cells[1]; j++) {
    for (let i = 0; i < cells[0]; i++) {
      const [x, y] = [edges[0][i], edges[1][j]];
      const arcs = arcsOf(x, y);
      const sector = sectorOf(x, y);
      for (let k = 0; k < cells[2]; k++) {
        const span = spanOfRing(arcs, edges[2][k], grid.earthRadius);
        const [least, greatest] = rangeOfSpan(gates, span, sector);
        if (!(least <= greatest)) continue; // no data
        const cell = i + cells[0] * (j + cells[1] * k);
        low[cell] = least;
        high[cell] = greatest;
        // Between gates, radials and sweeps any value of the cell's may be.
        roughness[cell] = (greatest - least) / offLine;
      }
    }
  }
  return { dimensions: cells, low, high, roughness };
}

/** Where each macrocell begins and ends along an axis, metres. */
function cutEdge({ box }: PolarGrid, axis: number, voxels: number, cells: number): [number, number][] {
  const cell = ((box.high[axis] - box.low[axis]) / voxels) * cellSize;
  return Array.from({ length: cells }, (_, i) => [
    box.low[axis] + (i - margin) * cell,
    Math.min(box.high[axis] + margin * cell, box.low[axis] + (i + 1 + margin) * cell),
  ]);
}

type Interval = readonly [number, number];

/** Least and greatest distance of a rectangle's points from the antenna. */
function arcsOf(x: Interval, y: Interval): Interval {
  const nearest = ([from, to]: Interval): number => Math.max(0, from, -to);
  const farthest = ([from, to]: Interval): number => Math.max(-from, to);
  return [Math.hypot(nearest(x), nearest(y)), Math.hypot(farthest(x), farthest(y))];
}

/** Azimuths of a rectangle's points: its corners are the extremes, seen from outside of it. */
function sectorOf(x: Interval, y: Interval): Sector {
  if (x[0] <= 0 && x[1] >= 0 && y[0] <= 0 && y[1] >= 0) return { from: 0, width: 360 };
  const toward = Math.atan2(x[0] + x[1], y[0] + y[1]);
  let [left, right] = [0, 0];
  for (const u of x) {
    for (const v of y) {
      const turn = Math.atan2(u, v) - toward;
      const nearest = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      left = Math.min(left, nearest);
      right = Math.max(right, nearest);
    }
  }
  const degrees = 180 / Math.PI;
  return { from: (((toward + left) * degrees) % 360 + 360) % 360, width: (right - left) * degrees };
}

function rangeOfSpan(gates: Gates, span: BeamSpan, sector: Sector): [number, number] {
  const { spans, reach } = gates;
  const { sweeps } = gates.grid;
  const range: [number, number] = [Infinity, -Infinity];
  if (span.elevation[1] < reach[0] || span.elevation[0] > reach[1]) return range;
  const [first, last] = sweepsAround(sweeps, spans, span.elevation);
  for (let i = first; i <= last; i++) widenBySweep(range, gates, sweeps[i], { span, sector });
  return range;
}

function widenBySweep(
  range: [number, number],
  { samples, onWork }: Gates,
  sweep: Sweep,
  { span, sector }: { span: BeamSpan; sector: Sector },
): void {
  const { azimuths, firstGate, gateLength, gates, offset } = sweep;
  const places = span.range.map((r) => (r - firstGate) / gateLength);
  if (places[1] < -0.5 || places[0] > gates - 0.5) return onWork(1);
  const firstOf = Math.min(gates - 1, Math.max(0, Math.floor(places[0])));
  const lastOf = Math.min(gates - 1, Math.floor(places[1]) + 1);
  const radials = azimuths.length;
  const upTo = (azimuth: number): number => countUpTo(radials, (radial) => azimuths[radial] <= azimuth);
  // Radials from the one at or before the sector to the one after it; indices go on beyond the seam.
  const before = upTo(sector.from) - 1;
  const to = sector.from + sector.width;
  const after = to < 360 ? upTo(to) : radials + upTo(to - 360);
  const [firstRadial, lastRadial] = sector.width >= 360 ? [0, radials - 1] : [before, Math.min(after, before + radials - 1)];
  onWork(workPerSweep + (lastRadial - firstRadial + 1) * (lastOf - firstOf + 1));
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  let [low, high] = range;
  for (let radial = firstRadial; radial <= lastRadial; radial++) {
    const row = offset + ((radial + radials) % radials) * gates;
    for (let at = row + firstOf; at <= row + lastOf; at++) {
      const value = samples[at];
      // NaN is neither less nor greater than anything.
      if (value < minValid) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  range[0] = low;
  range[1] = high;
}
