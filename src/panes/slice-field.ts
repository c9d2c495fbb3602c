import { corners } from '../volume/grid.ts';
import type { CartesianGrid } from '../volume/grid.ts';
import { dot, invertAffine, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { Volume } from '../volume/volume.ts';
import type { Slab, SliceField } from './fill-slice.ts';
import { boxAround } from './pane-frame.ts';
import type { PlaneBox } from './pane-frame.ts';
import { linearRow, rowOf } from './read-row.ts';
import type { ReadRow } from './read-row.ts';
import { linearSampler, nearestSampler } from './sample-at.ts';
import type { SampleAt } from './sample-at.ts';
import type { SlicePlane } from './slice-plane.ts';

/** Samples planes of a slab are apart, in the shortest voxel edge that they cross. */
const planesAVoxel = 2;

/** Planes of a slab at most: beyond, they are farther apart. */
const mostPlanes = 512;

/** A volume on a cartesian grid as panes read it: places in the world, and values in its own unit. */
export class SlicedVolume {
  readonly worldToIndex: Matrix4;
  readonly #nearest: SampleAt;
  readonly #linear: SampleAt;
  readonly #readRow: ReadRow;

  constructor(readonly volume: Volume, readonly grid: CartesianGrid) {
    const block = { samples: volume.samples, dimensions: grid.dimensions, hasNoData: volume.hasNoData };
    this.worldToIndex = invertAffine(grid.indexToWorld)!; // A loaded volume has been checked to have one.
    this.#nearest = nearestSampler(block);
    this.#linear = volume.isDiscrete ? this.#nearest : linearSampler(block);
    this.#readRow = volume.isDiscrete ? rowOf(this.#nearest) : linearRow(block, this.#linear);
  }

  field(isNearest: boolean): SliceField {
    const { worldToIndex } = this;
    return isNearest ? { sampleAt: this.#nearest, worldToIndex } : { sampleAt: this.#linear, readRow: this.#readRow, worldToIndex };
  }

  get center(): Vector3 {
    return transformPoint(this.grid.indexToWorld, this.grid.dimensions.map((n) => (n - 1) / 2) as unknown as Vector3);
  }

  /** Of all its voxels, along a plane's directions. */
  boxAlong(plane: SlicePlane): PlaneBox {
    return boxAround(plane, corners(this.grid));
  }

  /** From one slice to the next along a direction: so far that no index changes by more than one. World units. */
  stepAlong(direction: Vector3): number {
    return 1 / Math.max(...transformDirection(this.worldToIndex, direction).map(Math.abs));
  }

  /**
   * How thick a slab is sampled: no thicker than all of the volume needs, or its planes, which are few, might miss it. Labels have
   * no mean: what is in the middle is shown.
   * @param at - where its middle is, world units along the normal
   */
  thicknessAt(at: number, { normal, thickness, projection }: Omit<Slab, 'planes'>): number {
    if (this.volume.isDiscrete && projection === 'average') return 0;
    const ways = corners(this.grid).map((corner) => Math.abs(dot(normal, corner) - at));
    return Math.min(thickness, 2 * Math.max(...ways));
  }

  /** Planes to sample a slab with: two a voxel. */
  planesOf(normal: Vector3, thickness: number): number {
    return Math.min(mostPlanes, Math.max(1, Math.ceil((thickness / this.stepAlong(normal)) * planesAVoxel)));
  }

  /** The value of the voxel at a place; null where there is none. */
  valueAt(place: Vector3): number | null {
    const { slope, intercept } = this.volume;
    const value = slope * this.#nearest(...transformPoint(this.worldToIndex, place)) + intercept;
    return Number.isNaN(value) ? null : value;
  }
}
