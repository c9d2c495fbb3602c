import { expect } from '@esm-bundle/chai';
import { maxSubsteps } from '../../../src/optics/rays/segment.ts';
import { allSubsteps, wholeSteps } from '../../../src/optics/cells/substeps.ts';
import { chooseLevel } from '../../../src/quality/choose-level.ts';
import { estimateError, keptError } from '../../../src/quality/error-estimate.ts';
import type { ErrorEstimate } from '../../../src/quality/error-estimate.ts';
import { workOfFrame } from '../../../src/quality/frame-quality.ts';
import { errorOfFrame, chooseFrameQuality } from '../../../src/quality/choose-frame-quality.ts';
import type { ErrorModel, FrameQuality } from '../../../src/quality/frame-quality.ts';
import { cutNowhere, findFirst, listCoarseLevels } from '../../../src/quality/coarse-levels.ts';
import { cutsOfLevels, cutSteps, listLevels } from '../../../src/quality/levels.ts';
import { powerOfSteps } from '../../../src/optics/transfer/power-of-steps.ts';
import { autoSteps, maxAutoSteps, stepLengthOf, voxelsAlong } from '../../../src/quality/steps.ts';
import { allRays } from '../../../src/quality/sampling-outcome.ts';
import { FrameTimer, fitTimes } from '../../../src/quality/time-model.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

/** A picture whose error is c * steps^-order in every channel, with changing signs. */
function picture(steps: number, order: number, scale = 0.5): Float32Array {
  const random = randomNumbers(50);
  return Float32Array.from({ length: 4000 }, () => {
    const limit = random();
    return limit + (random() - 0.5) * scale * steps ** -order;
  });
}

describe("the estimate of a picture's error", () => {
  for (const order of [1, 2]) {
    it(`finds order ${order} and the distance to the limit, which it never saw`, () => {
      const estimate = estimateError({
        shown: picture(4, order),
        middle: picture(8, order),
        fine: picture(16, order),
        isEven: true,
      });
      expect(estimate.order).to.be.closeTo(order, 0.05);
      // Root mean square of a uniform distribution of width scale / steps^order.
      const expected = (255 * 0.5 * 4 ** -order) / Math.sqrt(12);
      expect(estimate.discretization / expected).to.be.closeTo(1, 0.05);
      expect(estimate.p99 / (expected * Math.sqrt(3))).to.be.closeTo(1, 0.15);
    });
  }

  it('of a converged picture is the rounding to 8 bits, 1 / sqrt(12)', () => {
    const same = picture(1e6, 2);
    const estimate = estimateError({ shown: same, middle: same, fine: same, isEven: true });
    expect(estimate.discretization).to.equal(0);
    expect(estimate.rms).to.be.closeTo(1 / Math.sqrt(12), 0.02);
    expect(estimate.p99).to.be.at.most(0.501);
  });

  it('of nothing is nothing', () => {
    const empty = new Float32Array(400);
    expect(estimateError({ shown: empty, middle: empty, fine: empty, isEven: true })).to.deep.include({
      rms: 0,
      p99: 0,
      max: 0,
      discretization: 0,
      covered: 0,
    });
  });
});

