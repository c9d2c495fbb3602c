// What bricks over a volume hide, learnt from those that have come.
import { interpolate } from '../optics/rays/interpolate.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';
import type { VolumeData } from '../volume/volume.ts';
import { brickHalo, brickSide, slotSide } from './brick-data.ts';
import type { BrickSamples } from './brick-data.ts';
import { brickAround, slotDimensions } from './brick-layout.ts';
import type { DetailField } from './detail-field.ts';
import { alongOfNoise, hiddenUnderBricks, holdsBrick, voxelsTogether } from './hidden-values.ts';
import type { HiddenValues } from './hidden-values.ts';
import { MeasuredDetail, partAt, partsAlong } from './measured-detail.ts';
import type { Brick } from './pyramid.ts';
import { keyOfBrick } from './resident-bricks.ts';
import type { ResidentBricks } from './resident-bricks.ts';
import { betweenVoxels } from './residuals.ts';
import type { ResidualTable } from './residuals.ts';

interface Probe extends Brick {
  readonly samples: Samples;
}

/** Probes that are kept at most: a view that never rests asks for more and more of them. */
const mostProbes = 64;

/** Voxels from one place that is measured to the next, along each axis. */
const stride = 3;

/** Between the middles of the outermost voxels, a brick alone says the values. */
const [firstMiddle, lastMiddle] = [brickHalo + 0.5, brickHalo + brickSide - 0.5];

/**
 * The roughness of a macrocell is its largest second difference: so much of it is the root mean square of what a level of half the voxels hides of
 * noise, and so much the largest.
 */
const [rmsOfRoughness, maxOfRoughness] = [0.13, 0.4];

/** Residuals that are one voxel of their level apart go together so far at most. Where none was measured they are taken for noise. */
const mostAlong = 0.8;

/**
 * So much is left between voxels of what a writer says of these, as a root mean square: of noise, which interpolated along each axis has two thirds of its
 * variance; and where it is not known whether it is noise.
 */
const [ofNoise, ofUnknown] = [(2 / 3) ** 1.5, 0.85];

/** A part of a brick is taken to have so many places more at which it is as rough as the whole. */
const leastOfPart = 4;

/** An octave has at least this share and at most so many times the detail of the next coarser one. */
const limits = [0.25, 8] as const;

/** The largest residual of a block is at least so many times its root mean square; more where bricks of its level have had more. */
const leastPeak = 2;

/**
 * What the levels of a pyramid hide: what its writer has said; or where that is not known, each octave that is not known of a place has so many times the detail of
 * the next coarser one as the same octave has elsewhere, as in `learnDetail`, for bricks that come and go.
 */
export class ResidentDetail implements HiddenValues, DetailField {
  readonly levels: number;
  /** Voxels of each level along each axis of the unit cube, finest first. */
  readonly voxels: readonly Vector3[];
  readonly #measured: MeasuredDetail;
  readonly #probes = new Map<string, Probe>();
  /** Sums of squares, by level. */
  readonly #fine: Float64Array;
  readonly #coarse: Float64Array;
  /** By level: sums of products of residuals that are one of its voxels apart, and of their squares. */
  readonly #pairs: Float64Array;
  readonly #squares: Float64Array;
  /** By level: over how many voxels of level 0 its residuals go together. */
  readonly #correlation: Float64Array;
  /** By level: how much of the residuals at voxels is left between them, where rays sample. */
  readonly #between: Float64Array;
  /** By level: the largest residual that was measured, in root mean squares of its brick. */
  readonly #peaks: Float64Array;
  /** By level, where no brick was measured: what it hides, in roughnesses of the volume. */
  readonly #usualRms: Float64Array;
  readonly #usualMax: Float64Array;
  readonly #range: [low: number, high: number] = [Infinity, -Infinity];
  #table: ResidualTable | null = null;
  /** By level, where the writer has said it: how far its residuals go together. */
  #written: readonly (number | undefined)[] = [];
  #byTable: HiddenValues | null = null;

