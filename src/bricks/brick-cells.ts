import { finestSpacing, offLine } from '../volume/grid.ts';
import { emptyMacrocells } from '../volume/macrocells.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { VolumeData } from '../volume/volume.ts';
import { blockSide, blocksAlong } from './block-ranges.ts';
import type { BlockRanges } from './block-ranges.ts';
import { brickSide } from './brick-data.ts';
import { cellOfPlace, gridOfLevel } from './brick-layout.ts';
import type { BrickLayout, LevelFrame } from './brick-layout.ts';
import type { Brick } from './pyramid.ts';

/** As many as a volume of 512³ voxels has. */
const maxCells = 2 ** 18;

/** What only touches a macrocell does not count, also where places are rounded; in macrocells. Blocks have a voxel more at each side. */
const rounding = 1e-4;

/** A brick with what its blocks have. */
export interface MeasuredBrick extends Brick {
  readonly blocks: BlockRanges;
}

/** @param last - is inside */
export type ShownBricks = (first: Vector3, last: Vector3, meet: (brick: MeasuredBrick | undefined) => void) => void;

/** The values of some places: stored units; roughness from one voxel of the finest level to the next, whose length is 1. */
interface Values {
  low: number;
  high: number;
  roughness: number;
  /** The length of the shortest voxel. */
  length: number;
}

/**
 * The macrocells of a volume with bricks over it: each has the values of what is shown there now. They are smaller than those of the volume alone, so that rays
 * skip as much as in a volume of the finest level.
 */
export class BrickCells {
  readonly macrocells: Macrocells;
  /** From one voxel of the finest level to the next. */
  readonly #roughness: Float32Array;
  /** Of the shortest voxel that is shown. */
  readonly #shortest: Float32Array;
  /** What the volume alone has. */
  readonly #own: Macrocells;
  /** The shortest edge of a voxel of each level, and of the volume: as a multiple of that of the finest level. Steps are counted by it, too. */
  readonly #lengths: readonly number[];
  readonly #length: number;
  /** Macrocells of which something has changed. */
  readonly #changed: Uint8Array;
  #first = 0;
  #sampled = 0;

  constructor(
    readonly volume: Pick<VolumeData, 'grid' | 'samples' | 'macrocells'>,
    readonly layout: BrickLayout,
  ) {
    const finest = finestSpacing(layout.finest);
    this.#lengths = layout.levels.map((level) => finestSpacing(gridOfLevel(volume.grid, level)) / finest);
    this.#length = finestSpacing(volume.grid) / finest;
    this.#own = measureVolume(volume, chooseSize(volume, layout.finest.dimensions));
    const { low, high, roughness } = this.#own;
    this.macrocells = {
      ...this.#own,
      low: low.slice(),
      high: high.slice(),
      roughness: roughness.slice(),
      longer: new Uint8Array(low.length),
    };
    this.#shortest = new Float32Array(low.length).fill(this.#length);
    this.#roughness = roughness.map((rough) => rough / this.#length);
    this.#changed = new Uint8Array(low.length);
    this.#first = low.length;
    this.#sampled = this.#length;
  }

  /** Other bricks may be shown in a box of the layout's cells. @param from, to - their numbers along each axis, without the last ones */
  change(from: Vector3, to: Vector3): void {
    const [first, last] = this.#cellsOf(from, to);
    const [cx, cy] = this.macrocells.dimensions;
    for (let k = first[2]; k <= last[2]; k++)
      for (let j = first[1]; j <= last[1]; j++) {
        const row = cx * (j + cy * k);
        this.#changed.fill(1, row + first[0], row + last[0] + 1);
        this.#first = Math.min(this.#first, row + first[0]);
      }
  }

