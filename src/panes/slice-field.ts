import { corners } from '../volume/grid.ts';
import type { CartesianGrid, GridFrame } from '../volume/grid.ts';
import { dot, invertAffine, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import { valueOf } from '../volume/index-numbers.ts';
import type { Volume } from '../volume/volume.ts';
import type { Slab, SliceField } from './fill-slice.ts';
import { boxAround } from './pane-frame.ts';
import type { PlaneBox } from './pane-frame.ts';
import { linearRow, rowOf } from './read-row.ts';
import type { ReadRow } from './read-row.ts';
import { linearSampler, nearestSampler } from './sample-at.ts';
import type { SampleAt, SampledBlock } from './sample-at.ts';
import type { SlicePlane } from './slice-plane.ts';

/** A volume on a cartesian grid as panes read it: points of the world, and values in the volume's own unit. */
export class SlicedVolume {
  readonly worldToIndex: Matrix4;
  /** The grid of the finest voxels, of which the volume itself may have only means. */
  readonly finest: GridFrame;
  readonly #worldToFinest: Matrix4;
  readonly #block: SampledBlock;
  readonly #nearest: SampleAt;
  readonly #linear: SampleAt;
  readonly #readRow: ReadRow;

  constructor(
    readonly volume: Volume,
    readonly grid: CartesianGrid,
  ) {
    const block = { samples: volume.samples, dimensions: grid.dimensions, hasNoData: volume.hasNoData };
    this.#block = block;
    this.worldToIndex = invertAffine(grid.indexToWorld)!; // The inverse exists: it was checked when the volume was loaded.
    this.finest = volume.finer?.finest ?? grid;
    this.#worldToFinest = invertAffine(this.finest.indexToWorld)!;
    this.#nearest = nearestSampler(block);
    this.#linear = volume.isDiscrete ? this.#nearest : linearSampler(block);
    this.#readRow = volume.isDiscrete ? rowOf(this.#nearest) : linearRow(block, this.#linear);
  }

  field(isNearest: boolean): SliceField {
    const { worldToIndex } = this;
    const voxels = { ...this.#block, isNearest: isNearest || this.volume.isDiscrete === true };
    return isNearest
      ? { sampleAt: this.#nearest, worldToIndex, voxels }
      : { sampleAt: this.#linear, readRow: this.#readRow, worldToIndex, voxels };
  }

  get center(): Vector3 {
    return transformPoint(this.grid.indexToWorld, this.grid.dimensions.map((n) => (n - 1) / 2) as unknown as Vector3);
  }

  /** The box around all its voxels, along a plane's directions. */
  boxAlong(plane: SlicePlane): PlaneBox {
    return boxAround(plane, corners(this.grid));
  }

  /** The distance between slices along a direction: so far that no index changes by more than one. World units. */
  stepAlong(direction: Vector3): number {
    return 1 / Math.max(...transformDirection(this.#worldToFinest, direction).map(Math.abs));
  }

  /**
   * The thickness with which a slab is shown: at most what the volume needs. Labels have no mean: for them the middle
   * is shown.
   * @param at - position of its middle, world units along the normal
   */
  thicknessAt(at: number, { normal, thickness, projection }: Omit<Slab, 'planes'>): number {
    if (this.volume.isDiscrete && projection === 'average') return 0;
    const ways = corners(this.grid).map((corner) => Math.abs(dot(normal, corner) - at));
    return Math.min(thickness, 2 * Math.max(...ways));
  }

  /**
   * Number of planes of voxels that a line through a slab crosses, and its ends: about the number of samples for each
   * pixel.
   */
  planesIn(normal: Vector3, thickness: number): number {
    const way = transformDirection(this.worldToIndex, normal);
    return thickness > 0 ? 2 + Math.ceil(thickness * way.reduce((sum, x) => sum + Math.abs(x), 0)) : 1;
  }

  /** The value of the voxel at a point; null if there is none. */
  valueAt(place: Vector3): number | null {
    const { volume } = this;
    const { indexed } = volume;
    const at = transformPoint(this.worldToIndex, place);
    const stored = this.#finerAt(at) ?? this.#nearest(...at);
    // Values that float32 rounds are returned as they are in the file.
    const value =
      indexed && !Number.isNaN(stored)
        ? indexed.ids[nearestSampler({ samples: indexed.samples, dimensions: this.grid.dimensions })(...at)]
        : valueOf(volume, stored);
    return Number.isNaN(value) ? null : value;
  }

  /** The value of a finer voxel, if there is one. @param at - index of the volume */
  #finerAt(at: Vector3): number | undefined {
    const { dimensions } = this.grid;
    const place = at.map((x, axis) => (x + 0.5) / dimensions[axis]) as unknown as Vector3;
    return place.every((x) => x >= 0 && x <= 1) ? this.volume.finer?.nearestAt(place) : undefined;
  }
}
