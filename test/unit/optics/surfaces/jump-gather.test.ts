// Values at which a volume becomes opaque at once, where values jump from one level of bricks to another.
import { expect } from '@esm-bundle/chai';
import type { Path, Seen, Segment } from '../../../../src/optics/rays/ray-stages.ts';
import { jumpGather } from '../../../../src/optics/surfaces/jump-gather.ts';
import type { Premultiplied } from '../../../../src/optics/transfer/transfer-function.ts';

/** Opaque from 50 on; red is the value. Extinction of a voxel: light goes half a voxel deep. */
const extinction = 8;
const slices = 400;

function seeSegment({ front, back, span }: Segment): Premultiplied {
  let [red, through] = [0, 1];
  for (let n = 0; n < slices; n++) {
    const value = front.value + ((n + 0.5) / slices) * (back.value - front.value);
    const alpha = value < 50 ? 0 : -Math.expm1((-extinction * span) / slices);
    red += through * alpha * value;
    through *= 1 - alpha;
  }
  return [red, 0, 0, 1 - through];
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
    const shown = [1, 2, 4].map((voxels) => showJump((from, to) => (isAcross(from, to) ? voxels : 0)));
    expect(shown[2]).to.be.below(60);
    expect(shown[0] > shown[1] && shown[1] > shown[2], 'less, the larger the voxels').to.equal(true);
  });

  it('are as they were where no voxel changes', () => {
    expect(showJump(() => 0)).to.equal(showJump());
  });
});
