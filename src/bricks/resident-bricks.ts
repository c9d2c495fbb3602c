import { interpolate } from '../optics/rays/interpolate.ts';
import type { BrickedValues, FinerVoxels, PlaneVoxels } from '../volume/finer-voxels.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';
import type { VolumeData } from '../volume/volume.ts';
import { BrickCells } from './brick-cells.ts';
import type { MeasuredBrick } from './brick-cells.ts';
import { brickSide } from './brick-data.ts';
import type { BrickSamples } from './brick-data.ts';
import {
  brickHalo,
  brickOfCell,
  cellOfPlace,
  cellsOfBrick,
  gridOfLevel,
  placeOfCell,
  shapeAtlas,
  slotDimensions,
  slotSide,
} from './brick-layout.ts';
import type { AtlasShape, BrickLayout } from './brick-layout.ts';
import type { Brick } from './pyramid.ts';

/** A brick that rays can read, and the slot that it has. */
export interface ResidentBrick extends MeasuredBrick, Omit<BrickSamples, 'hasNoData'> {
  readonly slot: number;
}

export function keyOfBrick({ level, at: [i, j, k] }: Brick): string {
  return `${level}/${i}/${j}/${k}`;
}

/**
 * Bricks of finer levels over a volume, as rays in float64 read them. Each cell (brick of the finest level) shows the finest brick that is
 * there. Twin: shaders/chunks/field/bricks-3d.glsl
 */
export class ResidentBricks implements FinerVoxels {
  /** By cell, i fastest: the slot of its brick in three bytes, low byte first; and 1 + the brick's level, or 0 where it has none. */
  readonly pages: Uint8Array<ArrayBuffer>;
  /** Counts changes of `pages`, and of `macrocells` as far as `current` has seen them. */
  readonly changes = { pages: 0, cells: 0 };
  /** Whether the present view gets more of them. */
  moving = false;
  error: FinerVoxels['error'] = null;
  /** Where the volume and its bricks lie in a texture. */
  atlas: AtlasShape;
  /** Of all textures: what uploads them says it. */
  bytesOnGpu = 0;
  /** Bricks that were read for planes and picks. */
  planes: (PlaneVoxels & { samplesOf(brick: Brick): Samples | undefined }) | null = null;
  /** Slots that there may be, and slots for which the GPU has memory. */
  capacity = Infinity;
  maxSlots = Infinity;
  #current: { readonly volume: object; readonly cells: number; readonly now: object } | null = null;
  readonly #bricks = new Map<string, ResidentBrick>();
  readonly #bySlot: (ResidentBrick | undefined)[] = [];
  readonly #free: number[] = [];
  readonly #counts: number[];
  readonly #cells: BrickCells;
  /** Smallest and largest stored value of all bricks that came: fewer of them when they go would change the tables of colours. */
  #low = Infinity;
  #high = -Infinity;

  /**
   * @param volume - over which the bricks lie: it is the level that is always there
   * @param upload - see `FinerVoxels`
   */
  constructor(
    readonly volume: Pick<VolumeData, 'grid' | 'samples' | 'macrocells'>,
    readonly layout: BrickLayout,
    readonly upload: FinerVoxels['upload'],
  ) {
    const [cx, cy, cz] = layout.cells;
    this.atlas = shapeAtlas(volume.grid.dimensions);
    this.pages = new Uint8Array(4 * cx * cy * cz);
    this.#cells = new BrickCells(volume, layout);
    this.#counts = layout.levels.map(() => 0);
  }

  get finest(): GridFrame {
    return this.layout.finest;
  }

  /** Of what is shown now, once `current` has been called. */
  get macrocells(): Macrocells {
    return this.#cells.macrocells;
  }

