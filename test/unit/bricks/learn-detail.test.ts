import { expect } from '@esm-bundle/chai';
import { learnDetail, measureOctaves } from '../../../src/bricks/learn-detail.ts';
import { buildPyramid } from '../../../src/bricks/pyramid.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const edge = 64;
const side = 16;

function learnFrom(samples: Float32Array<ArrayBuffer>) {
  const pyramid = buildPyramid({ dimensions: [edge, edge, edge], samples }, side);
  const learnt = learnDetail(pyramid, measureOctaves(pyramid), [edge, edge, edge], [0, 1]);
  return { learnt, table: measureResiduals(pyramid, side) };
}

/** Rough where x is small, else smooth. */
function roughAside(): Float32Array<ArrayBuffer> {
  const random = randomNumbers(9);
  return new Float32Array(edge ** 3).map((_, n) => (n % edge < 32 ? random() : 0.5 + 0.1 * Math.sin(n / 4096 / 6)));
}

describe('Detail of a pyramid that says nothing of it', () => {
  it('is learnt from the coarsest level alone: more where that level is rough', () => {
    const { learnt } = learnFrom(roughAside());
    learnt.update(new Uint8Array(64).fill(2));
    // The third cell along x is smooth, the first one is rough.
    expect(learnt.rms(0, 2)).to.be.above(2 * learnt.rms(3, 2));
    expect(learnt.rms(0, 1)).to.be.below(learnt.rms(0, 2));
  });

  it('is learnt from finer bricks that have come: within a factor of 1.5 of what is true in those that have not', () => {
    const { learnt, table } = learnFrom(roughAside());
    const levelOf = new Uint8Array(64).fill(2);
    // The finest bricks of one rough cell, the next coarser ones of half of the cells.
    levelOf.fill(1, 0, 32);
    levelOf[0] = 0;
    learnt.update(levelOf);
    const cell = 36;
    expect(learnt.rms(cell, 2) / table.levels[2].rms[cell]).to.be.within(1 / 1.5, 1.5);
    expect(learnt.rms(16, 1) / table.levels[1].rms[16]).to.be.within(1 / 1.5, 1.5);
  });

  it('is none where all voxels are equal, and the values are always numbers', () => {
    const { learnt } = learnFrom(new Float32Array(edge ** 3).fill(0.25));
    for (const level of [2, 1, 0]) {
      learnt.update(new Uint8Array(64).fill(level));
      for (let at = 1; at <= level; at++) {
        expect(learnt.rms(5, at)).to.equal(0);
        expect(learnt.max(5, at)).to.equal(0);
      }
    }
  });

  it('reads nothing of levels that are not there', () => {
    const pyramid = buildPyramid({ dimensions: [edge, edge, edge], samples: roughAside() }, side);
    const octaves = measureOctaves(pyramid);
    const unknown = octaves.map((octave, n) =>
      n < 2 ? { rms: octave.rms.map(() => NaN), max: octave.max.map(() => NaN) } : octave,
    );
    const [all, few] = [octaves, unknown].map((one) => learnDetail(pyramid, one, [edge, edge, edge], [0, 1]));
    const levelOf = new Uint8Array(64).fill(2);
    all.update(levelOf);
    few.update(levelOf);
    for (let cell = 0; cell < 64; cell++) expect(few.rms(cell, 2)).to.equal(all.rms(cell, 2));
  });
});
