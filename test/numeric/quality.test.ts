import { expect } from '@esm-bundle/chai';
import { chooseSteps } from '../../src/quality/choose-steps.ts';
import { estimateError } from '../../src/quality/error-estimate.ts';
import type { ErrorEstimate } from '../../src/quality/error-estimate.ts';
import { errorOfPlan, planFrame, workOfPlan } from '../../src/quality/plan-frame.ts';
import type { ErrorModel, FramePlan } from '../../src/quality/plan-frame.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { allRays } from '../../src/quality/adaptive-sampling.ts';
import { FrameTimer, fitTimes } from '../../src/quality/time-model.ts';
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
    it(`keeps the target with hardly more steps than necessary: error ${c} * steps^-${order} from ${begin}`, () => {
      const { measure, looked } = model(c, order);
      const { steps, estimate } = chooseSteps(measure, 1, { begin, least: 1, most: 4096 });
      const fewest = (c / Math.sqrt(1 - 0.04)) ** (1 / order);
      expect(estimate.rms).to.be.at.most(1);
      // It aims 15 % below the target, and stops where another probe would save less than a fifth.
      expect(steps / fewest).to.be.within(1, 1 / (0.85 * 0.8));
      expect(looked.length).to.be.at.most(6);
    });
  }

  it('that cannot be kept takes the maximum of steps', () => {
    const { measure } = model(1e6, 1);
    expect(chooseSteps(measure, 0.5, { begin: 100, least: 1, most: 1000 }).steps).to.equal(1000);
  });
});

describe('steps', () => {
  it('auto are one per voxel along the longest ray, by the finest axis', () => {
    const volume = syntheticVolume({ dimensions: [30, 40, 10], spacing: [1, 1, 5] });
    expect(autoSteps(volume.grid)).to.equal(Math.ceil(Math.hypot(30, 40, 50)));
    expect(stepLengthOf(volume.grid, autoSteps(volume.grid))).to.be.within(0.98, 1);
    expect(autoSteps(syntheticVolume({ dimensions: [2, 2, 2], spacing: [1, 1, 1e4] }).grid)).to.equal(2000);
  });
});

describe('the model of time', () => {
  const frame = (work: number, ms: number) => ({ work, ms });

  it('is fitted to what frames took: T = a + b w', () => {
    const fitted = fitTimes([1e6, 5e6, 2e7, 8e7].map((work) => frame(work, 3 + work * 3e-6)))!;
    expect(fitted.a).to.be.closeTo(3, 1e-9);
    expect(fitted.b).to.be.closeTo(3e-6, 1e-15);
  });

  it('takes all time to grow with the work where frames tell nothing else, and never a negative one', () => {
    expect(fitTimes([])).to.equal(null);
    expect(fitTimes([frame(1e6, 20), frame(1e6, 20)])).to.deep.equal({ a: 0, b: 2e-5 });
    const odd = fitTimes([frame(1e6, 30), frame(2e6, 20)])!;
    expect(odd.a).to.be.within(0, 16);
    expect(odd.b).to.be.above(0);
  });

  it('follows a device that gets slower within a few frames, and forgets', () => {
    const timer = new FrameTimer();
    for (let i = 0; i < 30; i++) timer.add(frame(1e6 * (1 + (i % 3)), 10 * (1 + (i % 3))));
    for (let i = 0; i < 8; i++) timer.add(frame(1e6 * (1 + (i % 3)), 30 * (1 + (i % 3))));
    expect(timer.model!.a + timer.model!.b * 2e6).to.be.closeTo(60, 0.1);
    timer.add(frame(0, 5));
    timer.forget();
    expect(timer.model).to.equal(null);
  });
});

