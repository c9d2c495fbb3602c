// What the coarser levels of a pyramid hide, block by block.
import type { Vector3 } from '../volume/matrix.ts';
import type { Pyramid, PyramidLevel } from './pyramid.ts';

/** How far the interpolated values of a level are from those of level 0, in stored values: arrays by block. */
export interface LevelResiduals {
  /** max |v0 - interpolated(vL)| over the voxels of level 0. */
  readonly max: Float32Array<ArrayBuffer>;
  /** Root of the mean square of the same. */
  readonly rms: Float32Array<ArrayBuffer>;
}

/** What is known of each block of level 0 in addition to its voxels. It is written together with a pyramid. */
export interface ResidualTable {
  /** Voxels of a block along each axis, and blocks of the volume: i fastest. */
  readonly side: number;
  readonly blocks: Vector3;
  /** Smallest and largest stored value of the block, with the next voxel on each side; low > high where it has no data. */
  readonly low: Float32Array<ArrayBuffer>;
  readonly high: Float32Array<ArrayBuffer>;
  /** By level; those of level 0 are 0. */
  readonly levels: readonly LevelResiduals[];
}

/** Where a voxel of level 0 lies between two voxels of a coarser level, along one axis. */
interface Between {
  readonly first: Int32Array;
  readonly second: Int32Array;
  /** Weight of the second. */
  readonly weight: Float64Array;
}

function betweenVoxels(count: number, level: number, coarse: number): Between {
  const places = Float64Array.from({ length: count }, (_, i) =>
    Math.min(coarse - 1, Math.max(0, (i + 0.5) / 2 ** level - 0.5)),
  );
  return {
    first: Int32Array.from(places, Math.floor),
    second: Int32Array.from(places, (x) => Math.min(coarse - 1, Math.floor(x) + 1)),
    weight: places.map((x) => x - Math.floor(x)),
  };
}

/**
 * Measures what each level hides. Where only one of both has data, the residual is the whole range of the volume: an edge of the data is
 * always worth a look.
 * @param side - of a block; half of a brick's is a good choice: bricks are seldom visible as a whole
 */
export function measureResiduals({ levels }: Pick<Pyramid, 'levels'>, side: number): ResidualTable {
  const { dimensions, samples } = levels[0];
  const [nx, ny, nz] = dimensions;
  const blocks = dimensions.map((n) => Math.ceil(n / side)) as unknown as Vector3;
  const count = blocks[0] * blocks[1] * blocks[2];
  const { low, high } = measureRanges(levels[0], side, blocks);
  const span = Math.max(0, largest(high) - smallest(low));
  const found = levels.map(() => ({ max: new Float32Array(count), rms: new Float32Array(count) }));
  const blockOf = new Int32Array(nx).map((_, i) => Math.floor(i / side));
  for (let level = 1; level < levels.length; level++) {
    const { dimensions: coarse, samples: means } = levels[level];
    const [x, y, z] = dimensions.map((n, axis) => betweenVoxels(n, level, coarse[axis]));
    const squares = new Float64Array(count);
    const numbers = new Float64Array(count);
    const max = found[level].max;
    for (let k = 0, at = 0; k < nz; k++) {
      for (let j = 0; j < ny; j++) {
        const rows = [
          [z.first[k], y.first[j], (1 - z.weight[k]) * (1 - y.weight[j])],
          [z.first[k], y.second[j], (1 - z.weight[k]) * y.weight[j]],
          [z.second[k], y.first[j], z.weight[k] * (1 - y.weight[j])],
          [z.second[k], y.second[j], z.weight[k] * y.weight[j]],
        ].map(([c, b, weight]) => ({ start: coarse[0] * (b + coarse[1] * c), weight }));
        const blockRow = blocks[0] * (Math.floor(j / side) + blocks[1] * Math.floor(k / side));
        for (let i = 0; i < nx; i++, at++) {
          const [first, second, w] = [x.first[i], x.second[i], x.weight[i]];
          // As rays interpolate: voxels without data are left out, if the others make up half of the weights.
          let [sum, weights] = [0, 0];
          for (const { start, weight } of rows) {
            const [a, b] = [means[start + first], means[start + second]];
            if (!Number.isNaN(a)) {
              sum += weight * (1 - w) * a;
              weights += weight * (1 - w);
            }
            if (!Number.isNaN(b)) {
              sum += weight * w * b;
              weights += weight * w;
            }
          }
          const value = samples[at];
          const [isThere, isShown] = [!Number.isNaN(value), weights >= 0.5];
          if (!isThere && !isShown) continue;
          const residual = isThere && isShown ? Math.abs(value - sum / weights) : span;
          const block = blockRow + blockOf[i];
          if (residual > max[block]) max[block] = residual;
          squares[block] += residual ** 2;
          numbers[block]++;
        }
      }
    }
    for (let block = 0; block < count; block++)
      found[level].rms[block] = Math.sqrt(squares[block] / Math.max(1, numbers[block]));
  }
  return { side, blocks, low, high, levels: found };
}

/** Smallest and largest stored value of each block, with the next voxel on each side, as rays interpolate up to its centre. */
function measureRanges(
  { dimensions: [nx, ny, nz], samples }: PyramidLevel,
  side: number,
  blocks: Vector3,
): Pick<ResidualTable, 'low' | 'high'> {
  const count = blocks[0] * blocks[1] * blocks[2];
  const [low, high] = [new Float32Array(count).fill(Infinity), new Float32Array(count).fill(-Infinity)];
  for (let block = 0; block < count; block++) {
    const at = [
      block % blocks[0],
      Math.floor(block / blocks[0]) % blocks[1],
      Math.floor(block / (blocks[0] * blocks[1])),
    ];
    const [i0, j0, k0] = at.map((n) => Math.max(0, n * side - 1));
    const [i1, j1, k1] = [nx, ny, nz].map((n, axis) => Math.min(n, (at[axis] + 1) * side + 1));
    let [min, max] = [Infinity, -Infinity];
    for (let k = k0; k < k1; k++)
      for (let j = j0; j < j1; j++) {
        const row = nx * (j + ny * k);
        for (let i = row + i0; i < row + i1; i++) {
          if (samples[i] < min) min = samples[i];
          if (samples[i] > max) max = samples[i];
        }
      }
    low[block] = min;
    high[block] = max;
  }
  return { low, high };
}

const smallest = (values: Float32Array): number => values.reduce((a, b) => Math.min(a, b), Infinity);
const largest = (values: Float32Array): number => values.reduce((a, b) => Math.max(a, b), -Infinity);
