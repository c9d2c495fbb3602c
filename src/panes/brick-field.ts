import { brickHalo, brickSide } from '../bricks/brick-data.ts';
import { slotDimensions } from '../bricks/brick-layout.ts';
import type { GridFrame } from '../volume/grid.ts';
import { invertAffine, multiply } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/samples.ts';
import { linearSampler, nearestSampler } from './sample-at.ts';
import type { SampleAt, SampledBlock } from './sample-at.ts';

/** A level of a pyramid, of which some bricks are there. */
export interface BrickedLevel extends GridFrame {
  /** Along each axis. */
  readonly bricks: Vector3;
  /** The voxels of a brick with its halo; undefined where it has not come. */
  samplesOf(at: Vector3): Samples | undefined;
}

/** What stands in where no brick has come. */
export interface CoarseVoxels extends SampledBlock {
  readonly indexToWorld: Matrix4;
}

/** Reads a level at its own indices, whole numbers at the middles of voxels. */
export function brickSampler(level: BrickedLevel, coarse: CoarseVoxels, isNearest: boolean): SampleAt {
  const { dimensions, bricks, samplesOf } = level;
  const [nx, ny, nz] = dimensions;
  const sampler = isNearest ? nearestSampler : linearSampler;
  const standIn = sampler(coarse);
  const m = multiply(invertAffine(coarse.indexToWorld)!, level.indexToWorld);
  // The volume may end half a voxel before the level does.
  const [lastX, lastY, lastZ] = coarse.dimensions.map((n) => n - 0.5 - 1e-9);
  const inside = (x: number, last: number): number => Math.min(last, Math.max(-0.5, x));
  const known = new Map<number, SampleAt | null>();
  let [last, read]: [number, SampleAt | null] = [-1, null];
  return (x, y, z) => {
    if (!(x >= -0.5 && x <= nx - 0.5 && y >= -0.5 && y <= ny - 0.5 && z >= -0.5 && z <= nz - 0.5)) return NaN;
    const i = Math.min(bricks[0] - 1, Math.floor((x + 0.5) / brickSide));
    const j = Math.min(bricks[1] - 1, Math.floor((y + 0.5) / brickSide));
    const k = Math.min(bricks[2] - 1, Math.floor((z + 0.5) / brickSide));
    const number = i + bricks[0] * (j + bricks[1] * k);
    if (number !== last) {
      last = number;
      const before = known.get(number);
      if (before === undefined) {
        const samples = samplesOf([i, j, k]);
        read = samples
          ? sampler({ samples, dimensions: slotDimensions, hasNoData: samples instanceof Float32Array })
          : null;
        known.set(number, read);
      } else read = before;
    }
    if (read) return read(x - brickSide * i + brickHalo, y - brickSide * j + brickHalo, z - brickSide * k + brickHalo);
    return standIn(
      inside(m[0] * x + m[1] * y + m[2] * z + m[3], lastX),
      inside(m[4] * x + m[5] * y + m[6] * z + m[7], lastY),
      inside(m[8] * x + m[9] * y + m[10] * z + m[11], lastZ),
    );
  };
}
