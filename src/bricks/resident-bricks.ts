import type { Waiting } from '../core/waiting.ts';
import { interpolate } from '../optics/rays/interpolate.ts';
import type { BrickedValues, FinerVoxels, PlaneVoxels } from '../volume/finer-voxels.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';
import type { VolumeData } from '../volume/volume.ts';
import { measureBlocks } from './block-ranges.ts';
import { BrickCells } from './brick-cells.ts';
import type { MeasuredBrick, ShownBricks } from './brick-cells.ts';
import { brickHalo, brickSide, lacksData, slotSide } from './brick-data.ts';
import type { BrickSamples } from './brick-data.ts';
import { fillHalo, neighbourOf, waysToNeighbours } from './brick-halos.ts';
import { findKinks } from './brick-kinks.ts';
import {
  brickOfCell,
  cellOfPlace,
  cellsOfBrick,
  gridOfLevel,
  placeOfCell,
  shapeAtlas,
  slotDimensions,
  touches,
} from './brick-layout.ts';
import type { AtlasShape, BrickLayout, CellBox } from './brick-layout.ts';
import { CellNumbers } from './cell-numbers.ts';
import type { NextNumber } from './cell-numbers.ts';
import type { Brick } from './pyramid.ts';

/** A brick that rays can read, and the slot that it has. It becomes another object when its halo changes. */
export interface ResidentBrick extends MeasuredBrick, BrickSamples {
  readonly slot: number;
}

export function keyOfBrick({ level, at: [i, j, k] }: Brick): string {
  return `${level}/${i}/${j}/${k}`;
}

/** Where what is shown has changed, for bricks of finer levels than this one. */
interface ChangedBox {
  readonly box: CellBox;
  readonly level: number;
}

/**
 * Bricks of finer levels over a volume, as rays in float64 read them. Each cell (brick of the finest level) shows the finest brick that is
 * there. Bricks need no voxels but their own: `settle` fills their halos. Twin: shaders/chunks/field/bricks-3d.glsl
 */
export class ResidentBricks implements FinerVoxels {
  /** By cell: 1 + the slot of the brick that is shown there, or 0 where it is the volume itself. */
  readonly pages: CellNumbers;
  /** Counts bricks that come and go, and halos that change. */
  changes = 0;
  /** Counts changes of `macrocells`, as far as `current` has seen them. */
  #cellChanges = 0;
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
  /** Called when the capacity may be another one: memory of the GPU that is not needed is given back at once, as other views wait for it. */
  readonly fitted = new Set<() => void>();
  #current: { readonly volume: object; readonly cells: number; readonly now: object } | null = null;
  readonly #bricks = new Map<string, ResidentBrick>();
  readonly #bySlot: (ResidentBrick | undefined)[] = [];
  readonly #free: number[] = [];
  readonly #counts: number[];
  /** Where bricks have come or gone since halos were filled. */
  #changed: ChangedBox[] = [];
  readonly #cells: BrickCells;
  /** Smallest and largest stored value of all bricks that came: fewer of them when they go would change the tables of colours. */
  #low = Infinity;
  #high = -Infinity;

