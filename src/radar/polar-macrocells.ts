import { chooseCellSize } from '../volume/cell-size.ts';
import { offLine } from '../volume/grid.ts';
import { emptyMacrocells } from '../volume/macrocells.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import { spansOfRings } from './polar-geometry.ts';
import type { BeamSpan } from './polar-geometry.ts';
import type { PolarGrid, Sweep } from '../volume/polar-grid.ts';
import { countUpTo, reachOfSweeps, spanOfSweep, sweepsAround } from './sweep-elevations.ts';
import type { ElevationSpan } from './sweep-elevations.ts';
import type { Samples } from '../volume/volume.ts';

/** The work of finding the radials of a sweep, in gates. */
const workPerSweep = 64;

/** Cells are enlarged on each side by this share of their edges, so that rounding moves no point out of them. */
const margin = 1e-3;

/** What the search for ranges needs. */
interface Gates {
  readonly grid: PolarGrid;
  readonly onWork: (gates: number) => void;
  /** For each sweep, its part in the current column of cells. */
  readonly columns: readonly SweepInColumn[];
  /** Elevations of each sweep's radials. */
  readonly spans: readonly ElevationSpan[];
  /** The elevations in which gates of each sweep are shown. */
  readonly reaches: readonly ElevationSpan[];
}

/** Azimuths (degrees) from one to another, clockwise; a `width` of 360 is the whole circle. */
interface Sector {
  readonly from: number;
  readonly width: number;
}

/**
 * The range of every value that interpolation can give at a point of each cell of a polar volume's box. It is the range of all gates in
 * the smallest span of ranges, azimuths and elevations that contains the cell, and of the first gates around this span.
 * @param onWork - called with the number of gates before they are read: few radials with many gates, or hundreds of sweeps, are much
 * work for a few bytes
 */
export function buildPolarMacrocells(
  samples: Samples,
  grid: PolarGrid,
  onWork: (gates: number) => void = () => undefined,
): Macrocells {
  const { dimensions } = grid;
  const macrocells = emptyMacrocells(samples, dimensions, chooseCellSize(dimensions));
  const { dimensions: cells, size, low, high, roughness } = macrocells;
  const columns = grid.sweeps.map((sweep) => new SweepInColumn(sweep, samples));
  const spans = grid.sweeps.map(spanOfSweep);
  const gates: Gates = {
    grid,
    onWork,
    columns,
    spans,
    reaches: reachOfSweeps(grid, spans).map(({ elevations }) => elevations),
  };
  const edges = [0, 1, 2].map((axis) => cutEdge(grid, axis, cells[axis], size));
  for (let j = 0; j < cells[1]; j++) {
    for (let i = 0; i < cells[0]; i++) {
      const [x, y] = [edges[0][i], edges[1][j]];
      const spanOf = spansOfRings(arcsOf(x, y), grid.earthRadius);
      const sector = sectorOf(x, y);
      for (const column of columns) column.begin(sector);
      for (let k = 0; k < cells[2]; k++) {
        const [min, greatest] = rangeOfSpan(gates, spanOf(edges[2][k]));
        if (!(min <= greatest)) continue; // no data
        const cell = i + cells[0] * (j + cells[1] * k);
        low[cell] = min;
        high[cell] = greatest;
        // Between gates, radials and sweeps, the field may take any value of the cell.
        roughness[cell] = (greatest - min) / offLine;
      }
    }
  }
  return macrocells;
}

/** Where each macrocell begins and ends along an axis, metres. */
function cutEdge({ box, dimensions }: PolarGrid, axis: number, cells: number, size: number): [number, number][] {
  const cell = ((box.high[axis] - box.low[axis]) / dimensions[axis]) * size;
  return Array.from({ length: cells }, (_, i) => [
    box.low[axis] + (i - margin) * cell,
    Math.min(box.high[axis] + margin * cell, box.low[axis] + (i + 1 + margin) * cell),
  ]);
}

type Interval = readonly [number, number];

/** Smallest and largest distance of a rectangle's points from the antenna. */
function arcsOf(x: Interval, y: Interval): Interval {
  const nearest = ([from, to]: Interval): number => Math.max(0, from, -to);
  const farthest = ([from, to]: Interval): number => Math.max(-from, to);
  return [Math.hypot(nearest(x), nearest(y)), Math.hypot(farthest(x), farthest(y))];
}

/** The azimuths of a rectangle's points. If the antenna is outside, the corners have the extreme ones. */
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
  return { from: ((((toward + left) * degrees) % 360) + 360) % 360, width: (right - left) * degrees };
}

function rangeOfSpan({ spans, reaches, grid: { sweeps }, columns, onWork }: Gates, span: BeamSpan): [number, number] {
  const range: [number, number] = [Infinity, -Infinity];
  const [first, last] = sweepsAround(sweeps, spans, span.elevation);
  for (let i = first; i <= last; i++) {
    if (span.elevation[1] >= reaches[i][0] && span.elevation[0] <= reaches[i][1])
      columns[i].widen(range, span.range, onWork);
  }
  return range;
}

/**
 * One sweep in a column of cells. The cells lie in the same sector, and many need the same gates. Each gate is read once, in all radials of
 * the sector.
 */
