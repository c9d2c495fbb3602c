import type { ProjectionKind } from '../optics/ray-style.ts';
import { add, scale, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import { rowOf } from './read-row.ts';
import type { ReadRow } from './read-row.ts';
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
  /** The same for a row of places, where there is a quicker way. */
  readonly readRow?: ReadRow;
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
export function fillRows({ field: { sampleAt, readRow = rowOf(sampleAt), worldToIndex }, pixels, slab }: Slice, values: Float64Array, rows: readonly [number, number]): void {
  const { width } = pixels;
  const across = transformDirection(worldToIndex, pixels.across);
  const [dx, dy, dz] = transformDirection(worldToIndex, scale(slab.normal, slab.thickness / slab.planes));
  const planes = slab.thickness > 0 ? slab.planes : 1;
  const line = new Float64Array(width);
  const counts = new Uint16Array(width);
  for (let row = rows[0]; row < rows[1]; row++) {
    const [x0, y0, z0] = transformPoint(worldToIndex, add(pixels.first, scale(pixels.down, row)));
    const merged = values.subarray(row * width, (row + 1) * width);
    if (planes === 1) {
      readRow([x0, y0, z0], across, merged);
      continue;
    }
    const { none, merge, end } = merging[slab.projection];
    merged.fill(none);
    counts.fill(0);
    // Plane by plane: what is next to each other in a row is near in memory too.
    for (let plane = 0; plane < planes; plane++) {
      const by = plane - (planes - 1) / 2;
      readRow([x0 + by * dx, y0 + by * dy, z0 + by * dz], across, line);
      merge(merged, line, counts);
    }
    end(merged, counts);
  }
}

/** How the rows of planes become one. Places without data, NaN, are left out. */
interface Merging {
  /** What a row is before the first one. */
  readonly none: number;
  merge(merged: Float64Array, line: Float64Array, counts: Uint16Array): void;
  end(merged: Float64Array, counts: Uint16Array): void;
}

/** Where no plane had data, nothing is there. */
function withoutNone(merged: Float64Array): void {
  for (let i = 0; i < merged.length; i++) if (!Number.isFinite(merged[i])) merged[i] = NaN;
}

const merging: Readonly<Record<ProjectionKind, Merging>> = {
  average: {
    none: 0,
    merge(merged, line, counts) {
      for (let i = 0; i < line.length; i++) {
        if (Number.isNaN(line[i])) continue;
        merged[i] += line[i];
        counts[i]++;
      }
    },
    end(merged, counts) {
      for (let i = 0; i < merged.length; i++) merged[i] /= counts[i];
    },
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