describe('the estimate over the pixels that the volume covers', () => {
  /** A tenth of the picture is covered, and off by `off` with the first steps, a quarter and a sixteenth of it with finer ones. */
  const sparse = (off: number, share: number): ErrorEstimate => {
    const pictureOf = (error: number): Float32Array =>
      Float32Array.from({ length: 400_000 }, (_, i) =>
        i % 40 < 4 ? 0.5 + (i < 400_000 * share ? error / 255 : 0) : 0,
      );
    return estimateError({
      shown: pictureOf(off),
      middle: pictureOf(off / 4),
      fine: pictureOf(off / 16),
      isEven: true,
    });
  };

  it('does not count what lies around it', () => {
    const { rms, covered, coverage } = sparse(6, 1);
    expect([covered, coverage]).to.deep.equal([10_000, 0.1]);
    expect(rms).to.be.closeTo(6, 0.5);
  });

  it('does not count what rounds to nothing, as around a cloud that fades, but where there is nothing else', () => {
    /** A tenth of the pixels is off by 8 with the first steps; of the others 8 bits show nothing. */
    const cloud = (color: number, error: number): Float32Array =>
      Float32Array.from({ length: 40_000 }, (_, i) => (i % 40 < 4 ? color + error / 255 : 0.4 / 255));
    const estimate = (color: number, off: number): ErrorEstimate =>
      estimateError({
        shown: cloud(color, off),
        middle: cloud(color, off / 4),
        fine: cloud(color, off / 16),
        isEven: true,
      });
    expect(estimate(0.5, 8).covered).to.equal(1000);
    expect(estimate(0.5, 8).rms).to.be.closeTo(8, 0.6);
    expect(estimate(0, 8).covered, 'what one of the pictures shows counts').to.equal(1000);
    expect(estimate(0.4 / 255, 0).coverage).to.equal(1);
    expect(estimate(0.4 / 255, 0).covered, 'nobody sees any of it').to.equal(0);
    expect(estimate(0.4 / 255, 0).rms).to.be.closeTo(0.4, 1e-3);
  });

  it('lets one pixel in a thousand be off by eight times as much, and no more', () => {
    expect(keptError(sparse(40, 0.004)), 'four pixels in a thousand').to.be.closeTo(5, 0.2);
    expect(keptError(sparse(40, 0.0009))).to.be.below(1.4);
  });

  it('is no less than it, with 95 % confidence, where few of many pixels may be off by much and some are probed', () => {
    const random = randomNumbers(3);
    // One pixel in 667 is off by 12: E is 1.5. Samples of 500 to 8,000.
    const isKeptBy = (count: number): boolean => {
      const wrong = Float32Array.from({ length: count }, () => (random() < 0.0015 ? 12 / 255 : 0));
      const pictureOf = (share: number): Float32Array =>
        Float32Array.from({ length: 4 * count }, (_, i) => 0.5 + share * wrong[i >> 2]);
      return (
        keptError(
          estimateError({
            shown: pictureOf(1),
            middle: pictureOf(0.25),
            fine: pictureOf(0.06),
            isEven: true,
            doubt: 0.05,
          }),
        ) <= 1
      );
    };
    const wrongly = (count: number): number =>
      Array.from({ length: 300 }, () => Number(isKeptBy(count))).reduce((a, b) => a + b) / 300;
    // By the plain percentile it was kept wrongly in 18 to 47 % of the cases.
    for (const count of [3000, 5000, 8000]) expect(wrongly(count), `of ${count}`).to.be.at.most(0.05);
    expect(wrongly(500), 'which are too few').to.be.above(0.3);
  });

  it('adds errors of jumps as independent ones: of half an order, each pixel being off at some steps', () => {
    const random = randomNumbers(3);
    const places = Array.from({ length: 20_000 }, () => random());
    // A pixel is wrong where its own place lies within the step.
    const pictureOf = (step: number): Float32Array =>
      Float32Array.from({ length: 80_000 }, (_, i) => (places[i >> 2] < step ? 1 : 0.5));
    const estimate = estimateError({
      shown: pictureOf(0.08),
      middle: pictureOf(0.04),
      fine: pictureOf(0.02),
      isEven: true,
    });
    expect(estimate.rms / (127.5 * Math.sqrt(0.08))).to.be.within(0.7, 1.4);
  });
});