  /**
   * @param shown - calls for each brick that a box of the layout's cells shows, once or more often; with undefined where it is the volume itself
   * @param level - the finest level of which there are bricks; -1 for none
   * @returns whether any macrocell has changed
   */
  update(shown: ShownBricks, level: number): boolean {
    const { dimensions, low, high, roughness, longer } = this.macrocells;
    const sampled = this.#lengths[level] ?? this.#length;
    const isFiner = sampled !== this.#sampled;
    if (!isFiner && this.#first >= low.length) return false;
    let changes = false;
    for (let at = isFiner ? 0 : this.#first; at < low.length; at++) {
      const values = this.#changed[at] === 1 ? this.#valuesOf(at, dimensions, shown) : null;
      if (!values && !isFiner) continue;
      const before = [low[at], high[at], roughness[at], longer![at]];
      if (values)
        [low[at], high[at], this.#roughness[at], this.#shortest[at]] = [
          values.low,
          values.high,
          values.roughness,
          values.length,
        ];
      const all = (high[at] - low[at]) / offLine;
      roughness[at] = all > 0 ? Math.min(all, sampled * this.#roughness[at]) : 0;
      longer![at] = powerWithin(this.#shortest[at] / sampled);
      const now = [low[at], high[at], roughness[at], longer![at]];
      changes ||= now.some((value, n) => value !== before[n]);
    }
    this.#changed.fill(0);
    this.#first = low.length;
    this.#sampled = sampled;
    return changes;
  }

  /** The box of a macrocell, in the unit cube. */
  #boxOf(at: number, [cx, cy]: Vector3): readonly [Vector3, Vector3] {
    const cell = [at % cx, Math.floor(at / cx) % cy, Math.floor(at / (cx * cy))];
    const { dimensions } = this.volume.grid;
    const edge = (n: number, axis: number): number => Math.min(1, (n * this.macrocells.size) / dimensions[axis]);
    return [
      cell.map((n, axis) => edge(n + rounding, axis)),
      cell.map((n, axis) => edge(n + 1 - rounding, axis)),
    ] as unknown as [Vector3, Vector3];
  }

  #valuesOf(at: number, cells: Vector3, shown: ShownBricks): Values {
    const [low, high] = this.#boxOf(at, cells);
    const first = cellOfPlace(this.layout, low);
    const last = cellOfPlace(this.layout, high);
    const found: Values = { low: Infinity, high: -Infinity, roughness: 0, length: Infinity };
    const seen = new Set<MeasuredBrick | undefined>();
    shown(first, last, (brick) => {
      if (seen.has(brick)) return;
      seen.add(brick);
      if (brick) this.#addBlocks(found, brick, [low, high]);
      else this.#addOwn(found, at);
    });
    // Stored values of whole numbers can not say that there are none.
    return found.low <= found.high
      ? found
      : { low: this.#own.low[at], high: this.#own.high[at], roughness: 0, length: found.length };
  }

  #addOwn(found: Values, at: number): void {
    const { low, high, roughness } = this.#own;
    found.length = Math.min(found.length, this.#length);
    add(found, low[at], high[at], roughness[at] / this.#length);
  }

  #addBlocks(found: Values, brick: MeasuredBrick, box: readonly [Vector3, Vector3]): void {
    const { low, high, roughness } = brick.blocks;
    found.length = Math.min(found.length, this.#lengths[brick.level]);
    const frame = this.layout.levels[brick.level];
    const [first, last] = box.map((place) => place.map((x, axis) => clampBlock(blockAt(frame, brick.at, axis, x))));
    for (let k = first[2]; k <= last[2]; k++)
      for (let j = first[1]; j <= last[1]; j++)
        for (let i = first[0]; i <= last[0]; i++) {
          const block = i + blocksAlong * (j + blocksAlong * k);
          add(found, low[block], high[block], roughness[block] / this.#lengths[brick.level]);
        }
  }

  /** The macrocells that a box of the layout's cells touches: the first and the last along each axis. */
  #cellsOf(from: Vector3, to: Vector3): readonly [Vector3, Vector3] {
    const { dimensions, size } = this.macrocells;
    const {
      cells,
      levels: [{ scale, shift }],
    } = this.layout;
    const voxels = this.volume.grid.dimensions;
    const cellAt = (cell: number, axis: number): number => {
      // Outside of the finest level, the outermost cells are shown.
      if (cell <= 0) return 0;
      if (cell >= cells[axis]) return dimensions[axis] - 1;
      const place = (cell * brickSide - shift[axis]) / scale[axis];
      return Math.floor((place * voxels[axis]) / size);
    };
    const inside = (n: number, axis: number): number => Math.min(dimensions[axis] - 1, Math.max(0, n));
    return [
      from.map((n, axis) => inside(cellAt(n, axis) - 1, axis)),
      to.map((n, axis) => inside(cellAt(n, axis) + 1, axis)),
    ] as unknown as [Vector3, Vector3];
  }
}

/** The smallest size for which there are not too many cells; smaller than those of the volume only while they are no smaller than a block of a brick. */
function chooseSize({ grid: { dimensions }, macrocells }: BrickCells['volume'], finest: Vector3): number {
  const voxels = Math.min(...dimensions.map((n, axis) => finest[axis] / n));
  let { size } = macrocells;
  const count = (edge: number): number => dimensions.reduce((product, n) => product * Math.ceil(n / edge), 1);
  while ((size / 2) * voxels >= blockSide && count(size / 2) <= maxCells) size /= 2;
  return size;
}

/** The largest power of two that is not above a ratio, rounding aside: as many as a byte of a cell's code has room for. */
const powerWithin = (ratio: number): number => Math.min(15, Math.max(0, Math.floor(Math.log2(ratio) + 0.01)));

const blockAt = ({ scale, shift }: LevelFrame, at: Vector3, axis: number, x: number): number =>
  (x * scale[axis] + shift[axis] - brickSide * at[axis]) / blockSide;

const clampBlock = (at: number): number => Math.min(blocksAlong - 1, Math.max(0, Math.floor(at)));

function add(found: Values, low: number, high: number, roughness: number): void {
  if (!(low <= high)) return;
  found.low = Math.min(found.low, low);
  found.high = Math.max(found.high, high);
  found.roughness = Math.max(found.roughness, roughness);
}

/** Macrocells of a volume of any size. The roughness is that of the larger cell in which one lies. */
function measureVolume({ grid, samples, macrocells }: BrickCells['volume'], size: number): Macrocells {
  if (size === macrocells.size) return macrocells;
  const voxels = grid.dimensions;
  const cells = emptyMacrocells(samples, voxels, size);
  const { dimensions, low, high, roughness } = cells;
  /** The first and the last voxel that interpolation in a cell reads. */
  const ends = dimensions.map((count, axis) =>
    Array.from({ length: count }, (_, n) => [
      Math.max(0, Math.floor(n * size - 0.5)),
      Math.min(voxels[axis] - 1, Math.ceil((n + 1) * size - 0.5)),
    ]),
  );
  const large = (n: number): number => Math.floor((n * size) / macrocells.size);
  const [lx, ly] = macrocells.dimensions;
  for (let z = 0, at = 0; z < dimensions[2]; z++)
    for (let y = 0; y < dimensions[1]; y++)
      for (let x = 0; x < dimensions[0]; x++, at++) {
        const [[i0, i1], [j0, j1], [k0, k1]] = [ends[0][x], ends[1][y], ends[2][z]];
        let [min, max] = [low[at], high[at]];
        for (let k = k0; k <= k1; k++)
          for (let j = j0; j <= j1; j++)
            for (let i = i0, voxel = i0 + voxels[0] * (j + voxels[1] * k); i <= i1; i++, voxel++) {
              const value = samples[voxel];
              if (value < min) min = value;
              if (value > max) max = value;
            }
        low[at] = min;
        high[at] = max;
        const whole = macrocells.roughness[large(x) + lx * (large(y) + ly * large(z))];
        roughness[at] = max > min ? Math.min(whole, (max - min) / offLine) : 0;
      }
  return cells;
}
