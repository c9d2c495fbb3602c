import { add, scale, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { SampleAt } from './sample-at.ts';

/** Pixels of a slice, and where they are in the world. */
export interface SlicePixels {
  readonly width: number;
  readonly height: number;
  /** World, centre of the first pixel, at the top left. */
  readonly first: Vector3;
  /** World, from pixel to pixel. */
  readonly across: Vector3;
  readonly down: Vector3;
}

/** What of a slab's values is shown. */
export const slabProjections = ['average', 'max', 'min'] as const;
export type SlabProjection = (typeof slabProjections)[number];

/** How thick a slice is. */
export interface Slab {
  /** World, unit length. */
  readonly normal: Vector3;
  /** World units; 0 for a plane. */
  readonly thickness: number;
  readonly projection: SlabProjection;
  /** Planes that are sampled through it, evenly, each in the middle of its share: the average errs by the square of their distance. */
  readonly planes: number;
}

/** What is sampled. */
export interface SliceField {
  readonly sampleAt: SampleAt;
  readonly worldToIndex: Matrix4;
}

/** A slice of it. */
export interface Slice {
  readonly field: SliceField;
  readonly pixels: SlicePixels;
  readonly slab: Slab;
}

/**
 * Stored values of some rows of a slice, row after row from the top; NaN where there is nothing. In a slab, places without data
 * are left out.
 * @param values - width x height; those of the rows are filled
 * @param rows - the first, and the one after the last
 */
export function fillRows({ field: { sampleAt, worldToIndex }, pixels, slab }: Slice, values: Float64Array, rows: readonly [number, number]): void {
  const { width } = pixels;
  const [ax, ay, az] = transformDirection(worldToIndex, pixels.across);
  const through = transformDirection(worldToIndex, scale(slab.normal, slab.thickness / slab.planes));
  const planes = slab.thickness > 0 ? slab.planes : 1;
  for (let row = rows[0]; row < rows[1]; row++) {
    const [x0, y0, z0] = transformPoint(worldToIndex, add(pixels.first, scale(pixels.down, row)));
    for (let column = 0, at = row * width; column < width; column++, at++) {
      const [x, y, z] = [x0 + column * ax, y0 + column * ay, z0 + column * az];
      values[at] = planes === 1 ? sampleAt(x, y, z) : project(sampleAt, [x, y, z], through, slab);
    }
  }
}

function project(sampleAt: SampleAt, [x, y, z]: Vector3, [dx, dy, dz]: Vector3, { planes, projection }: Slab): number {
  let [sum, count, least, most] = [0, 0, Infinity, -Infinity];
  for (let plane = 0; plane < planes; plane++) {
    const by = plane - (planes - 1) / 2;
    const value = sampleAt(x + by * dx, y + by * dy, z + by * dz);
    if (Number.isNaN(value)) continue;
    sum += value;
    count++;
    if (value < least) least = value;
    if (value > most) most = value;
  }
  if (count === 0) return NaN;
  return projection === 'average' ? sum / count : projection === 'max' ? most : least;
}