  constructor(
    readonly volume: Pick<VolumeData, 'grid' | 'samples' | 'macrocells'>,
    readonly bricks: ResidentBricks,
  ) {
    this.levels = bricks.layout.levels.length + 1;
    this.voxels = [...bricks.layout.levels.map(({ scale }) => scale), volume.grid.dimensions];
    this.#fine = new Float64Array(this.levels);
    this.#coarse = new Float64Array(this.levels);
    this.#pairs = new Float64Array(this.levels);
    this.#squares = new Float64Array(this.levels);
    this.#correlation = new Float64Array(this.levels);
    this.#between = new Float64Array(this.levels);
    this.#measured = new MeasuredDetail(bricks.layout);
    this.#usualRms = new Float64Array(this.levels);
    this.#usualMax = new Float64Array(this.levels);
    this.#peaks = new Float64Array(this.levels).fill(leastPeak);
    const { low, high } = volume.macrocells;
    for (let n = 0; n < low.length; n++) this.#meet(low[n], high[n]);
  }

  /** Smallest and largest stored value that was seen. */
  get range(): readonly [number, number] {
    return this.#range;
  }

  /** Takes what the writer has said, until a brick has other values. @param levels - see `hiddenUnderBricks` */
  take(table: ResidualTable, levels: readonly number[]): void {
    this.#table = table;
    this.#written = levels.slice(1).map((level) => table.along?.[level]);
    this.#byTable = hiddenUnderBricks(table, this.bricks.layout, levels);
    for (let block = 0; block < table.low.length; block++) this.#meet(table.low[block], table.high[block]);
    for (const brick of this.bricks.bricks) this.#compare(brick, brick);
  }

  /** Whether a brick was there once, or its values are known without it. */
  isMeasured(brick: Brick): boolean {
    return this.#byTable !== null || this.#measured.has(brick);
  }