describe('the choice of a level', () => {
  const estimateOf = (rms: number, p999 = 0): ErrorEstimate => ({
    rms,
    p999,
    p99: 0,
    max: p999,
    order: 2,
    discretization: rms,
    coverage: 1,
    covered: 1000,
  });
  const levels = listLevels(300);
  const choose = async (
    errors: readonly number[],
    maxError: number,
  ): Promise<{ chosen: number; isKept: boolean; asked: number[] }> => {
    const asked: number[] = [];
    const { level, isKept } = (await chooseLevel(
      levels,
      async (one) => {
        asked.push(levels.indexOf(one));
        return estimateOf(errors[levels.indexOf(one)]);
      },
      maxError,
    ))!;
    return { chosen: levels.indexOf(level), isKept, asked };
  };

  it('has no level below one step a voxel', () => {
    expect(levels[0]).to.deep.equal({ steps: 300, substeps: 1 });
    expect(levels.at(-1)).to.deep.equal({ steps: 1200, substeps: maxSubsteps });
    expect(
      listLevels(300, false).map(({ steps }) => steps),
      'where substeps make no difference',
    ).to.deep.equal([300, 600, 1200]);
    expect(Math.max(...listLevels(3000).map(({ steps }) => steps))).to.equal(maxAutoSteps);
  });

  it('may be one finer where voxels are few', () => {
    expect(listLevels(100).at(-2)).to.deep.equal({ steps: 400, substeps: maxSubsteps });
    expect(listLevels(100).at(-1)).to.deep.equal({ steps: 800, substeps: maxSubsteps });
    expect(listLevels(100, false).map(({ steps }) => steps)).to.deep.equal([100, 200, 400, 800]);
  });

  it('is the first that keeps the target, by its few worst pixels too', async () => {
    expect(await choose([0.9, 0.2, 0.1, 0, 0, 0], 1)).to.deep.equal({ chosen: 0, isKept: true, asked: [0] });
    expect(await choose([3, 1.4, 0.7, 0.3, 0, 0], 1)).to.deep.equal({ chosen: 2, isKept: true, asked: [0, 1, 2] });
    const { level } = (await chooseLevel(levels, async (one) => estimateOf(0.1, 10 / (levels.indexOf(one) + 1)), 1))!;
    expect(levels.indexOf(level)).to.equal(1);
  });

  it('leaves out levels that could not be enough', async () => {
    expect((await choose([20, 9, 4, 0.9, 0, 0], 1)).asked).to.deep.equal([0, 2, 3]);
  });

  it('is given up where the view is not wanted any more', async () => {
    expect(await chooseLevel(levels, async (one) => (one === levels[0] ? estimateOf(3) : null), 1)).to.equal(null);
  });

  it('that cannot be kept is the last that still gains, and says so', async () => {
    expect(await choose([50, 40, 30, 20, 14, 9], 1)).to.deep.include({ chosen: 5, isKept: false });
    expect(await choose([50, 49, 48, 48, 48, 48], 20)).to.deep.include({ chosen: 0, isKept: false });
  });

  it('is finer where that helps in the mean, though the few worst pixels stay as wrong as can be', async () => {
    const chosen = async (means: readonly number[], worst: readonly number[]): Promise<unknown> => {
      const { level, isKept } = (await chooseLevel(
        levels,
        async (one) => estimateOf(means[levels.indexOf(one)], worst[levels.indexOf(one)]),
        1,
      ))!;
      return [levels.indexOf(level), isKept];
    };
    expect(await chosen([16, 12, 8, 6, 4, 3.9], Array(6).fill(255))).to.deep.equal([4, false]);
    // As measured of two surfaces in Marschner and Lobb's signal.
    expect(await chosen([16.4, 16.4, 16.4, 16.4, 15.4, 9.6], [163, 163, 163, 163, 255, 255])).to.deep.equal([5, false]);
  });
});