  /**
   * @param volume - over which the bricks lie: it is the level that is always there
   * @param upload - see `FinerVoxels`
   */
  constructor(
    readonly volume: Pick<VolumeData, 'grid' | 'samples' | 'macrocells' | 'hasNoData'>,
    readonly layout: BrickLayout,
    readonly upload: FinerVoxels['upload'],
  ) {
    this.atlas = shapeAtlas(volume.grid.dimensions);
    this.pages = new CellNumbers(layout.cells, layout.groupSide);
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
    // While more bricks come, who asks for them settles what has come.
    if (!this.moving) this.#settleAtOnce();
    const shown: ShownBricks = (first, last, meet) =>
      this.pages.visit(first, last, (page) => meet(this.#bySlot[page - 1]));
    const cells = (this.#cellChanges += Number(this.#cells.update(shown, this.#level)));
    if (this.#current?.volume !== volume || this.#current.cells !== cells)
      this.#current = {
        volume,
        cells,
        now: { ...volume, macrocells: this.macrocells, range: this.#widenRange(volume) },
      };
    return this.#current.now as V;
  }

  #settleAtOnce(): void {
    const work = this.settle();
    while (!work.next().done) continue;
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

  /** Takes over the samples; `settle` replaces their halo. */
  add(place: Brick, values: Omit<BrickSamples, 'hasNoData'>): ResidentBrick {
    const known = this.get(place);
    if (known) return known;
    const slot = this.#free.pop() ?? this.#bySlot.length;
    const { level, at } = place;
    const { samples } = values;
    const brick: ResidentBrick = {
      level,
      at,
      ...values,
      slot,
      blocks: measureBlocks(samples),
      hasNoData: lacksData(samples),
    };
    this.#bricks.set(keyOfBrick(brick), brick);
    this.#bySlot[slot] = brick;
    this.#counts[level]++;
    const isCoarser = (page: number): boolean => page === 0 || this.#bySlot[page - 1]!.level > level;
    this.#change(brick, (before) => (isCoarser(before) ? slot + 1 : before));
    this.#widen(brick);
    return brick;
  }

  remove(place: Brick): void {
    const brick = this.get(place);
    if (!brick) return;
    const { slot, level } = brick;
    this.#bricks.delete(keyOfBrick(brick));
    this.#bySlot[slot] = undefined;
    this.#free.push(slot);
    this.#counts[level]--;
    this.#change(brick, (before, first, last) => (before === slot + 1 ? this.#coarser(first, last, level) : before));
  }

  /** Whether the halo of a brick that is there has all voxels of its level: all neighbours are there, and none has come since halos were filled. */
  isComplete(brick: Brick): boolean {
    const box = cellsOfBrick(this.layout, brick.level, brick.at);
    return (
      waysToNeighbours.every((way) => this.get(neighbourOf(this.layout, brick, way)) !== undefined) &&
      !this.#changed.some((one) => touches(box, one.box))
    );
  }

  /**
   * Fills the halos of the bricks that touch what has come or gone, with pauses: of the coarsest first, as finer ones may show what is between the last voxels of these.
   * What comes meanwhile waits for the next time.
   */
  *settle(): Waiting<void> {
    if (this.#changed.length === 0) return;
    const due = new Set(this.#changed);
    const { layout, volume, pages } = this;
    const sources = {
      layout,
      volume,
      pages,
      inSlot: (slot: number) => this.#bySlot[slot],
      find: (brick: Brick) => this.get(brick),
    };
    const changed = [...due];
    const byLevel = [...this.bricks];
    byLevel.sort((a, b) => b.level - a.level);
    for (const listed of byLevel) {
      const box = cellsOfBrick(layout, listed.level, listed.at);
      if (!changed.some((one) => listed.level < one.level && touches(box, one.box))) continue;
      const brick = this.get(listed);
      if (!brick || !fillHalo(sources, brick)) continue;
      const { samples } = brick;
      const other: ResidentBrick = { ...brick, blocks: measureBlocks(samples), hasNoData: lacksData(samples) };
      this.#bricks.set(keyOfBrick(other), other);
      this.#bySlot[other.slot] = other;
      this.changes++;
      this.#cells.change(...box);
      if (other.hasNoData !== brick.hasNoData) this.pages.touch(...box);
      // Of its level, halos have the voxels inside of it.
      changed.push({ box, level: brick.level });
      yield;
    }
    this.#changed = this.#changed.filter((one) => !due.has(one));
  }

  /** From now on there are at most so many slots, and bricks: the last ones that came go, and those in other slots get another one. */
  fit(capacity: number): void {
    this.capacity = capacity;
    this.#moveInto(capacity);
    for (const shrink of this.fitted) shrink();
  }

  #moveInto(capacity: number): void {
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
    return this.#levelOf(this.slotOf(cell));
  }

  #levelOf(slot: number): number {
    return this.#bySlot[slot]?.level ?? this.layout.levels.length;
  }

  /** The level that a cell would have if the brick that it shows were not there. */
  levelWithout(cell: number): number {
    const at = placeOfCell(this.layout, cell);
    return this.#levelOf(this.#coarser(at, at, this.levelOf(cell))! - 1);
  }

  /** The slot of the brick that a cell shows; -1 where it has none. */
  slotOf(cell: number): number {
    return this.pages.at(...placeOfCell(this.layout, cell)) - 1;
  }

  /** The same at a place of the unit cube. */
  slotAt(place: Vector3): number {
    return this.pages.at(...cellOfPlace(this.layout, place)) - 1;
  }

  storedAt(place: Vector3): number {
    const inside = this.#inFinest(place);
    return this.#read(this.#brickAt(inside), inside);
  }

  storedNextTo(place: Vector3, axis: number, by: number): number {
    const inside = this.#inFinest(place);
    const brick = this.#brickAt(inside);
    inside[axis] += by / this.#voxelsOf(brick)[axis];
    return this.#read(brick, inside);
  }

  /** The stored value in a brick, which need not be one of these. */
  storedIn(brick: Brick & Pick<BrickSamples, 'samples'>, place: Vector3): number {
    return this.#read(brick, this.#inFinest(place));
  }

  #read(brick: (Brick & Pick<BrickSamples, 'samples'>) | undefined, inside: Vector3): number {
    if (brick) return interpolate(brick.samples, slotDimensions, this.#placeIn(brick, inside));
    return interpolate(this.volume.samples, this.volume.grid.dimensions, inside);
  }

  /** The place itself, or where the volume reaches beyond the finest level, the nearest one in that. */
  #inFinest(place: Vector3): [number, number, number] {
    const { scale, shift, dimensions } = this.layout.levels[0];
    const along = (axis: number): number =>
      Math.min((dimensions[axis] - shift[axis]) / scale[axis], Math.max(-shift[axis] / scale[axis], place[axis]));
    return [along(0), along(1), along(2)];
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
    const along = (axis: number): number => {
      const voxel = Math.min(Math.max(place[axis] * scale[axis] + shift[axis], 0.5), dimensions[axis] - 0.5);
      return (voxel - brickSide * at[axis] + brickHalo) / slotSide;
    };
    return [along(0), along(1), along(2)];
  }

  voxelAt(place: Vector3): Vector3 {
    const [x, y, z] = this.#voxelsOf(this.#brickAt(place));
    return [1 / x, 1 / y, 1 / z];
  }

  /** Voxels along the unit cube of what is shown. */
  #voxelsOf(brick: Brick | undefined): Vector3 {
    return brick ? this.layout.levels[brick.level].scale : this.volume.grid.dimensions;
  }

  kinksAlong(from: Vector3, to: Vector3): readonly number[] {
    return findKinks({ layout: this.layout, grid: this.grid, slotAt: (place) => this.slotAt(place) }, from, to);
  }

  /** The number of the cell at a place of the unit cube. */
  cellAt(place: Vector3): number {
    const [i, j, k] = cellOfPlace(this.layout, place);
    return i + this.layout.cells[0] * (j + this.layout.cells[1] * k);
  }

  #brickAt(place: Vector3): ResidentBrick | undefined {
    return this.#bySlot[this.slotAt(place)];
  }

  /** The page of the finest brick of the levels beyond one that covers a box of cells; null where no single one does. @param last - is inside */
  #coarser(first: Vector3, last: Vector3, level: number): number | null {
    const { levels } = this.layout;
    for (let next = level + 1; next < levels.length; next++) {
      if (this.#counts[next] === 0) continue;
      const at = brickOfCell(levels[next], first);
      if (brickOfCell(levels[next], last).some((n, axis) => n !== at[axis])) return null;
      const found = this.get({ level: next, at });
      if (found) return found.slot + 1;
    }
    return 0;
  }

  /** The pages of a brick that comes or goes. */
  #change({ level, at }: Brick, next: NextNumber): void {
    const box = cellsOfBrick(this.layout, level, at);
    this.changes++;
    this.#changed.push({ box, level: Infinity });
    this.#cells.change(...box);
    this.pages.change(...box, next);
  }

  #widen({ low, high }: ResidentBrick): void {
    if (!(low <= high)) return;
    [this.#low, this.#high] = [Math.min(this.#low, low), Math.max(this.#high, high)];
  }
}
