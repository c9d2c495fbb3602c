import { expect } from '@esm-bundle/chai';
import { exactMeans } from '../../../../src/optics/transfer/exact-means.ts';
import { extinction } from '../../../../src/optics/transfer/opacity.ts';
import { buildSubstepTable, reachBeyond } from '../../../../src/optics/transfer/substep-table.ts';
import type { SubstepTable } from '../../../../src/optics/transfer/substep-table.ts';
import {
  attenuate,
  composite,
  countSubsteps,
  lookUpRoot,
  maxSubsteps,
  substepsPerRoot,
} from '../../../../src/optics/rays/segment.ts';
import { integrateForTable } from '../../../../src/optics/transfer/preintegration-table.ts';
import type { Premultiplied, TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { expectNear, smooth, worstDifference } from '../../../helpers/emission.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

/** Red below, blue above 0.5, both of one opacity. */
const halves: TransferFunction = [
  { value: 0, color: [1, 0, 0], opacity: 0.5 },
  { value: 0.5, color: [1, 0, 0], opacity: 0.5 },
  { value: 0.5, color: [0, 0, 1], opacity: 0.5 },
  { value: 1, color: [0, 0, 1], opacity: 0.5 },
];

/** The limit: the segment in very many slices, each so thin that order within it does not matter. */
function limitOf(
  transferFunction: TransferFunction,
  [from, to]: readonly [number, number],
  ratio: number,
): Premultiplied {
  const means = exactMeans(transferFunction);
  const accumulated: Premultiplied = [0, 0, 0, 0];
  const slices = 4096;
  for (let i = 0; i < slices; i++) {
    const [begin, end] = [i, i + 1].map((n) => from + ((to - from) * n) / slices);
    composite(accumulated, attenuate(means.mean(begin, end), ratio / slices));
  }
  return accumulated;
}

describe('what a length of one mean shows', () => {
  const mean: Premultiplied = [0.6, 0.3, 0, 0.6];

  it("is Beer and Lambert in the mean's colour", () => {
    const alpha = 1 - Math.exp(-0.6 * 1.7);
    expectNear(attenuate(mean, 1.7), [alpha, alpha / 2, 0, alpha]);
  });

  it('of no length shows nothing', () => {
    expectNear(attenuate(mean, 0), [0, 0, 0, 0], 0);
  });

  it('keeps its relative precision at depths of 1e-6 and below, and is full at 1e6', () => {
    for (const depth of [1e-300, 1e-18, 1e-6, 1e-3]) {
      const [red, , , alpha] = attenuate([depth, 0, 0, depth], 1);
      expect(alpha / (depth - depth ** 2 / 2), String(depth)).to.be.closeTo(1, 1e-6);
      expect(red / alpha).to.be.closeTo(1, 1e-15);
    }
    for (const depth of [1e6, 1e300, Infinity]) expect(attenuate([0, 0, 0, depth], 1)[3]).to.equal(1);
  });
});

describe('a segment', () => {
  it('shows no order: cut into substeps, what comes first is in front', () => {
    const means = exactMeans(halves);
    for (const ratio of [0.5, 2, 10]) {
      const alpha = 1 - 0.5 ** ratio;
      expectNear(attenuate(means.mean(0, 1), ratio), [alpha / 2, 0, alpha / 2, alpha], 1e-14);
      const inSubsteps: Premultiplied = [0, 0, 0, 0];
      for (const [from, to] of [
        [0, 0.5],
        [0.5, 1],
      ])
        composite(inSubsteps, attenuate(means.mean(from, to), ratio / 2));
      const first = 1 - 0.5 ** (ratio / 2);
      expectNear(inSubsteps, [first, 0, (1 - first) * first, alpha], 1e-14);
    }
  });

  it('in eight substeps is near the limit, from thin to opaque, in both directions', () => {
    const means = exactMeans(smooth);
    const random = randomNumbers(33);
    // Bounds in 1/255, by the depth of the whole: the error of a substep grows with the square of its own.
    for (const [ratio, bound] of [
      [0.01, 0.01],
      [0.1, 0.05],
      [0.3, 0.2],
      [1, 1],
      [3, 4],
      [10, 12],
      [1000, 40],
    ]) {
      let worst = 0;
      for (let i = 0; i < 60; i++) {
        const ends = [random() * 1.2 - 0.1, random() * 1.2 - 0.1] as const;
        const got: Premultiplied = [0, 0, 0, 0];
        for (let substep = 0; substep < maxSubsteps; substep++) {
          const [from, to] = [substep, substep + 1].map((n) => ends[0] + ((ends[1] - ends[0]) * n) / maxSubsteps);
          composite(got, attenuate(means.mean(from, to), ratio / maxSubsteps));
        }
        worst = Math.max(worst, worstDifference(got, limitOf(smooth, ends, ratio)));
      }
      console.log(`eight substeps of ${ratio} reference lengths: off the limit by ${(worst * 255).toFixed(2)}/255`);
      expect(worst * 255, `ratio ${ratio}`).to.be.below(bound);
    }
  });

  it('has one opacity whatever the order: that of its whole depth', () => {
    const means = exactMeans(smooth);
    for (const ratio of [0.1, 1, 5]) {
      for (const ends of [
        [0, 1],
        [1, 0],
        [0.2, 0.9],
        [-1, 0.5],
      ] as const) {
        const alpha = 1 - Math.exp(-means.mean(ends[0], ends[1])[3] * ratio);
        expect(attenuate(means.mean(ends[0], ends[1]), ratio)[3]).to.be.closeTo(alpha, 1e-6);
      }
    }
  });

  it('whose ends come together is the point', () => {
    const means = exactMeans(smooth);
    for (const value of [0, 0.2, 0.4, 0.77, 1, 3]) {
      const point = attenuate(means.mean(value, value), 2);
      for (const width of [1e-3, 1e-6, 1e-12]) {
        // Extinction grows by at most 10 per unit of value here, and what is visible by no more.
        expectNear(attenuate(means.mean(value, value + width), 2), point, 20 * width + 1e-12);
      }
    }
  });

  it('counts pieces outside the domain as its ends', () => {
    const means = exactMeans(halves);
    const alpha = 1 - 0.5 ** 2;
    expectNear(attenuate(means.mean(-8, -3), 2), [alpha, 0, 0, alpha], 1e-14);
    expectNear(attenuate(means.mean(7, 2), 2), [0, 0, alpha, alpha], 1e-14);
    expectNear(attenuate(means.mean(-9.5, 10.5), 2), [alpha / 2, 0, alpha / 2, alpha], 1e-14);
  });
});

describe('the substeps of a step', () => {
  const tableOf = (transferFunction: TransferFunction, voxelRatio: number): SubstepTable =>
    buildSubstepTable(integrateForTable(transferFunction), voxelRatio);

  it("are more the more may be seen: by the cube root of a voxel's opacity, up to a bound", () => {
    // Well beyond the domain the extinction is that of opacity 0.9, whatever the reach.
    const at = (opacity: number): number =>
      countSubsteps(tableOf(smooth, extinction(opacity) / extinction(0.9)), [9, 9], 1);
    for (const opacity of [1e-3, 5e-3, 2e-2])
      expect(at(opacity)).to.equal(Math.ceil((substepsPerRoot * Math.ceil(255 * Math.cbrt(opacity))) / 255));
    expect(at(1e-12)).to.equal(1);
    expect(at(0.1)).to.equal(maxSubsteps);
    expect(countSubsteps(tableOf(smooth, 1e30), [9, 9], 1)).to.equal(maxSubsteps);
    expect(countSubsteps(tableOf(smooth, 0), [9, 9], 1)).to.equal(1);
  });

  it('are one where nothing shows, or nothing of it reaches the eye', () => {
    expect(countSubsteps(tableOf(smooth, 1e6), [-50, -30], 1)).to.equal(1);
    expect(countSubsteps(tableOf(smooth, 1e6), [9, 9], 0)).to.equal(1);
  });

  it('take into account values beyond the ends as far as the value may go between them', () => {
    const peak = tableOf(
      [
        { value: 0, color: [1, 1, 1], opacity: 0 },
        { value: 0.5, color: [1, 1, 1], opacity: 0 },
        { value: 0.51, color: [1, 1, 1], opacity: 0.9 },
        { value: 0.52, color: [1, 1, 1], opacity: 0 },
        { value: 1, color: [1, 1, 1], opacity: 0 },
      ],
      1,
    );
    expect(countSubsteps(peak, [0.3, 0.45], 1)).to.be.above(1);
    expect(countSubsteps(peak, [0.45, 0.3], 1)).to.equal(countSubsteps(peak, [0.3, 0.45], 1));
    expect(countSubsteps(peak, [0.485, 0.485], 1)).to.be.above(1);
    expect(countSubsteps(peak, [0.45, 0.45], 1)).to.equal(1);
  });

  it('are asked for as the means have it, within a texel', () => {
    const means = exactMeans(smooth);
    const table = tableOf(smooth, 0.2);
    const random = randomNumbers(35);
    for (let i = 0; i < 300; i++) {
      const [from, to] = [random() * 1.4 - 0.2, random() * 1.4 - 0.2];
      const reach = 0.5 * Math.abs(to - from) + reachBeyond.ofDomain;
      const [, , , density] = means.mean(Math.min(from, to) - reach, Math.max(from, to) + reach);
      expect(lookUpRoot(table, [from, to])).to.be.closeTo(Math.cbrt(1 - Math.exp(-density * 0.2)), 0.03);
    }
  });
});
