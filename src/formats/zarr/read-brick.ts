import { brickHalo, brickReach, brickSide, slotSide } from '../../bricks/brick-data.ts';
import type { BrickSamples } from '../../bricks/brick-data.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { allocateLike } from '../../volume/samples.ts';
import type { Samples } from '../../volume/samples.ts';
import type { ZarrBrickLevel } from './brick-levels.ts';
import type { BrickNumbers } from './brick-numbers.ts';
import type { ChunkSource } from './chunk-source.ts';
import { asNumbers, copyChunk } from './copy-chunk.ts';
import { listChunks } from './list-chunks.ts';
import type { ArrayBox } from './list-chunks.ts';
import { bitsOf } from './read-box.ts';

interface BrickReading {
  readonly brick: Brick;
  /** See `BrickStore.read`. */
  readonly isAlone: boolean;
  /** The index along each axis that is none of space. */
  readonly at: readonly number[];
  readonly space: ArrayBox['axes'];
  readonly numbers: BrickNumbers;
  readonly signal: AbortSignal;
}

/** Reads a brick with what interpolation up to its faces needs, as far as the level goes, or alone, and repeats its ends. */
export async function readBrick(
  source: ChunkSource,
  { level: { array, dimensions: ends } }: ZarrBrickLevel,
  { brick, isAlone, at, space, numbers, signal }: BrickReading,
): Promise<BrickSamples> {
  const reach = isAlone ? 0 : brickReach;
  const first = brick.at.map((n) => Math.max(0, n * brickSide - reach)) as unknown as Vector3;
  const dimensions = brick.at.map((n, axis) => Math.min(ends[axis], (n + 1) * brickSide + reach) - first[axis]);
  const box: ArrayBox = { axes: space, first, dimensions: dimensions as unknown as Vector3, at };
  const places = listChunks(array, box);
  const chunks = await source.read(array, places, signal);
  const size = array.type.bytesPerSample;
  const bytes = new Uint8Array(dimensions.reduce((product, n) => product * n, size));
  const output = asNumbers(bytes, size);
  if (array.fill !== 0) output.fill(bitsOf(array) as never);
  for (const [i, chunk] of chunks.entries()) if (chunk) copyChunk(chunk, places[i], { array, box, output });
  const origin = brick.at.map((n, axis) => n * brickSide - brickHalo - first[axis]);
  return measure(repeatEnds(numbers.store(bytes), box.dimensions, origin));
}

/** @param origin - the place of the first voxel of the brick with its halo among the samples; those outside of them are like the nearest one */
function repeatEnds(samples: Samples, [nx, ny, nz]: Vector3, [x, y, z]: readonly number[]): Samples {
  if (nx === slotSide && ny === slotSide && nz === slotSide) return samples;
  const clamp = (n: number, count: number): number => Math.min(count - 1, Math.max(0, n));
  const columns = Int32Array.from({ length: slotSide }, (_, i) => clamp(x + i, nx));
  const repeated = allocateLike(samples, slotSide ** 3);
  for (let k = 0, to = 0; k < slotSide; k++)
    for (let j = 0; j < slotSide; j++) {
      const row = nx * (clamp(y + j, ny) + ny * clamp(z + k, nz));
      for (const column of columns) repeated[to++] = samples[row + column];
    }
  return repeated;
}

function measure(samples: Samples): BrickSamples {
  let [low, high, count] = [Infinity, -Infinity, 0];
  for (const value of samples) {
    if (value < low) low = value;
    if (value > high) high = value;
    if (value === value) count++;
  }
  return { samples, low, high, hasNoData: count < samples.length };
}
