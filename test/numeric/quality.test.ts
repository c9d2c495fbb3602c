import { expect } from '@esm-bundle/chai';
import { chooseSteps } from '../../src/quality/choose-steps.ts';
import { estimateError } from '../../src/quality/error-estimate.ts';
import type { ErrorEstimate } from '../../src/quality/error-estimate.ts';
import { autoSteps, movingSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { randomNumbers, syntheticVolume } from '../helpers/synthetic.ts';

/** A picture whose error is c * steps^-order in every channel, with changing signs. */
function picture(steps: number, order: number, scale = 0.5): Float32Array {
  const random = randomNumbers(50);
  return Float32Array.from({ length: 4000 }, () => {
    const limit = random();
    return limit + (random() - 0.5) * scale * steps ** -order;
  });
}

describe('the estimate of a picture\'s error', () => {
  for (const order of [1, 2]) {
    it(`finds order ${order} and the distance to the limit, which it never saw`, () => {
      const estimate = estimateError([picture(4, order), picture(8, order), picture(16, order)]);
      expect(estimate.order).to.be.closeTo(order, 0.05);
      // Root mean square of a uniform distribution of width scale / steps^order.
      const expected = (255 * 0.5 * 4 ** -order) / Math.sqrt(12);
      expect(estimate.discretization / expected).to.be.closeTo(1, 0.05);
      expect(estimate.p99 / (expected * Math.sqrt(3))).to.be.closeTo(1, 0.15);
    });
  }

  it('of a converged picture is the rounding to 8 bits, 1 / sqrt(12)', () => {
    const same = picture(1e6, 2);
    const estimate = estimateError([same, same, same]);
    expect(estimate.discretization).to.equal(0);
    expect(estimate.rms).to.be.closeTo(1 / Math.sqrt(12), 0.02);
    expect(estimate.p99).to.be.at.most(0.501);
  });

  it('of nothing is nothing', () => {
    const empty = new Float32Array(400);
    expect(estimateError([empty, empty, empty])).to.deep.include({ rms: 0, p99: 0, discretization: 0 });
  });
});

describe('the choice of steps', () => {
  const model = (c: number, order: number) => {
    const looked: number[] = [];
    const measure = (steps: number): ErrorEstimate => {
      looked.push(steps);
      const discretization = c * steps ** -order;
      return { order, discretization, rms: Math.hypot(discretization, 0.2), p99: 3 * discretization };
    };
    return { measure, looked };
  };

  for (const [c, order, begin] of [[3000, 2, 300], [20000, 2, 40], [60, 1, 200], [500, 1.5, 1000]] as const) {
    it(`keeps the wish with hardly more steps than it takes: error ${c} * steps^-${order} from ${begin}`, () => {
      const { measure, looked } = model(c, order);
      const { steps, estimate } = chooseSteps(measure, 1, { begin, most: 4096 });
      const fewest = (c / Math.sqrt(1 - 0.04)) ** (1 / order);
      expect(estimate.rms).to.be.at.most(1);
      // It aims 15 % below the wish, and leaves alone what looking again would make less than a fifth cheaper.
      expect(steps / fewest).to.be.within(1, 1 / (0.85 * 0.8));
      expect(looked.length).to.be.at.most(6);
    });
  }

  it('that can not be kept takes the most steps', () => {
    const { measure } = model(1e6, 1);
    expect(chooseSteps(measure, 0.5, { begin: 100, most: 1000 }).steps).to.equal(1000);
  });
});

describe('steps', () => {
  it('auto are one a voxel along the longest ray, by the finest axis', () => {
    const volume = syntheticVolume({ dimensions: [30, 40, 10], spacing: [1, 1, 5] });
    expect(autoSteps(volume)).to.equal(Math.ceil(Math.hypot(30, 40, 50)));
    expect(stepLengthOf(volume, autoSteps(volume))).to.be.within(0.98, 1);
    expect(autoSteps(syntheticVolume({ dimensions: [2, 2, 2], spacing: [1, 1, 1e4] }))).to.equal(2000);
  });

  it('while moving follow the time that the last frame took, down at once and up by halves', () => {
    expect(movingSteps({ steps: 100, frameMs: 60 }, 30, 400)).to.equal(50);
    expect(movingSteps({ steps: 100, frameMs: 15 }, 30, 400)).to.equal(150);
    expect(movingSteps({ steps: 100, frameMs: 1 }, 30, 400)).to.equal(400);
    expect(movingSteps({ steps: 100, frameMs: 9999 }, 30, 400)).to.equal(32);
    expect(movingSteps({ steps: 5, frameMs: 9999 }, 30, 5)).to.equal(5);
  });
});
