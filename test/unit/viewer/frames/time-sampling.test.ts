import { expect } from '@esm-bundle/chai';
import { unknownErrors } from '../../../../src/quality/frame-quality.ts';
import { chooseFrameQuality } from '../../../../src/quality/choose-frame-quality.ts';
import type { SamplingOutcome } from '../../../../src/quality/sampling-outcome.ts';
import type { RayPlan } from '../../../../src/renderer/ray/ray-plan.ts';
import type { DrawnView } from '../../../../src/viewer/model/drawn-view.ts';
import { timeSampling } from '../../../../src/viewer/frames/time-sampling.ts';
import { cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Pass } from '../../../../src/viewer/model/scene.ts';
import { fakeOf, fakeScene } from '../../../helpers/fake.ts';

const outcomes: readonly SamplingOutcome[] = [
  { maxCurvature: 4, share: 0.8, error: 0.1 },
  { maxCurvature: 16, share: 0.4, error: 0.2 },
];

/** A view on a renderer whose clock tells what each kind of picture takes, ms; the first of each compiles, which takes a second more. */
function viewOf(
  times: { all: number; spared: number },
  goesOn = (): boolean => true,
): { view: DrawnView; drawn: number[] } {
  const drawn: number[] = [];
  let [now, maxCurvature] = [0, 0];
  performance.now = () => now;
  const scene = fakeScene({
    gatherable: true,
    endsAtShapes: false,
    startGathering: (rays: Partial<RayPlan>) => {
      maxCurvature = rays.maxCurvature!;
      return [fakeOf<Pass>('Pass', { height: 10 })];
    },
    gather: () => {
      now += (maxCurvature > 0 ? times.spared : times.all) + (drawn.includes(maxCurvature) ? 0 : 1000);
      drawn.push(maxCurvature);
    },
    finished: async () => {},
  });
  return {
    view: {
      scene,
      grid: cartesianGrid([64, 64, 64], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
      size: { width: 100, height: 100 },
      goesOn,
    },
    drawn,
  };
}

describe('what spared rays cost on a graphics processor', () => {
  const { now } = performance;
  afterEach(() => {
    performance.now = now;
  });

  it('is measured in turns, without what compiling takes, and once for a scene', async () => {
    const { view, drawn } = viewOf({ all: 10, spared: 21.5 });
    const foretold = (0.4 * 68 + 3) / 68;
    expect(await timeSampling(view, outcomes)).to.be.closeTo(2.15 / foretold, 1e-9);
    expect(
      drawn.filter((curvature) => curvature > 0),
      'the first outcome that saves half',
    ).to.deep.equal([16, 16, 16, 16]);
    const { length } = drawn;
    await timeSampling(view, outcomes);
    expect(drawn.length).to.equal(length);
  });

  it('is taken for what it was where the view is no longer wanted, or nothing is known', async () => {
    let left = 3;
    const { view } = viewOf({ all: 10, spared: 80 }, () => left-- > 0);
    expect(await timeSampling(view, outcomes)).to.equal(1);
    left = 100;
    expect(await timeSampling(view, outcomes), 'and is measured later').to.be.above(10);
    expect(await timeSampling(viewOf({ all: 10, spared: 80 }).view, outcomes.slice(0, 1))).to.equal(1);
    const amongShapes = viewOf({ all: 10, spared: 80 });
    Object.assign(amongShapes.view.scene, { endsAtShapes: true });
    expect(await timeSampling(amongShapes.view, outcomes), 'rays end at shapes').to.equal(1);
    expect(amongShapes.drawn).to.deep.equal([]);
  });

  it('of slow pictures is measured once', async () => {
    const { view, drawn } = viewOf({ all: 500, spared: 100 });
    await timeSampling(view, outcomes);
    expect(drawn.length).to.equal(4);
  });

  it('is not measured by a clock that is coarser than what pictures take', async () => {
    for (const times of [
      { all: 4, spared: 8 },
      { all: 0, spared: 0 },
    ])
      expect(await timeSampling(viewOf(times).view, outcomes)).to.equal(1);
  });

  it('decides whether rays are spared', () => {
    const plan = (cost?: number): number =>
      chooseFrameQuality(
        { a: 0, b: 1e-6 },
        { ...unknownErrors, sampling: [[{ maxCurvature: 16, share: 0.4, error: 0.2, cost }]] },
        { pixels: 512 ** 2, steps: 400 },
        { budgetMs: 28 },
      ).sampling.maxCurvature;
    expect(plan()).to.equal(16);
    expect(plan(0.3)).to.equal(16);
    expect(plan(1.3)).to.equal(0);
  });
});