class SweepInColumn {
  #sector: Sector = { from: 0, width: 0 };
  /**
   * Radials from the one at or before the sector to the one after it; indices go on beyond the seam. null if no cell has
   * asked for them yet.
   */
  #radials: readonly [first: number, last: number] | null = null;
  /** Gates that have been read, from the first to the last; none if the last is before the first. */
  #known: readonly [first: number, last: number] = [0, -1];
  /** The gates of the last request, and the range of their values: the cell above mostly requests the same. */
  #firstAsked = 0;
  #lastAsked = -1;
  #min = Infinity;
  #greatest = -Infinity;
  /** The smallest and the largest value of each gate over all radials of the sector. */
  readonly #low: Float64Array;
  readonly #high: Float64Array;
  readonly #minValid: number;
  /** For each radial, the first and the last gate with data: most of the air is empty. */
  readonly #begins: Int32Array;
  readonly #ends: Int32Array;

  constructor(
    readonly sweep: Sweep,
    readonly samples: Samples,
  ) {
    const { azimuths, gates, offset } = sweep;
    this.#low = new Float64Array(gates);
    this.#high = new Float64Array(gates);
    const minValid = (this.#minValid = samples instanceof Float32Array ? -Infinity : 1);
    const hasData = (at: number): boolean => samples[at] >= minValid;
    this.#begins = Int32Array.from(azimuths, (_, radial) => {
      let gate = 0;
      while (gate < gates && !hasData(offset + radial * gates + gate)) gate++;
      return gate;
    });
    this.#ends = Int32Array.from(azimuths, (_, radial) => {
      let gate = gates - 1;
      while (gate >= 0 && !hasData(offset + radial * gates + gate)) gate--;
      return gate;
    });
  }

  /** Starts with another column. */
  begin(sector: Sector): void {
    this.#sector = sector;
    this.#radials = null;
    this.#known = [0, -1];
    this.#lastAsked = -1;
  }

  /** Widens a range of values by those of all gates between two ranges (metres), and of the first gates around these. */
  widen(range: [number, number], metres: readonly [number, number], onWork: (gates: number) => void): void {
    const { firstGate, gateLength, gates } = this.sweep;
    const from = (metres[0] - firstGate) / gateLength;
    const to = (metres[1] - firstGate) / gateLength;
    if (to < -0.5 || from > gates - 0.5) return onWork(1);
    const first = Math.min(gates - 1, Math.max(0, Math.floor(from)));
    const last = Math.min(gates - 1, Math.floor(to) + 1);
    const radials = (this.#radials ??= this.#findRadials());
    onWork(workPerSweep + (radials[1] - radials[0] + 1) * (last - first + 1));
    if (first !== this.#firstAsked || last !== this.#lastAsked) this.#ask(first, last, radials);
    if (this.#min < range[0]) range[0] = this.#min;
    if (this.#greatest > range[1]) range[1] = this.#greatest;
  }

  #ask(first: number, last: number, radials: readonly [number, number]): void {
    this.#know(first, last, radials);
    const [lows, highs] = [this.#low, this.#high];
    let [low, high] = [Infinity, -Infinity];
    for (let gate = first; gate <= last; gate++) {
      if (lows[gate] < low) low = lows[gate];
      if (highs[gate] > high) high = highs[gate];
    }
    this.#firstAsked = first;
    this.#lastAsked = last;
    this.#min = low;
    this.#greatest = high;
  }

  #findRadials(): readonly [number, number] {
    const { azimuths } = this.sweep;
    const { from, width } = this.#sector;
    const radials = azimuths.length;
    if (width >= 360) return [0, radials - 1];
    const upTo = (azimuth: number): number => countUpTo(radials, (radial) => azimuths[radial] <= azimuth);
    const before = upTo(from) - 1;
    const to = from + width;
    return [before, Math.min(to < 360 ? upTo(to) : radials + upTo(to - 360), before + radials - 1)];
  }

  /** Reads gates, and those between them and the known ones. */
  #know(first: number, last: number, radials: readonly [number, number]): void {
    const [from, to] = this.#known;
    if (to < from) {
      this.#look(first, last, radials);
      this.#known = [first, last];
      return;
    }
    this.#look(first, from - 1, radials);
    this.#look(to + 1, last, radials);
    this.#known = [Math.min(first, from), Math.max(last, to)];
  }

  #look(first: number, last: number, [firstRadial, lastRadial]: readonly [number, number]): void {
    if (first > last) return;
    const {
      samples,
      sweep: {
        azimuths: { length: radials },
        gates,
        offset,
      },
    } = this;
    const [lows, highs, minValid] = [this.#low, this.#high, this.#minValid];
    lows.fill(Infinity, first, last + 1);
    highs.fill(-Infinity, first, last + 1);
    for (let radial = firstRadial; radial <= lastRadial; radial++) {
      const at = (radial + radials) % radials;
      const row = offset + at * gates;
      const end = Math.min(last, this.#ends[at]);
      for (let gate = Math.max(first, this.#begins[at]); gate <= end; gate++) {
        const value = samples[row + gate];
        // All comparisons are false for NaN.
        if (value < minValid) continue;
        if (value < lows[gate]) lows[gate] = value;
        if (value > highs[gate]) highs[gate] = value;
      }
    }
  }
}
