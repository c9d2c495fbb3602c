import { expect } from '@esm-bundle/chai';
import type { Pixels } from '../../../src/optics/rays/between-pixels.ts';
import { listCoarseLevels } from '../../../src/quality/coarse-levels.ts';
import { keptError } from '../../../src/quality/error-estimate.ts';
import { addLoss, chooseSparing, spareRays } from '../../../src/quality/spare-rays.ts';
import { sparingTools } from '../../helpers/sparing-tools.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const side = 64;

/** A grey picture. */
function pictureOf(value: (x: number, y: number) => number): Pixels {
  const data = Uint8Array.from({ length: 4 * side ** 2 }, (_, i) => {
    const pixel = i >> 2;
    return i % 4 === 3 ? 255 : Math.round(value(pixel % side, Math.floor(pixel / side)));
  });
  return { data, width: side, height: side };
}

const ramp = pictureOf((x, y) => 20 + x + y);
/** Waves that a lattice of every fourth pixel just shows. */
const waves = pictureOf((x, y) => 128 + 60 * Math.sin(x / 3) * Math.sin(y / 4));
const random = randomNumbers(3);
const noise = pictureOf(() => 255 * random());
/** One pixel, which no ray of a lattice meets. */
const speck = pictureOf((x, y) => (x === 33 && y === 35 ? 255 : 40));

const exact = { rms: 0, p99: 0, p999: 0, max: 0 };

describe('the rays that a picture at rest spares', () => {
  it('are all but one in sixteen where it is a ramp, and nothing is lost there', () => {
    const { data, cast, rays } = spareRays(ramp, 8, sparingTools);
    expect(rays).to.equal((side / 4) ** 2);
    expect(cast.every((one) => one === 0)).to.equal(true);
    for (let y = 4; y < side - 4; y++)
      for (let x = 4; x < side - 4; x++)
        expect(data[4 * (y * side + x)], `${x} ${y}`).to.be.closeTo(ramp.data[4 * (y * side + x)], 1);
  });

  it('are none in noise, whose pixels keep their values', () => {
    const { data, cast } = spareRays(noise, 4, sparingTools);
    expect(cast.filter((one) => one === 0).length / side ** 2).to.be.below(0.01);
    cast.forEach((one, pixel) => {
      if (one) expect(data[4 * pixel]).to.equal(noise.data[4 * pixel]);
    });
  });

  it('are more the more error is allowed, and this error is kept', () => {
    const chosen = [0.1, 0.5, 1, 2, 4, 8, 16, 32].map((maxError) => {
      const loss = chooseSparing([waves], exact, maxError, sparingTools);
      expect(keptError(loss), `max-error ${maxError}`).to.be.at.most(maxError);
      return loss.sampling;
    });
    chosen.slice(1).forEach((one, i) => expect(one.share).to.be.at.most(chosen[i].share));
    expect(chosen[0].share, 'the finest').to.equal(1);
    expect(chosen.at(-1)!.share, 'the coarsest').to.be.below(0.2);
  });

  it('leave room for the error of steps', () => {
    const steps = { rms: 3.9, p99: 8, p999: 12, max: 20 };
    expect(chooseSparing([waves], steps, 4, sparingTools).sampling.share).to.equal(1);
    const both = addLoss(steps, chooseSparing([waves], steps, 8, sparingTools));
    expect(keptError(both)).to.be.within(3.9, 8);
  });

  it('may lose what is small, which the largest error says', () => {
    const { sampling, max } = chooseSparing([speck], exact, 8, sparingTools);
    expect(sampling.maxCurvature).to.be.above(0);
    expect(max).to.equal(215);
  });

  it('are none where nothing could be drawn', () => {
    expect(chooseSparing([], exact, 32, sparingTools).sampling.share).to.equal(1);
  });
});

describe('levels with no more steps than voxels', () => {
  it('come in order, and have at least 30 steps, but one per voxel', () => {
    const steps = listCoarseLevels(300).map((level) => level.steps);
    expect(steps).to.deep.equal([38, 50, 75, 100, 150, 213, 300]);
    expect(listCoarseLevels(60).map((level) => level.steps)).to.deep.equal([30, 43, 60]);
    expect(listCoarseLevels(20)).to.deep.equal([{ steps: 20, substeps: 1 }]);
  });
});
