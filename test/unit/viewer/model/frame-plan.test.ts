import { expect } from '@esm-bundle/chai';
import { wholeSteps } from '../../../../src/optics/cells/substeps.ts';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { FrameQuality } from '../../../../src/quality/frame-quality.ts';
import { allRays } from '../../../../src/quality/sampling-outcome.ts';
import { stepLengthOf } from '../../../../src/quality/steps.ts';
import { noCuts } from '../../../../src/viewer/cuts/shown-cuts.ts';
import { ShownVolume } from '../../../../src/viewer/cuts/shown-volume.ts';
import { QualityControl } from '../../../../src/viewer/frames/quality-control.ts';
import { planFrame } from '../../../../src/viewer/model/frame-plan.ts';
import type { FramePlan, PlannedFrame } from '../../../../src/viewer/model/frame-plan.ts';
import { defaultTargets } from '../../../../src/viewer/model/quality-targets.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [20, 16, 12] });
const region = cutRegion(volume.grid, [0, 0, 0, 6, 5, 4]);
const slice = { kind: 'level', height: 2000 } as const;
const camera = orbitCamera({ theta: 0.4, phi: 1.1, radius: 40 }, [0, 0, 0], 0.6);
const ring = [
  [0, 0, 0],
  [1, 1, 0],
] as const;
const cuts = {
  ...noCuts,
  region,
  slices: [slice],
  rings: { lines: [ring], labels: [], facts: null },
} as unknown as typeof noCuts;
const quality: FrameQuality = {
  scale: 0.5,
  steps: 90,
  substeps: wholeSteps,
  sampling: { maxCurvature: 8, share: 0.4, error: 1 },
};

/** An object that throws where something tries to change it, and so do its members. */
function frozen<T>(value: T): T {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value) || Object.isFrozen(value)) return value;
  Object.values(value).forEach(frozen);
  return Object.freeze(value);
}

const frame = (change: Partial<PlannedFrame> = {}): PlannedFrame =>
  frozen({ shown: { grid: region!, cuts }, quality, size: { width: 301, height: 200 }, camera, ...change });

describe('the plan of a frame', () => {
  it('has all that the picture is drawn with', () => {
    const expected: FramePlan = {
      picture: { width: 151, height: 100 },
      camera,
      stepLength: stepLengthOf(region!, 90),
      substeps: wholeSteps,
      maxCurvature: 8,
      edgeCurvature: Infinity,
      region,
      slices: [slice],
      cuts: [],
      ground: cuts.rings,
    };
    expect(planFrame(frame())).to.deep.equal(expected);
  });

  it('is the same for the same frame, changes nothing of it, and does not depend on plans before', () => {
    const first = planFrame(frame());
    planFrame(frame({ quality: { ...quality, scale: 1, edgeCurvature: 30 }, camera: null }));
    planFrame(frame({ shown: { grid: volume.grid, cuts: noCuts } }));
    expect(planFrame(frame())).to.deep.equal(first);
  });

  it("has at least one pixel, and the author's viewpoint where no camera is given", () => {
    const plan = planFrame(frame({ size: { width: 1, height: 3 }, quality: { ...quality, scale: 0.1 }, camera: null }));
    expect(plan.picture).to.deep.equal({ width: 1, height: 1 });
    expect(plan.camera).to.equal(null);
  });

  it('does not depend on the order in which volume, cuts and quality were set', () => {
    const plans = [
      [0, 1, 2],
      [0, 2, 1],
      [1, 0, 2],
      [1, 2, 0],
      [2, 0, 1],
      [2, 1, 0],
    ].map((order) => {
      const [shown, control] = [new ShownVolume(), new QualityControl()];
      const settings = [
        () => (shown.volume = volume),
        () => (shown.cuts = cuts),
        () => control.set({ ...defaultTargets, steps: 77 }),
      ];
      for (const i of order) settings[i]();
      return planFrame({ shown, quality: control.still(shown.grid), size: { width: 300, height: 200 }, camera });
    });
    expect(plans[0].stepLength).to.equal(stepLengthOf(region!, 77));
    expect(plans[0].edgeCurvature, 'at rest').to.be.below(Infinity);
    for (const plan of plans) expect(plan).to.deep.equal(plans[0]);
  });

  it('at rest casts all rays, whatever was planned in motion before', () => {
    const control = new QualityControl();
    control.set({ ...defaultTargets, steps: 50 });
    const still = (): FramePlan => planFrame(frame({ quality: control.still(region!) }));
    const before = still();
    planFrame(frame({ quality: control.moving(region!, 60_000) }));
    control.took({ ...quality, sampling: allRays }, 60_000, 12);
    expect(still()).to.deep.equal(before);
    expect(before.maxCurvature).to.equal(0);
  });
});
