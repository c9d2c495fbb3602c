import { expect } from '@esm-bundle/chai';
import { exactMeans } from '../../src/optics/emission.ts';
import { extinction } from '../../src/optics/opacity.ts';
import { attenuate, classifySegment, composite, countParts, mostParts, orderMattersFromDepth, orderMattersFromSpan, partsPerRoot } from '../../src/optics/segment.ts';
import type { Premultiplied, TransferFunction } from '../../src/optics/transfer-function.ts';
import { expectNear } from '../helpers/emission.ts';
import { randomNumbers } from '../helpers/synthetic.ts';

/** Red below, blue above 0.5, both of one opacity. */
const halves: TransferFunction = [
  { value: 0, color: [1, 0, 0], opacity: 0.5 },
  { value: 0.5, color: [1, 0, 0], opacity: 0.5 },
  { value: 0.5, color: [0, 0, 1], opacity: 0.5 },
  { value: 1, color: [0, 0, 1], opacity: 0.5 },
];
const smooth: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 0.4, color: [1, 0.2, 0], opacity: 0.4 },
  { value: 1, color: [0.9, 1, 0.5], opacity: 0.9 },
];

/** The limit: the segment in very many slices, each so thin that no order is left within it. */
function limitOf(transferFunction: TransferFunction, [from, to]: readonly [number, number], ratio: number): Premultiplied {
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

  it('is Beer and Lambert in the mean\'s colour', () => {
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
  it('shows what comes first in front, where it is dense', () => {
    const means = exactMeans(halves);
    for (const ratio of [0.5, 2, 10]) {
      const [first, second] = [1 - 0.5 ** (ratio / 2), 0.5 ** (ratio / 2) * (1 - 0.5 ** (ratio / 2))];
      expectNear(classifySegment(means, [0, 1], ratio), [first, 0, second, first + second], 1e-14);
      expectNear(classifySegment(means, [1, 0], ratio), [second, 0, first, first + second], 1e-14);
    }
  });

  it('is the same to and fro where it is thin, or narrow', () => {
    const means = exactMeans(smooth);
    const thin = (0.9 * orderMattersFromDepth) / means.mean(0, 1)[3];
    expectNear(classifySegment(means, [0, 1], thin), classifySegment(means, [1, 0], thin), 0);
    const narrow = 0.4 + 0.9 * orderMattersFromSpan;
    expectNear(classifySegment(means, [0.4, narrow], 100), classifySegment(means, [narrow, 0.4], 100), 0);
  });

  it('is near the limit, from thin to opaque, to and fro', () => {
    const means = exactMeans(smooth);
    const random = randomNumbers(33);
    // Bounds in 1/255. The error of a mean grows with the square of the depth, up to where order counts (0.1); beyond,
    // a quarter of the segment is what has no order, until all that one sees is within the first quarter.
    for (const [ratio, bound] of [[0.01, 0.01], [0.1, 0.3], [0.3, 0.3], [1, 1.5], [3, 5], [10, 16], [1000, 45]]) {
      let worst = 0;
      for (let i = 0; i < 60; i++) {
        const ends = [random() * 1.2 - 0.1, random() * 1.2 - 0.1] as const;
        const [got, expected] = [classifySegment(means, ends, ratio), limitOf(smooth, ends, ratio)];
        got.forEach((x, c) => (worst = Math.max(worst, Math.abs(x - expected[c]))));
      }
      console.log(`one segment of ${ratio} reference lengths: off the limit by ${(worst * 255).toFixed(2)}/255`);
      expect(worst * 255, `ratio ${ratio}`).to.be.below(bound);
    }
  });

  it('has one opacity whatever the order: that of its whole depth', () => {
    const means = exactMeans(smooth);
    for (const ratio of [0.1, 1, 5]) {
      for (const ends of [[0, 1], [1, 0], [0.2, 0.9], [-1, 0.5]] as const) {
        const alpha = 1 - Math.exp(-means.mean(ends[0], ends[1])[3] * ratio);
        expect(classifySegment(means, ends, ratio)[3]).to.be.closeTo(alpha, 1e-6);
      }
    }
  });

  it('changes little where it begins to mind the order', () => {
    const means = exactMeans(smooth);
    for (const ends of [[0, 1], [1, 0], [0.3, 0.6], [0.6, 0.3]] as const) {
      const ratio = orderMattersFromDepth / means.mean(ends[0], ends[1])[3];
      const [below, above] = [0.999999, 1.000001].map((x) => classifySegment(means, ends, ratio * x));
      // What order makes of a depth of 0.1: a step of less than 1/255.
      below.forEach((x, c) => expect(x, `channel ${c}`).to.be.closeTo(above[c], 1 / 255));
    }
  });

  it('whose ends come together is the point', () => {
    const means = exactMeans(smooth);
    for (const value of [0, 0.2, 0.4, 0.77, 1, 3]) {
      const point = attenuate(means.mean(value, value), 2);
      for (const width of [1e-3, 1e-6, 1e-12]) {
        // Extinction grows by at most 10 a unit of value here, and what is seen by no more.
        expectNear(classifySegment(means, [value, value + width], 2), point, 20 * width + 1e-12);
      }
    }
  });

  it('counts parts outside the domain as its ends', () => {
    const means = exactMeans(halves);
    const alpha = 1 - 0.5 ** 2;
    expectNear(classifySegment(means, [-8, -3], 2), [alpha, 0, 0, alpha], 1e-14);
    expectNear(classifySegment(means, [7, 2], 2), [0, 0, alpha, alpha], 1e-14);
    const first = 1 - 0.5 ** 1;
    expectNear(classifySegment(means, [-9.5, 10.5], 2), [first, 0, (1 - first) * first, alpha], 1e-14);
  });
});

describe('the parts of a step', () => {
  const means = exactMeans(smooth);

  it('are more the more may be seen: by the cube root of a voxel\'s opacity, up to a bound', () => {
    // At the flat end the extinction is that of opacity 0.9, whatever the reach.
    const at = (opacity: number): number => {
      const ratio = extinction(opacity) / extinction(0.9);
      return countParts(means, [9, 9], ratio, 1);
    };
    for (const opacity of [1e-3, 5e-3, 2e-2]) expect(at(opacity)).to.equal(Math.ceil(partsPerRoot * Math.cbrt(opacity)));
    expect(at(1e-6)).to.equal(1);
    expect(at(0.1)).to.equal(mostParts);
    expect(countParts(means, [9, 9], 1e30, 1)).to.equal(mostParts);
    expect(countParts(means, [9, 9], 0, 1)).to.equal(1);
  });

  it('are one where nothing shows, or nothing of it reaches the eye', () => {
    expect(countParts(means, [-50, -30], 1e6, 1)).to.equal(1);
    expect(countParts(means, [9, 9], 1e6, 0)).to.equal(1);
  });

  it('look as far beyond the ends as the value may go between them', () => {
    const peak = exactMeans([{ value: 0, color: [1, 1, 1], opacity: 0 }, { value: 0.5, color: [1, 1, 1], opacity: 0 }, { value: 0.51, color: [1, 1, 1], opacity: 0.9 }, { value: 0.52, color: [1, 1, 1], opacity: 0 }, { value: 1, color: [1, 1, 1], opacity: 0 }]);
    expect(countParts(peak, [0.3, 0.45], 1, 1)).to.be.above(1);
    expect(countParts(peak, [0.45, 0.3], 1, 1)).to.equal(countParts(peak, [0.3, 0.45], 1, 1));
    expect(countParts(peak, [0.485, 0.485], 1, 1)).to.be.above(1);
    expect(countParts(peak, [0.45, 0.45], 1, 1)).to.equal(1);
  });
});
