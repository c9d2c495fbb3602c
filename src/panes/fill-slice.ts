import type { ProjectionKind } from '../optics/rays/ray-style.ts';
import { cutToVoxels, meetVoxelPlanes } from '../optics/rays/voxel-planes.ts';
import { add, scale, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import { lineMerger } from './merge-line.ts';
import { rowOf } from './read-row.ts';
import type { ReadRow } from './read-row.ts';
import type { SampleAt, SampledBlock } from './sample-at.ts';

/** Pixels of a slice, and their position in the world. */
export interface SlicePixels {
  readonly width: number;
  readonly height: number;
  /** World, centre of the first pixel, at the top left. */
  readonly first: Vector3;
  /** World, from one pixel to the next. */
  readonly across: Vector3;
  readonly down: Vector3;
}

/** The thickness of a slice. */
export interface Slab {
  /** World, unit length. */
  readonly normal: Vector3;
  /** World units; 0 for a plane. */
  readonly thickness: number;
  /** How its values are combined. */
  readonly projection: ProjectionKind;
  /**
   * Number of planes at which it is sampled, evenly spaced, each in the middle of its part: for a quick picture. If
   * absent, all planes of the grid.
   */
  readonly planes?: number;
}

/** The field that is sampled. */
export interface SliceField {
  readonly sampleAt: SampleAt;
  /** The same for a row of points, if there is a faster way. */
  readonly readRow?: ReadRow;
  readonly worldToIndex: Matrix4;
  /**
   * Its voxels, and whether each point has the value of the nearest one: slabs are computed from them. Absent if the
   * number of planes is set.
   */
  readonly voxels?: SampledBlock & { readonly isNearest: boolean };
}

/** A slice of the field. */
export interface Slice {
  readonly field: SliceField;
  readonly pixels: SlicePixels;
  readonly slab: Slab;
}

/**
 * Fills some rows of a slice with stored values, row after row from the top; NaN where there is no value. In a slab,
 * points without data are left out.
 * @param values - width x height; those of the rows are filled
 * @param rows - the first, and the one after the last
 */
export function fillRows(slice: Slice, values: Float64Array, [first, end]: readonly [number, number]): void {
  const {
    field: { sampleAt, readRow = rowOf(sampleAt), worldToIndex },
    pixels,
    slab,
  } = slice;
  const { width } = pixels;
  const across = transformDirection(worldToIndex, pixels.across);
  const way = transformDirection(worldToIndex, scale(slab.normal, slab.thickness));
  const isPlane = !(slab.thickness > 0) || slab.planes === 1;
  const planes = isPlane ? null : slab.planes ? evenPlanes(slab.planes) : alignedPlanes(slice, way);
  const mergeLine =
    isPlane || planes
      ? null
      : lineMerger(slice.field.voxels!, { way, kind: slab.projection, isNearest: slice.field.voxels!.isNearest });
  const [line, weights] = [new Float64Array(width), new Float64Array(width)];
  for (let row = first; row < end; row++) {
    const middle = transformPoint(worldToIndex, add(pixels.first, scale(pixels.down, row)));
    const merged = values.subarray(row * width, (row + 1) * width);
    if (isPlane) readRow(middle, across, merged);
    else if (planes)
      mergePlanes(planes, { way, middle, across, readRow, line, weights, merging: merging[slab.projection] }, merged);
    else {
      const [x, y, z] = add(middle, scale(way, -0.5));
      for (let column = 0; column < width; column++)
        merged[column] = mergeLine!(x + column * across[0], y + column * across[1], z + column * across[2]);
    }
  }
}

/**
 * A plane through a slab: its position as a share of the thickness, and its weight, the part of the thickness that it
 * stands for.
 */
type SlabPlane = readonly [share: number, weight: number];

function evenPlanes(planes: number): readonly SlabPlane[] {
  return Array.from({ length: planes }, (_, i) => [(i + 0.5) / planes, 1]);
}

/** If it deviates by less than this, voxels, a slab is along an axis of the grid. */
const drift = 1e-9;

/**
 * The planes that give the exact extremes of a slab along an axis of the grid, and its mean by trapezoids: its two
 * ends, and the planes of voxels' centres between them, because values are straight lines in between. For nearest
 * values, one plane for each voxel.
 * @returns null for a slab that is not along an axis, or not the same for all pixels
 */
function alignedPlanes({ field: { voxels, worldToIndex }, pixels }: Slice, way: Vector3): readonly SlabPlane[] | null {
  const { dimensions, isNearest } = voxels!;
  const axis = [0, 1, 2].find((one) => [0, 1, 2].every((other) => other === one || Math.abs(way[other]) < drift));
  if (axis === undefined) return null;
  const sides: readonly (readonly [Vector3, number])[] = [
    [pixels.across, pixels.width],
    [pixels.down, pixels.height],
  ];
  if (sides.some(([side, count]) => Math.abs(count * transformDirection(worldToIndex, side)[axis]) > drift))
    return null;
  const from = add(transformPoint(worldToIndex, pixels.first), scale(way, -0.5));
  // Pixels outside the volume do not matter, whatever the planes are.
  const inside = from.map((x, other) => (other === axis ? x : 0)) as unknown as Vector3;
  const part = cutToVoxels(inside, way, dimensions);
  if (!part) return [];
  const [begin, end] = part;
  const between = meetVoxelPlanes(inside, way, dimensions, isNearest ? 0.5 : 0).filter(
    (share) => share > begin && share < end,
  );
  const shares = [begin, ...between, end];
  if (isNearest) return shares.slice(1).map((share, i) => [(share + shares[i]) / 2, share - shares[i]]);
  return shares.map((share, i) => [share, ((shares[i + 1] ?? share) - (shares[i - 1] ?? share)) / 2]);
}

/** A row of a slab, and buffers to work in. */
interface SlabRow {
  readonly way: Vector3;
  /** Index of its first pixel, in the middle of the slab. */
  readonly middle: Vector3;
  readonly across: Vector3;
  readonly readRow: ReadRow;
  readonly line: Float64Array;
  readonly weights: Float64Array;
  readonly merging: Merging;
}

/** Plane by plane, because neighbours in a row are also near in memory. */
function mergePlanes(
  planes: readonly SlabPlane[],
  { way, middle, across, readRow, line, weights, merging: { none, merge, end } }: SlabRow,
  merged: Float64Array,
): void {
  merged.fill(none);
  weights.fill(0);
  for (const [share, weight] of planes) {
    readRow(add(middle, scale(way, share - 0.5)), across, line);
    merge(merged, line, { weight, weights });
  }
  end(merged);
}

/** How the rows of planes are merged into one. Points without data, NaN, are left out. */
interface Merging {
  /** The value of a row before the first plane. */
  readonly none: number;
  /** @param of - the plane's weight, and the sum of the weights before it in each pixel */
  merge(
    merged: Float64Array,
    line: Float64Array,
    of: { readonly weight: number; readonly weights: Float64Array },
  ): void;
  /** Sets NaN where no plane had data. */
  end(merged: Float64Array): void;
}

function withoutNone(merged: Float64Array): void {
  for (let i = 0; i < merged.length; i++) if (!Number.isFinite(merged[i])) merged[i] = NaN;
}

const merging: Readonly<Record<ProjectionKind, Merging>> = {
  average: {
    none: NaN,
    // A running mean: the mean of a constant is the constant, to the last bit.
    merge(merged, line, { weight, weights }) {
      for (let i = 0; i < line.length; i++) {
        if (Number.isNaN(line[i])) continue;
        weights[i] += weight;
        merged[i] = Number.isNaN(merged[i])
          ? line[i]
          : merged[i] + (line[i] - merged[i]) * (weight / (weights[i] || 1));
      }
    },
    end: () => {},
  },
  max: {
    none: -Infinity,
    merge(merged, line) {
      for (let i = 0; i < line.length; i++) if (line[i] > merged[i]) merged[i] = line[i];
    },
    end: withoutNone,
  },
  min: {
    none: Infinity,
    merge(merged, line) {
      for (let i = 0; i < line.length; i++) if (line[i] < merged[i]) merged[i] = line[i];
    },
    end: withoutNone,
  },
};