describe('steps', () => {
  it('auto are one per voxel along the longest ray, by the finest axis', () => {
    const volume = syntheticVolume({ dimensions: [30, 40, 10], spacing: [1, 1, 5] });
    expect(autoSteps(volume.grid)).to.equal(Math.ceil(Math.hypot(30, 40, 50)));
    expect(stepLengthOf(volume.grid, autoSteps(volume.grid))).to.be.within(0.98, 1);
    expect(autoSteps(syntheticVolume({ dimensions: [2, 2, 2], spacing: [1, 1, 1e4] }).grid)).to.equal(maxAutoSteps);
  });

  it('that are longer than a voxel, as there may be no more of them, are cut into the more', () => {
    const { grid } = syntheticVolume({ dimensions: [40, 40, 40], spacing: [0.005, 1, 1] });
    const [one, max] = [autoSteps(grid), voxelsAlong(grid)];
    expect(one).to.equal(maxAutoSteps);
    expect(max / one).to.be.within(2.7, 2.8);
    expect(cutSteps({ steps: one, substeps: 1 }, max, 1).voxelsPerStep).to.equal(max / one);
  });

  it('are cut by `max-error` alike in a picture and in those it is compared with; steps of an author by the values at their ends', () => {
    const level = { steps: 200, substeps: 2 };
    const auto = cutsOfLevels(100, 4);
    expect(auto.own(level)).to.deep.equal(cutSteps(level, 100, 4));
    expect(auto.reference(level)).to.deep.equal(auto.own(level));
    expect(cutsOfLevels(100, 0.5).own(level).mayLose).to.be.below(auto.own(level).mayLose);
    // Steps longer than a voxel: from an error of 2 on, and where the values at their ends do not cut them.
    const long = { name: 'long', defines: {}, count: '' };
    const takesLong = (maxError: number | null, substeps: number): boolean =>
      cutsOfLevels(100, maxError, long).own({ steps: 100, substeps }).long === long;
    expect([takesLong(2, 1), takesLong(1.9, 1), takesLong(8, 8), takesLong(null, 1)]).to.deep.equal([
      true,
      false,
      false,
      false,
    ]);
    const few = { steps: 50, substeps: 1 };
    expect(powerOfSteps(cutNowhere.own(few).voxelsPerStep) + 3, 'the power of the finest code').to.be.below(0);
    expect(cutNowhere.own(few).findDetail, 'cells whose detail is needed').to.equal(undefined);
    const given = cutsOfLevels(100, null);
    expect(given.own(level)).to.deep.equal({ ...allSubsteps, max: 2 });
    expect(given.reference(level)).to.deep.equal(cutSteps(level, 100, 1));
  });
});

describe('levels where small things may be lost', () => {
  it('are found by halves: the first that passes, with at most three of seven measured', async () => {
    const levels = listCoarseLevels(360);
    for (const [first, { steps }] of [...levels.entries(), [7, { steps: Infinity }] as const]) {
      const measured: number[] = [];
      const found = await findFirst(
        levels,
        async (level) => (measured.push(level.steps), level.steps),
        (n) => n >= steps,
      );
      expect(found, `the first is ${first}`).to.deep.equal(
        first < 7 ? { level: levels[first], measured: levels[first].steps } : null,
      );
      expect(measured.length).to.be.at.most(3);
    }
    expect(
      await findFirst(
        levels,
        async () => null,
        () => true,
      ),
      'no longer needed',
    ).to.equal(null);
  });
});