  /** The finest level of which there are bricks; -1 for none. */
  get #level(): number {
    return this.#counts.findIndex((count) => count > 0);
  }

  get grid(): GridFrame {
    const level = this.#level;
    return level < 0 ? this.volume.grid : gridOfLevel(this.volume.grid, this.layout.levels[level]);
  }

  current<V extends BrickedValues>(volume: V): V {
    if (this.#cells.update((cell) => this.#bySlot[this.slotOf(cell)], this.#level)) this.changes.cells++;
    const { cells } = this.changes;
    if (this.#current?.volume !== volume || this.#current.cells !== cells)
      this.#current = {
        volume,
        cells,
        now: { ...volume, macrocells: this.macrocells, range: this.#widenRange(volume) },
      };
    return this.#current.now as V;
  }

  #widenRange({ range, slope, intercept }: BrickedValues): BrickedValues['range'] {
    const all = [...range];
    if (this.#low <= this.#high) all.push(slope * this.#low + intercept, slope * this.#high + intercept);
    return [Math.min(...all), Math.max(...all)];
  }

  /** All bricks, in the order in which they came. */
  get bricks(): IterableIterator<ResidentBrick> {
    return this.#bricks.values();
  }

  get count(): number {
    return this.#bricks.size;
  }

  /** Of the GPU, with its halo. */
  get bytesOfBrick(): number {
    return slotSide ** 3 * this.volume.samples.BYTES_PER_ELEMENT;
  }

  get held(): FinerVoxels['held'] {
    return { count: this.count, bytes: this.bytesOnGpu };
  }

  /** Slots that were ever used: the others need no memory. */
  get slots(): number {
    return this.#bySlot.length;
  }

  get(place: Brick): ResidentBrick | undefined {
    return this.#bricks.get(keyOfBrick(place));
  }

  inSlot(slot: number): ResidentBrick | undefined {
    return this.#bySlot[slot];
  }

  add(place: Brick, values: Omit<BrickSamples, 'hasNoData'>): ResidentBrick {
    const known = this.get(place);
    if (known) return known;
    const slot = this.#free.pop() ?? this.#bySlot.length;
    const { level, at } = place;
    const brick: ResidentBrick = { level, at, ...values, slot };
    this.#bricks.set(keyOfBrick(brick), brick);
    this.#bySlot[slot] = brick;
    this.#counts[level]++;
    this.#visitCells(brick, (cell) => {
      const shown = this.pages[4 * cell + 3];
      if (shown === 0 || shown - 1 > level) this.#show(cell, brick);
    });
    this.changes.pages++;
    this.#widen(brick);
    return brick;
  }

  remove(place: Brick): void {
    const brick = this.get(place);
    if (!brick) return;
    this.#bricks.delete(keyOfBrick(brick));
    this.#bySlot[brick.slot] = undefined;
    this.#free.push(brick.slot);
    this.#counts[brick.level]--;
    this.#visitCells(brick, (cell, at) => {
      if (this.pages[4 * cell + 3] === brick.level + 1) this.#show(cell, this.#coarser(at, brick.level));
    });
    this.changes.pages++;
  }

  /** From now on there are at most so many slots, and bricks: the last ones that came go, and those in other slots get another one. */
  fit(capacity: number): void {
    this.capacity = capacity;
    if (this.slots <= capacity) return;
    for (const brick of [...this.bricks].slice(capacity)) this.remove(brick);
    const moved = this.#bySlot.slice(capacity).filter((brick) => brick !== undefined);
    for (const brick of moved) this.remove(brick);
    this.#bySlot.length = capacity;
    this.#free.length = 0;
    for (let slot = 0; slot < capacity; slot++) if (!this.#bySlot[slot]) this.#free.push(slot);
    for (const brick of moved) this.add(brick, brick);
  }

  /** The level of a cell's brick; the number of levels where the volume itself is shown. */
  levelOf(cell: number): number {
    return (this.pages[4 * cell + 3] || this.layout.levels.length + 1) - 1;
  }

  /** The level that a cell would have if the brick that it shows were not there. */
  levelWithout(cell: number): number {
    return this.#coarser(placeOfCell(this.layout, cell), this.levelOf(cell))?.level ?? this.layout.levels.length;
  }

  /** The slot of the brick that a cell shows; -1 where it has none. */
  slotOf(cell: number): number {
    const { pages } = this;
    const page = 4 * cell;
    return pages[page + 3] === 0 ? -1 : pages[page] + 256 * pages[page + 1] + 65536 * pages[page + 2];
  }

  storedAt(place: Vector3): number {
    const inside = this.#inFinest(place);
    const brick = this.#brickAt(inside);
    if (brick) return this.storedIn(brick, inside);
    return interpolate(this.volume.samples, this.volume.grid.dimensions, inside);
  }

  /** The stored value in a brick, which need not be one of these. */
  storedIn(brick: Brick & Pick<BrickSamples, 'samples'>, place: Vector3): number {
    return interpolate(brick.samples, slotDimensions, this.#placeIn(brick, this.#inFinest(place)));
  }

  /** The place itself, or where the volume reaches beyond the finest level, the nearest one in that. */
  #inFinest(place: Vector3): Vector3 {
    const { scale, shift, dimensions } = this.layout.levels[0];
    return place.map((x, axis) =>
      Math.min((dimensions[axis] - shift[axis]) / scale[axis], Math.max(-shift[axis] / scale[axis], x)),
    ) as unknown as Vector3;
  }

  nearestAt(place: Vector3): number | undefined {
    const cell = cellOfPlace(this.layout, place);
    for (const [level, frame] of this.layout.levels.entries()) {
      const brick = { level, at: brickOfCell(frame, cell) };
      const samples = this.get(brick)?.samples ?? this.planes?.samplesOf(brick);
      if (!samples) continue;
      const [i, j, k] = this.#placeIn(brick, place).map((x) => Math.min(slotSide - 1, Math.floor(x * slotSide)));
      return samples[i + slotSide * (j + slotSide * k)];
    }
    return undefined;
  }

  /** A place in the unit cube of a brick's slot. Beyond the outermost voxels' centres values stay as they are there. */
  #placeIn({ level, at }: Brick, place: Vector3): Vector3 {
    const { scale, shift, dimensions } = this.layout.levels[level];
    return place.map((x, axis) => {
      const voxel = Math.min(Math.max(x * scale[axis] + shift[axis], 0.5), dimensions[axis] - 0.5);
      return (voxel - brickSide * at[axis] + brickHalo) / slotSide;
    }) as unknown as Vector3;
  }

  voxelAt(place: Vector3): Vector3 {
    const brick = this.#brickAt(place);
    const voxels = brick ? this.layout.levels[brick.level].scale : this.volume.grid.dimensions;
    return voxels.map((n) => 1 / n) as unknown as Vector3;
  }

  /** The number of the cell at a place of the unit cube. */
  cellAt(place: Vector3): number {
    const [cx, cy] = this.layout.cells;
    const [i, j, k] = cellOfPlace(this.layout, place);
    return i + cx * (j + cy * k);
  }

  #brickAt(place: Vector3): ResidentBrick | undefined {
    return this.#bySlot[this.slotOf(this.cellAt(place))];
  }

  #show(cell: number, brick: ResidentBrick | undefined): void {
    const slot = brick?.slot ?? 0;
    this.pages.set([slot & 255, (slot >> 8) & 255, slot >> 16, brick ? brick.level + 1 : 0], 4 * cell);
  }

  /** The finest brick of the levels beyond one that covers a cell. */
  #coarser(cell: Vector3, level: number): ResidentBrick | undefined {
    const { levels } = this.layout;
    for (let next = level + 1; next < levels.length; next++) {
      if (this.#counts[next] === 0) continue;
      const found = this.get({ level: next, at: brickOfCell(levels[next], cell) });
      if (found) return found;
    }
    return undefined;
  }

  /** The cells of a brick that comes or goes. */
  #visitCells({ level, at }: Brick, visit: (cell: number, at: Vector3) => void): void {
    const { cells } = this.layout;
    const [low, high] = cellsOfBrick(this.layout, level, at);
    this.#cells.change(low, high);
    for (let k = low[2]; k < high[2]; k++)
      for (let j = low[1]; j < high[1]; j++)
        for (let i = low[0]; i < high[0]; i++) visit(i + cells[0] * (j + cells[1] * k), [i, j, k]);
  }

  #widen({ low, high }: ResidentBrick): void {
    if (!(low <= high)) return;
    [this.#low, this.#high] = [Math.min(this.#low, low), Math.max(this.#high, high)];
  }
}
