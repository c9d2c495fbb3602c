import { atlasLayout } from './atlas.ts';
import { spacingOf } from './grid.ts';
import type { GridFrame } from './grid.ts';
import { multiply, scaleAndTranslate } from './matrix.ts';
import type { Vector3 } from './matrix.ts';
import { allocateLike } from './samples.ts';
import type { Samples } from './samples.ts';

/** What a device can hold of one volume. */
export interface DeviceLimits {
  /** Maximum number of voxels along any axis: MAX_3D_TEXTURE_SIZE, or what the 2D atlas allows. */
  readonly maxVoxelsPerAxis: number;
  /** Maximum edge of the 2D atlas that the volume has to fit, in texels; null if 3D textures are used. */
  readonly maxAtlasSize: number | null;
  /** Maximum number of bytes of the volume's samples. */
  readonly maxBytes: number;
}

/** The parts of a volume that are needed to make it smaller. */
export interface Block extends Pick<GridFrame, 'dimensions' | 'indexToWorld'> {
  readonly samples: Samples;
}

/** Reduces a volume to what a device can hold; returns the same volume if it fits. */
export function fitVolume(block: Block, limits: DeviceLimits): Block {
  const factors = chooseReduction(block, limits);
  return factors.some((factor) => factor > 1) ? reduceVolume(block, factors) : block;
}

/**
 * Chooses the smallest number of voxels to average along each axis so that a volume fits a device: first what the
 * longest axis needs, then repeatedly one more along the axis with the shortest voxels in the world.
 * @returns whole numbers from 1; all 1 if the volume fits as it is
 */
export function chooseReduction(block: Block, limits: DeviceLimits): Vector3 {
  const spacing = spacingOf(block.indexToWorld);
  const max = Math.max(1, limits.maxVoxelsPerAxis);
  const factors = block.dimensions.map((n) => Math.ceil(n / max));
  const bytes = block.samples.BYTES_PER_ELEMENT;
  const reduced = (): Vector3 => reduceDimensions(block.dimensions, factors as unknown as Vector3);
  const fits = ([nx, ny, nz]: Vector3): boolean =>
    nx * ny * nz * bytes <= limits.maxBytes &&
    (limits.maxAtlasSize === null || atlasLayout([nx, ny, nz], limits.maxAtlasSize) !== null);
  for (let now = reduced(); !fits(now) && now.some((n) => n > 1); now = reduced()) {
    const open = [0, 1, 2].filter((axis) => now[axis] > 1);
    const finest = open.reduce((a, b) => (factors[b] * spacing[b] < factors[a] * spacing[a] ? b : a));
    factors[finest]++;
  }
  return factors as unknown as Vector3;
}

/** Voxels along each axis after `factors` voxels are averaged into one. */
export function reduceDimensions(dimensions: Vector3, factors: Vector3): Vector3 {
  return dimensions.map((n, axis) => Math.ceil(n / factors[axis])) as unknown as Vector3;
}

/**
 * Averages boxes of voxels. The outer faces of the volume stay where they are in the world. An axis that the factor
 * does not divide is cut into equal boxes a little smaller than the factor, and voxels on a cut count by their share.
 * Samples without data (NaN) are left out; a box without any data is NaN.
 * @param factors - voxels per box along i, j and k, whole numbers from 1
 */
export function reduceVolume(block: Block, factors: Vector3): Block {
  const from = block.dimensions;
  const to = reduceDimensions(from, factors);
  const scale: Vector3 = [from[0] / to[0], from[1] / to[1], from[2] / to[2]];
  const overlaps = [0, 1, 2].map((axis) =>
    Array.from({ length: to[axis] }, (_, i) => overlap(i, scale[axis], from[axis])),
  );
  const samples = allocateLike(block.samples, to[0] * to[1] * to[2]);
  const isFloat = samples instanceof Float32Array;
  const row: BoxRow = { overlaps: overlaps[0], sums: new Float64Array(to[0]), totals: new Float64Array(to[0]) };
  let out = 0;
  for (const z of overlaps[2]) {
    for (const y of overlaps[1]) {
      averageRow(block, row, y, z);
      for (let i = 0; i < to[0]; i++) {
        const mean = row.totals[i] > 0 ? row.sums[i] / row.totals[i] : NaN;
        samples[out++] = isFloat ? mean : Math.floor(mean + 0.5);
      }
    }
  }
  const offset: Vector3 = [(scale[0] - 1) / 2, (scale[1] - 1) / 2, (scale[2] - 1) / 2];
  return { dimensions: to, samples, indexToWorld: multiply(block.indexToWorld, scaleAndTranslate(scale, offset)) };
}

/** Voxels `first` to `first + weights.length - 1` that box `i` covers, and the covered share of each. */
export interface Overlap {
  readonly first: number;
  readonly weights: readonly number[];
}

export function overlap(i: number, scale: number, count: number): Overlap {
  const start = i * scale;
  const end = (i + 1) * scale;
  const first = Math.floor(start + 1e-9); // A cut just before a voxel's edge lies on the edge: the difference is rounding.
  const last = Math.min(count, Math.ceil(end - 1e-9));
  const weights: number[] = [];
  for (let v = first; v < last; v++) weights.push(Math.min(end, v + 1) - Math.max(start, v));
  return { first, weights };
}

/** A row of boxes: the weighted sum of each, and the sum of its weights. */
interface BoxRow {
  readonly overlaps: readonly Overlap[];
  readonly sums: Float64Array;
  readonly totals: Float64Array;
}

/** Adds up the voxels of a row of boxes, in the order in which they lie in memory. */
function averageRow({ samples, dimensions }: Block, row: BoxRow, y: Overlap, z: Overlap): void {
  const [nx, ny] = dimensions;
  row.sums.fill(0);
  row.totals.fill(0);
  for (let c = 0; c < z.weights.length; c++) {
    for (let b = 0; b < y.weights.length; b++) {
      const start = ((z.first + c) * ny + y.first + b) * nx;
      addRow(samples.subarray(start, start + nx), z.weights[c] * y.weights[b], row);
    }
  }
}

function addRow(values: Samples, share: number, { overlaps, sums, totals }: BoxRow): void {
  for (let i = 0; i < overlaps.length; i++) {
    const { first, weights } = overlaps[i];
    let sum = 0;
    let total = 0;
    for (let a = 0; a < weights.length; a++) {
      const value = values[first + a];
      if (Number.isNaN(value)) continue;
      sum += weights[a] * value;
      total += weights[a];
    }
    sums[i] += share * sum;
    totals[i] += share * total;
  }
}