describe('the model of time while all frames are alike', () => {
  it('keeps what every frame takes, from one of another size, for a while', () => {
    const timer = new FrameTimer();
    timer.add({ work: 1e5, ms: 12 });
    for (let i = 0; i < 40; i++) timer.add({ work: 2e6 * (1 + 0.01 * (i % 2)), ms: 30 });
    expect(timer.model!.a).to.be.closeTo(9.6, 0.1); // Not more than 0.8 of the shortest frame.
    for (let i = 0; i < 100; i++) timer.add({ work: 2e6, ms: 30 });
    expect(timer.model!.a, 'after very many').to.equal(0);
  });
});

describe('the plan of a frame', () => {
  const errors: ErrorModel = { steps: 100, error: 1, order: 2, atHalf: 6, sampling: [] };
  const full = { pixels: 500_000, steps: 100 };
  const timeOf = (a: number, b: number, plan: FramePlan): number => a + b * workOfPlan(plan, full.pixels);

  it('is everything where there is time for it', () => {
    expect(planFrame({ a: 1, b: 1e-7 }, errors, full, { budgetMs: 30 })).to.deep.equal({ scale: 1, steps: 100, sampling: allRays });
  });

  it('keeps its time, and no other plan that keeps it has a smaller error', () => {
    for (const b of [4e-7, 1e-6, 4e-6, 2e-5]) {
      for (const atHalf of [0.3, 6, 40]) {
        const model = { ...errors, atHalf };
        const plan = planFrame({ a: 2, b }, model, full, { budgetMs: 30 });
        const isLeast = plan.scale <= 0.25 && plan.steps === 12;
        if (!isLeast) expect(timeOf(2, b, plan)).to.be.at.most(30);
        for (const scale of [1, 0.7, 0.5, 0.35, 0.25]) {
          for (let steps = 12; steps <= 100; steps += 4) {
            const other = { scale, steps, sampling: allRays };
            if (timeOf(2, b, other) <= 30) expect(errorOfPlan(model, plan)).to.be.at.most(errorOfPlan(model, other) + 1e-9);
          }
        }
      }
    }
  });

  it('spends on pixels or on steps what the scene gains from', () => {
    const [sharp, banded] = [{ ...errors, atHalf: 30 }, { ...errors, error: 30, atHalf: 0.5 }].map((model) => planFrame({ a: 0, b: 3e-6 }, model, full, { budgetMs: 30 }));
    expect(sharp.scale).to.be.above(banded.scale);
    expect(sharp.steps).to.be.below(banded.steps);
  });

  it('keeps the size of the last frame where another one gains little', () => {
    const time = { a: 0, b: 3e-6 };
    const best = planFrame(time, errors, full, { budgetMs: 30 });
    const near = planFrame(time, errors, full, { budgetMs: 30.5, last: best });
    expect(near.scale).to.equal(best.scale);
    expect(planFrame({ a: 0, b: 1e-8 }, errors, full, { budgetMs: 30, last: { scale: 0.25, steps: 12, sampling: allRays } }).scale).to.equal(1);
  });

  it('is the smallest plan if no time is enough', () => {
    const least = (pixels: number): FramePlan => planFrame({ a: 50, b: 1 }, errors, { pixels, steps: 100 }, { budgetMs: 30 });
    expect(least(256 ** 2)).to.deep.equal({ scale: 0.25, steps: 12, sampling: allRays });
    expect(least(800 ** 2), 'of a large picture a smaller share').to.deep.equal({ scale: 0.16, steps: 12, sampling: allRays });
    expect(least(4000 ** 2).scale).to.equal(0.125);
    const soon = planFrame({ a: 22, b: 8 / (800 ** 2 * 0.25 ** 2 * 16) }, errors, { pixels: 800 ** 2, steps: 100 }, { budgetMs: 28 });
    expect(soon, 'a little late is better than small').to.deep.equal({ scale: 0.25, steps: 12, sampling: allRays });
    expect(planFrame({ a: 50, b: 1 }, errors, { pixels: 10, steps: 3 }, { budgetMs: 30 })).to.deep.equal({ scale: 0.25, steps: 3, sampling: allRays });
  });
});