describe('the model of time', () => {
  const frame = (work: number, ms: number) => ({ work, ms });

  it('is fitted to what frames took: T = a + b w', () => {
    const fitted = fitTimes([1e6, 5e6, 2e7, 8e7].map((work) => frame(work, 3 + work * 3e-6)))!;
    expect(fitted.a).to.be.closeTo(3, 1e-9);
    expect(fitted.b).to.be.closeTo(3e-6, 1e-15);
  });

  it('takes all time to grow with the work where frames show nothing else, and never a negative one', () => {
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
  const timeOf = (a: number, b: number, plan: FrameQuality): number => a + b * workOfFrame(plan, full.pixels);

  it('is everything where there is time for it', () => {
    expect(chooseFrameQuality({ a: 1, b: 1e-7 }, errors, full, { budgetMs: 30 })).to.deep.equal({
      scale: 1,
      steps: 100,
      substeps: wholeSteps,
      sampling: allRays,
    });
  });

  it('keeps its time, and no other plan that keeps it has a smaller error', () => {
    for (const b of [4e-7, 1e-6, 4e-6, 2e-5]) {
      for (const atHalf of [0.3, 6, 40]) {
        const model = { ...errors, atHalf };
        const plan = chooseFrameQuality({ a: 2, b }, model, full, { budgetMs: 30 });
        expect(plan.steps, 'enough for what is thin').to.be.at.least(60);
        expect(timeOf(2, b, plan)).to.be.at.most(30 + 1e-9);
        for (const scale of [1, 0.7, 0.5, 0.35, 0.25, 0.2, 0.14]) {
          for (let steps = 60; steps <= 100; steps += 4) {
            const other = { scale, steps, substeps: wholeSteps, sampling: allRays };
            if (timeOf(2, b, other) <= 30)
              expect(errorOfFrame(model, plan)).to.be.at.most(errorOfFrame(model, other) + 1e-9);
          }
        }
      }
    }
  });

  it('spends on pixels or on steps what the scene gains from', () => {
    const [sharp, banded] = [
      { ...errors, atHalf: 30 },
      { ...errors, error: 30, atHalf: 0.5 },
    ].map((model) => chooseFrameQuality({ a: 0, b: 3e-6 }, model, full, { budgetMs: 30 }));
    expect(sharp.scale).to.be.above(banded.scale);
    expect(sharp.steps).to.be.below(banded.steps);
  });

  it('keeps the size of the last frame where another one gains little', () => {
    const time = { a: 0, b: 3e-6 };
    const best = chooseFrameQuality(time, errors, full, { budgetMs: 30 });
    const near = chooseFrameQuality(time, errors, full, { budgetMs: 30.5, last: best });
    expect(near.scale).to.equal(best.scale);
    expect(
      chooseFrameQuality({ a: 0, b: 1e-8 }, errors, full, {
        budgetMs: 30,
        last: { scale: 0.25, steps: 12, substeps: wholeSteps, sampling: allRays },
      }).scale,
    ).to.equal(1);
  });

  describe('if no time is enough', () => {
    const min = (model: ErrorModel, pixels: number, steps = 100): FrameQuality =>
      chooseFrameQuality({ a: 50, b: 1 }, model, { pixels, steps }, { budgetMs: 30 });

    it('does as much work as 30 steps for few of the pixels are', () => {
      expect(min(errors, 256 ** 2)).to.deep.equal({ scale: 0.25, steps: 30, substeps: wholeSteps, sampling: allRays });
      expect(min(errors, 10, 3)).to.deep.equal({ scale: 0.25, steps: 3, substeps: wholeSteps, sampling: allRays });
      for (const [pixels, max] of [
        [800 ** 2, 128 ** 2 * 34],
        [4000 ** 2, 500 ** 2 * 34],
      ]) {
        const work = workOfFrame(min(errors, pixels), pixels);
        expect(work).to.be.at.most(max * (1 + 1e-9));
        expect(work).to.be.above(0.9 * max);
      }
    });

    it('spends that of a large picture on enough steps for what is thin, and on more where the scene gains from them', () => {
      // What was measured of the MRI and of a storm without rings in the demos, see docs/numbers/benchmark.md.
      const [brain, storm] = [
        { ...errors, steps: 24, error: 1.8, order: 1.7, atHalf: 0.73 },
        { ...errors, steps: 24, error: 4.3, order: 1.4, atHalf: 0.67 },
      ].map((model) => min(model, 800 ** 2));
      expect(brain.steps).to.be.at.least(60);
      expect(800 * brain.scale).to.be.within(80, 105);
      expect(storm.steps).to.be.above(brain.steps - 1);
      expect(min({ ...errors, atHalf: 1000 }, 800 ** 2).steps, 'however many edges there are').to.be.within(60, 80);
      expect(800 * min({ ...errors, error: 1000 }, 800 ** 2).scale, 'however much steps would help').to.be.closeTo(
        80,
        1e-9,
      );
    });

    it('changes nothing for a little more or less time', () => {
      let last: FrameQuality | undefined;
      const seen = new Set<number>();
      for (const b of [0.9, 1.1, 1, 0.95, 1.05])
        seen.add(
          (last = chooseFrameQuality(
            { a: 10, b: (b * 18) / 3e5 },
            { ...errors, steps: 24, error: 1.8, order: 1.7, atHalf: 0.73 },
            { pixels: 800 ** 2, steps: 300 },
            { budgetMs: 28, last },
          )).scale,
        );
      expect([...seen]).to.have.length(1);
    });
  });
});
