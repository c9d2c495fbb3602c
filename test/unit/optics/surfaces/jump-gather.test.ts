// Values at which a volume becomes opaque at once, where values jump from one level of bricks to another.
import { expect } from '@esm-bundle/chai';
import type { Path, Seen, Segment } from '../../../../src/optics/rays/ray-stages.ts';
import { jumpGather } from '../../../../src/optics/surfaces/jump-gather.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';
import type { Premultiplied } from '../../../../src/optics/transfer/transfer-function.ts';

/** Opaque from 50 on; red is the value. Extinction of a voxel: light goes an eighth of a voxel deep. */
const extinction = 8;

/** As the tables of the package see a piece: from the means over its values, so that none of them hides another one. */
function seeSegment({ front, back, span }: Segment): Premultiplied {
  const [low, high] = [Math.min(front.value, back.value), Math.max(front.value, back.value)];
  const share = high > low ? Math.max(0, high - Math.max(50, low)) / (high - low) : Number(low >= 50);
  const mean = extinction * share;
  return attenuate([mean * 0.5 * (Math.max(50, low) + high), 0, 0, mean], span);
}

/** The value that shows at the end of a way of such a length on which values change evenly from 0 to 150: where each hides those behind it. */
function showEvenly(length: number): number {
  const slices = 1e5;
  let [red, through] = [0, 1];
  for (let n = 0; n < slices; n++) {
    const value = (150 * (n + 0.5)) / slices;
    const alpha = value < 50 ? 0 : -Math.expm1((-extinction * length) / slices);
    red += through * alpha * value;
    through *= 1 - alpha;
  }
  return red + through * 150;
}

/** Air up to the middle of the way of one voxel, matter of 150 from there on. */
const valueAt = (along: number): number => (along < 0.5 ? 0 : 150);

/** The value that shows at the end of such ways. */
function showJump(jumpBetween?: Path['jumpBetween']): number {
  const path: Path = {
    total: 4,
    pieces: [[0, 4]],
    sampleAt: (along) => ({ value: valueAt(along), valid: true }),
    jumpBetween,
  };
  const gathering = jumpGather([50], 1)({ seeSegment, step: 1 } as Seen);
  for (let from = 0; from < 4; from++)
    gathering.addPiece!({ from, to: from + 1, front: path.sampleAt(from), back: path.sampleAt(from + 1) }, path);
  const [red, , , alpha] = gathering.finish(path);
  expect(alpha).to.be.above(0.99);
  return red / alpha;
}

describe('Values at which a volume is opaque at once', () => {
  it('show near themselves where the value jumps between two levels of bricks, and not what lies behind the jump', () => {
    const isAcross = (from: number, to: number): boolean => valueAt(from) !== valueAt(to);
    expect(showJump(), 'a jump in the data shows what lies behind it').to.be.above(140);
    for (const voxels of [0.5, 1, 2, 4]) {
      const shown = showJump((from, to) => (isAcross(from, to) ? voxels : 0));
      expect(shown, `voxels of ${voxels}`).to.be.closeTo(showEvenly(voxels), 2);
    }
    expect(showEvenly(4)).to.be.below(60);
  });

  it('are as they were where no voxel changes', () => {
    expect(showJump(() => 0)).to.equal(showJump());
  });
});
