import type { ProjectionKind } from '../optics/ray-style.ts';
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

/** How thick a slice is. */
export interface Slab {
  /** World, unit length. */
  readonly normal: Vector3;
  /** World units; 0 for a plane. */
  readonly thickness: number;
  /** What of its values is shown. */
  readonly projection: ProjectionKind;
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
  const [dx, dy, dz] = transformDirection(worldToIndex, scale(slab.normal, slab.thickness / slab.planes));
  const planes = slab.thickness > 0 ? slab.planes : 1;
  const merge = merging[slab.projection];
  const counts = new Uint16Array(width);
  for (let row = rows[0]; row < rows[1]; row++) {
    const [x0, y0, z0] = transformPoint(worldToIndex, add(pixels.first, scale(pixels.down, row)));
    const start = row * width;
    values.fill(NaN, start, start + width);
    counts.fill(0);
    // Plane by plane: what is next to each other in a row is near in memory too.
    for (let plane = 0; plane < planes; plane++) {
      const by = plane - (planes - 1) / 2;
      for (let column = 0; column < width; column++) {
        const value = sampleAt(x0 + by * dx + column * ax, y0 + by * dy + column * ay, z0 + by * dz + column * az);
        if (Number.isNaN(value)) continue; // No data are left out.
        values[start + column] = counts[column] === 0 ? value : merge(values[start + column], value);
        counts[column]++;
      }
    }
    if (slab.projection !== 'average' || planes === 1) continue;
    for (let column = 0; column < width; column++) values[start + column] /= counts[column];
  }
}

/** How a value joins those before it. */
const merging: Readonly<Record<ProjectionKind, (before: number, value: number) => number>> = {
  average: (before, value) => before + value,
  max: (before, value) => (value > before ? value : before),
  min: (before, value) => (value < before ? value : before),
};