  #compare(brick: Brick, values: Pick<BrickSamples, 'low' | 'high'>): void {
    if (this.#table && !holdsBrick(this.#table, this.bricks.layout, brick, values))
      [this.#table, this.#byTable, this.#written] = [null, null, []];
  }

  /** Looks at a brick before it is shown. @param isProbe - it will not be: finer probes inside it are compared with it, until `forgetProbes` */
  measure(brick: Brick, { samples, low, high }: BrickSamples, isProbe = false): void {
    this.#meet(low, high);
    this.#compare(brick, { low, high });
    if (isProbe) this.#keepProbe({ ...brick, samples });
    if (this.#measured.has(brick)) return;
    const probe = this.#probeAround(brick);
    const { scale, shift, dimensions } = this.bricks.layout.levels[brick.level];
    let [squares, max, before, count, steps] = [0, 0, 0, 0, 1];
    let [shownLow, shownHigh] = [Infinity, -Infinity];
    let [pairs, squaresOfPairs] = [0, 0];
    const parts = new Float64Array(partsAlong ** 3);
    const counts = new Float64Array(partsAlong ** 3);
    const valueAt = (at: Vector3): number =>
      interpolate(samples, slotDimensions, at.map((n) => n / slotSide) as unknown as Vector3);
    /** Null beyond the level. */
    const placeOf = (at: Vector3): Vector3 | null => {
      const voxel = at.map((n, axis) => brick.at[axis] * brickSide + n - brickHalo);
      if (voxel.some((n, axis) => n > dimensions[axis])) return null;
      return voxel.map((n, axis) => (n - shift[axis]) / scale[axis]) as unknown as Vector3;
    };
    const end = brickHalo + brickSide;
    for (let k = brickHalo, number = 0; k < end; k += stride)
      for (let j = brickHalo; j < end; j += stride)
        for (let i = brickHalo; i < end; i += stride, number++) {
          // Rays sample between voxels, too, where values differ less than at these.
          const inSlot = [i, j, k].map((n, axis) =>
            Math.max(firstMiddle, n + ((number * betweenVoxels[axis]) % 1)),
          ) as unknown as Vector3;
          const value = valueAt(inSlot);
          const place = placeOf(inSlot);
          if (Number.isNaN(value) || !place) continue;
          const shownBy = this.#shownAt(...(place as [number, number, number]));
          const isFiner = probe !== null && probe.level < this.#levelOf(shownBy);
          const shownAt = (at: Vector3): number =>
            isFiner ? this.bricks.storedIn(probe, at) : this.bricks.storedAt(at);
          const shown = shownAt(place);
          if (Number.isNaN(shown)) continue;
          count++;
          const next = inSlot.map((n, axis) =>
            axis !== number % 3 ? n : n + 1 <= lastMiddle ? n + 1 : n - 1,
          ) as unknown as Vector3;
          const nextPlace = placeOf(next);
          const there = nextPlace ? valueAt(next) - shownAt(nextPlace) : NaN;
          if (!Number.isNaN(there)) {
            pairs += (value - shown) * there;
            squaresOfPairs += ((value - shown) ** 2 + there ** 2) / 2;
          }
          squares += (value - shown) ** 2;
          const part = partAt(inSlot.map((n) => (n - brickHalo) / brickSide));
          parts[part] += (value - shown) ** 2;
          counts[part]++;
          max = Math.max(max, Math.abs(value - shown));
          [shownLow, shownHigh] = [Math.min(shownLow, shown), Math.max(shownHigh, shown)];
          before += (isFiner ? this.#measured.of(probe)!.rms : this.#rmsAt(shownBy)) ** 2;
          steps = Math.max(1, (isFiner ? probe.level : this.#levelOf(shownBy)) - brick.level);
        }
    // A single voxel is between the places; that it is there, the brick says.
    if (count > 0) max = Math.max(max, high - shownHigh, shownLow - low);
    // Several octaves have the same detail each, as far as is known.
    const rms = Math.sqrt(squares / Math.max(1, count * steps));
    if (rms > 0) this.#peaks[brick.level] = Math.max(this.#peaks[brick.level], max / (rms * Math.sqrt(steps)));
    const mean = squares / Math.max(1, count);
    const shares = Float32Array.from(parts, (sum, part) =>
      mean > 0 ? Math.sqrt((sum / mean + leastOfPart) / (counts[part] + leastOfPart)) : 1,
    );
    this.#measured.add({ brick, octaves: steps, rms, max, parts: shares });
    this.#fine[brick.level] += rms ** 2 * count;
    this.#coarse[brick.level] += before;
    this.#pairs[brick.level] += pairs;
    this.#squares[brick.level] += squaresOfPairs;
  }

  #keepProbe(probe: Probe): void {
    this.#probes.set(keyOfBrick(probe), probe);
    for (const oldest of this.#probes.keys()) {
      if (this.#probes.size <= mostProbes) break;
      this.#probes.delete(oldest);
    }
  }

  /** The next coarser probe that covers a brick. */
  #probeAround(brick: Brick): Probe | null {
    const { layout } = this.bricks;
    for (let coarser = brick.level + 1; coarser < layout.levels.length; coarser++) {
      const found = this.#probes.get(keyOfBrick(brickAround(layout, brick, coarser)));
      if (found) return found;
    }
    return null;
  }

  forgetProbes(): void {
    this.#probes.clear();
  }

  /** How many probes are kept. */
  get probes(): number {
    return this.#probes.size;
  }

  /** Bricks have come or gone. */
  update(): void {
    const { levels } = this;
    const growth = new Float64Array(levels);
    for (let level = levels - 2; level >= 0; level--) {
      const [fine, coarse] = [this.#fine[level], this.#coarse[level]];
      const next = level + 2 < levels ? growth[level + 1] : 1;
      growth[level] = coarse > 0 ? Math.min(limits[1], Math.max(limits[0], Math.sqrt(fine / coarse))) : next;
    }
    for (let level = 0; level < levels - 1; level++) {
      const measured = this.#squares[level] > 0 ? this.#pairs[level] / this.#squares[level] : this.#written[level];
      const along = Math.min(mostAlong, Math.max(0, measured ?? alongOfNoise));
      this.#correlation[level + 1] = 2 ** level * voxelsTogether(along);
      const smooth = Math.max(0, (along - alongOfNoise) / (1 - alongOfNoise));
      this.#between[level + 1] = measured === undefined ? ofUnknown : ofNoise + (1 - ofNoise) * smooth;
    }
    this.#measured.update(growth, this.#peaks);
    let [squares, peak] = [0, maxOfRoughness / rmsOfRoughness];
    for (let level = 1; level < levels; level++) {
      const times = growth.subarray(level - 1, levels - 1).reduce((all, one) => all * one, 1);
      squares += (rmsOfRoughness * times) ** 2;
      peak = Math.max(peak, this.#peaks[level - 1]);
      this.#usualRms[level] = Math.sqrt(squares);
      this.#usualMax[level] = peak * Math.sqrt(squares);
    }
  }

  /** A block of the writer's table; without one, a block of what was measured; or, below 0, a macrocell of the volume. */
  blockAt(x: number, y: number, z: number): number {
    if (this.#byTable) return this.#byTable.blockAt(x, y, z);
    const measured = this.#measured.blockAt([x, y, z]);
    return measured < 0 ? this.#macrocellAt(x, y, z) : measured;
  }

  /** The slot of the brick that is shown; or, below 0, a macrocell of the volume. */
  #shownAt(x: number, y: number, z: number): number {
    const slot = this.bricks.slotAt([x, y, z]);
    return slot < 0 ? this.#macrocellAt(x, y, z) : slot;
  }

  #macrocellAt(x: number, y: number, z: number): number {
    const {
      grid: { dimensions },
      macrocells: {
        dimensions: [cx, cy, cz],
        size,
      },
    } = this.volume;
    const index = (place: number, axis: number, count: number): number =>
      Math.min(count - 1, Math.max(0, Math.floor((place * dimensions[axis]) / size)));
    return -1 - (index(x, 0, cx) + cx * (index(y, 1, cy) + cy * index(z, 2, cz)));
  }

  rms(block: number, level: number): number {
    if (this.#byTable) return this.#between[level] * this.#byTable.rms(block, level);
    if (block >= 0) return this.#measured.rms(block, level);
    return this.#usualRms[level] * this.#roughness(block);
  }

  max(block: number, level: number): number {
    if (this.#byTable) return this.#byTable.max(block, level);
    if (block >= 0) return this.#measured.max(block, level);
    return this.#usualMax[level] * this.#roughness(block);
  }

  correlation(level: number): number {
    return this.#correlation[level];
  }

  low(block: number): number {
    return this.#byTable ? this.#byTable.low(block) : this.#range[0];
  }

  high(block: number): number {
    return this.#byTable ? this.#byTable.high(block) : this.#range[1];
  }

  valueAt(x: number, y: number, z: number): number {
    return this.bricks.storedAt([x, y, z]);
  }

  voxelAt(x: number, y: number, z: number): Vector3 {
    return this.bricks.voxelAt([x, y, z]);
  }

  cellAt(x: number, y: number, z: number): number {
    return this.bricks.cellAt([x, y, z]);
  }

  levelOf(cell: number): number {
    return this.bricks.levelOf(cell);
  }

  levelWithout(cell: number): number {
    return this.bricks.levelWithout(cell);
  }

  /** Of the octave that what is shown has beyond the next coarser level. */
  #rmsAt(shown: number): number {
    if (shown < 0) return rmsOfRoughness * this.#roughness(shown);
    return this.#measured.of(this.bricks.inSlot(shown)!)?.rms ?? 0;
  }

  #levelOf(shown: number): number {
    return shown < 0 ? this.levels - 1 : this.bricks.inSlot(shown)!.level;
  }

  #roughness(macrocell: number): number {
    return this.volume.macrocells.roughness[-1 - macrocell];
  }

  #meet(low: number, high: number): void {
    if (!(low <= high)) return;
    this.#range[0] = Math.min(this.#range[0], low);
    this.#range[1] = Math.max(this.#range[1], high);
  }
}
