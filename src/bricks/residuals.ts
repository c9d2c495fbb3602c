// What the coarser levels of a pyramid hide, block by block.
import { interpolate } from '../optics/rays/interpolate.ts';
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
  /**
   * By level: how far the differences from the next finer level go together that are one of its voxels apart, at places between its voxels, as rays sample there: from 0 to 1
   * (noise has up to 0.25); 0 for level 0. Undefined where the writer has not said it.
   */
  readonly along?: readonly number[];
}

/** Voxels of a block of a table along each axis, where there are at most so many of the small ones: the rim of a thing is rougher than what is around it. */
const [smallBlock, largeBlock, mostSmall] = [16, 32, 2 ** 15];

/** Voxels along each axis of the blocks that a writer chooses. @param dimensions - of level 0 */
export function blockOfResiduals(dimensions: Vector3): number {
  const count = dimensions.reduce((product, n) => product * Math.ceil(n / smallBlock), 1);
  return count <= mostSmall ? smallBlock : largeBlock;
}

/** Where a voxel of level 0 lies between two voxels of a coarser level, along one axis. */
interface Between {
  readonly first: Int32Array;
  readonly second: Int32Array;
  /** Weight of the second. */
  readonly weight: Float64Array;
}

function placesBetween(count: number, level: number, coarse: number): Between {
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
 * @param side - of a block
 */
export function measureResiduals({ levels }: Pick<Pyramid, 'levels'>, side: number): ResidualTable {
  const { dimensions, samples } = levels[0];
  const [nx, ny, nz] = dimensions;
  const blocks = dimensions.map((n) => Math.ceil(n / side)) as unknown as Vector3;
  const count = blocks[0] * blocks[1] * blocks[2];
  const { low, high } = measureRanges(levels[0], side, blocks);
  const span = Math.max(0, largest(high) - smallest(low));
  const found = levels.map(() => ({ max: new Float32Array(count), rms: new Float32Array(count) }));
  const shown = new Float64Array(nx);
  for (let level = 1; level < levels.length; level++) {
    const { max, rms } = found[level];
    const interpolateRow = rowInterpolator(levels[level], dimensions, level);
    const numbers = new Float64Array(count);
    // Until the end, of the squares.
    const squares = new Float64Array(count);
    for (let k = 0; k < nz; k++)
      for (let j = 0; j < ny; j++) {
        interpolateRow(j, k, shown);
        const row = nx * (j + ny * k);
        const firstBlock = blocks[0] * (Math.floor(j / side) + blocks[1] * Math.floor(k / side));
        for (let i = 0; i < nx; i++) {
          const value = samples[row + i];
          const [isThere, isShown] = [value === value, shown[i] === shown[i]];
          if (!isThere && !isShown) continue;
          const residual = isThere && isShown ? Math.abs(value - shown[i]) : span;
          const block = firstBlock + Math.floor(i / side);
          if (residual > max[block]) max[block] = residual;
          squares[block] += residual * residual;
          numbers[block]++;
        }
      }
    for (let block = 0; block < count; block++) rms[block] = Math.sqrt(squares[block] / Math.max(1, numbers[block]));
  }
  const along = levels.map((level, n) => (n === 0 ? 0 : measureAlong(levels[n - 1], level)));
  return { side, blocks, low, high, levels: found, along };
}

/** Places at which it is measured how far residuals go together: every third voxel along each axis at most, and not many more than so many. */
const [leastApart, mostPlaces] = [3, 2 ** 18];

/** Shares of a voxel from one such place to the next: they fill the voxel evenly. Source: Roberts 2018, powers of the plastic number in three dimensions. */
export const betweenVoxels = [0.8191725134, 0.6710436067, 0.5497004779] as const;

/** How far residuals of a level go together that are one voxel apart along one of its axes. */
function measureAlong(fine: PyramidLevel, coarse: PyramidLevel): number {
  const [nx, ny, nz] = fine.dimensions;
  const apart = Math.max(leastApart, Math.ceil(Math.cbrt(fine.samples.length / mostPlaces)));
  const valueIn = ({ samples, dimensions }: PyramidLevel, at: Vector3, voxel: number): number =>
    interpolate(samples, dimensions, at.map((n, axis) => (n + 0.5) / voxel / dimensions[axis]) as unknown as Vector3);
  const residualAt = (at: Vector3): number => valueIn(fine, at, 1) - valueIn(coarse, at, 2);
  let [products, squares, number] = [0, 0, 0];
  // Up to the middles of the last voxels, from where the next place along an axis is still inside.
  for (let k = 0; k + 2 < nz; k += apart)
    for (let j = 0; j + 2 < ny; j += apart)
      for (let i = 0; i + 2 < nx; i += apart, number++) {
        const at = [i, j, k].map((n, axis) => n + ((number * betweenVoxels[axis]) % 1)) as unknown as Vector3;
        const next = at.map((n, axis) => (axis === number % 3 ? n + 1 : n)) as unknown as Vector3;
        const [here, there] = [residualAt(at), residualAt(next)];
        if (Number.isNaN(here + there)) continue;
        products += here * there;
        squares += (here ** 2 + there ** 2) / 2;
      }
  return squares > 0 ? Math.min(1, Math.max(0, products / squares)) : 0;
}

/**
 * Interpolates a level at the middles of a row of level 0's voxels, as rays do: voxels without data are left out, if the others make up half of
 * the weights. NaN where there is no data.
 */
function rowInterpolator(
  { dimensions: coarse, samples }: PyramidLevel,
  fine: Vector3,
  level: number,
): (j: number, k: number, into: Float64Array) => void {
  const [x, y, z] = fine.map((n, axis) => placesBetween(n, level, coarse[axis]));
  const [nx, ny] = coarse;
  const [sums, weights] = [new Float64Array(nx), new Float64Array(nx)];
  return (j, k, into) => {
    // First across the four rows around it, then along them.
    sums.fill(0);
    weights.fill(0);
    for (let corner = 0; corner < 4; corner++) {
      const [isUp, isBack] = [corner & 1, corner & 2];
      const weight = (isUp ? y.weight[j] : 1 - y.weight[j]) * (isBack ? z.weight[k] : 1 - z.weight[k]);
      const row = nx * ((isUp ? y.second[j] : y.first[j]) + ny * (isBack ? z.second[k] : z.first[k]));
      for (let i = 0; i < nx; i++) {
        const value = samples[row + i];
        if (value !== value) continue;
        sums[i] += weight * value;
        weights[i] += weight;
      }
    }
    for (let i = 0; i < into.length; i++) {
      const [first, second, w] = [x.first[i], x.second[i], x.weight[i]];
      const weight = (1 - w) * weights[first] + w * weights[second];
      into[i] = weight >= 0.5 ? ((1 - w) * sums[first] + w * sums[second]) / weight : NaN;
    }
  };
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
