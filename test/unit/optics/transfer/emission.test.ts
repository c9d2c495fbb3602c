import { expect } from '@esm-bundle/chai';
import { domainOf, emission, meanOverSpan, opaqueExtinction } from '../../../../src/optics/transfer/emission.ts';
import { exactMeans } from '../../../../src/optics/transfer/exact-means.ts';
import { extinction } from '../../../../src/optics/transfer/opacity.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { expectNear, meanExtinction } from '../../../helpers/emission.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

/** Flat, a ramp of opacity in one colour, a jump, a ramp of colour at one opacity. */
const stops: TransferFunction = [
  { value: 0, color: [1, 0.5, 0], opacity: 0.1 },
  { value: 10, color: [1, 0.5, 0], opacity: 0.1 },
  { value: 20, color: [1, 0.5, 0], opacity: 0.6 },
  { value: 20, color: [0, 0, 1], opacity: 0.3 },
  { value: 40, color: [0, 1, 1], opacity: 0.3 },
];

describe('emission', () => {
  it('is extinction in the straight colour', () => {
    expectNear(
      emission(stops, 5),
      [1, 0.5, 0, 1].map((x) => x * extinction(0.1)),
    );
    expectNear(
      emission(stops, 15),
      [1, 0.5, 0, 1].map((x) => x * extinction(0.35)),
    );
    expectNear(
      emission(stops, 30),
      [0, 0.5, 1, 1].map((x) => x * extinction(0.3)),
    );
  });

  it('is nothing at opacity 0, of any colour, and finite at opacity 1', () => {
    expectNear(emission([{ value: 0, color: [1, 1, 1], opacity: 0 }], 0), [0, 0, 0, 0], 0);
    expectNear(
      emission([{ value: 0, color: [1, 0.5, 0], opacity: 1 }], 0),
      [opaqueExtinction, opaqueExtinction / 2, 0, opaqueExtinction],
      0,
    );
    // A hundredth of a reference length of it lets less through than float32 can tell from nothing.
    expect(Math.exp(-opaqueExtinction / 100)).to.be.below(2 ** -24);
  });

  it('keeps its relative precision at opacities of 1e-6 and 1e-18', () => {
    for (const opacity of [1e-6, 1e-18]) {
      const [red, , , density] = emission([{ value: 0, color: [0.25, 0, 0], opacity }], 0);
      expect(density / (opacity + opacity ** 2 / 2)).to.be.closeTo(1, 1e-12);
      expect(red / density).to.be.closeTo(0.25, 1e-15);
    }
  });
});

describe('the domain of a transfer function', () => {
  it('runs from the first to the last stop, and has a width where they coincide', () => {
    expect(domainOf(stops)).to.deep.equal([0, 40]);
    for (const value of [0, 3, -1000, 1e30, 1e-30]) {
      const [low, high] = domainOf([{ value, color: [0, 0, 0], opacity: 0 }]);
      expect(low, String(value)).to.be.below(value);
      expect(high, String(value)).to.be.above(value);
      expect(high - low).to.be.below(1e-5 * Math.abs(value) + 1e-8);
    }
    const { low, high } = exactMeans(stops);
    expect([low, high]).to.deep.equal([0, 40]);
  });
});

describe('the mean over a span of values', () => {
  const ramp = (from: number, to: number): number[] => [1, 0.5, 0, 1].map((x) => x * meanExtinction(from, to));

  it('is the closed form over a linear ramp of opacity', () => {
    // Five nodes of Gauss where the opacity stays away from 1; towards 1, what is left after the halvings.
    expectNear(meanOverSpan(stops, 10, 20), ramp(0.1, 0.6), 1e-6);
    expectNear(meanOverSpan(stops, 12, 13), ramp(0.2, 0.25), 1e-12);
    for (const [from, to] of [
      [0, 0.01],
      [0, 1e-6],
      [0.3, 0.300001],
      [0, 0.99],
      [0.9, 0.999],
      [0, 1],
      [0.5, 1],
    ]) {
      const one: TransferFunction = [
        { value: 0, color: [1, 0.5, 0], opacity: from },
        { value: 1, color: [1, 0.5, 0], opacity: to },
      ];
      const expected = meanExtinction(from, to);
      const worst = Math.max(...meanOverSpan(one, 0, 1).map((x, c) => Math.abs(x / expected - [1, 0.5, 0, 1][c])));
      console.log(`mean extinction from opacity ${from} to ${to}: off by ${worst.toExponential(1)} of it`);
      expect(worst, `${from} to ${to}`).to.be.below(3e-5);
    }
  });

  it('is the mean colour times the extinction over a ramp of colour', () => {
    expectNear(
      meanOverSpan(stops, 20, 40),
      [0, 0.5, 1, 1].map((x) => x * extinction(0.3)),
      1e-14,
    );
    expectNear(
      meanOverSpan(stops, 22, 24),
      [0, 0.15, 1, 1].map((x) => x * extinction(0.3)),
      1e-14,
    );
  });

  it('weighs the two sides of a jump by their shares', () => {
    const jump: TransferFunction = [
      { value: 7, color: [1, 0, 0], opacity: 0.2 },
      { value: 7, color: [0, 1, 0], opacity: 0.9 },
    ];
    for (const share of [1e-9, 0.25, 0.5, 0.9]) {
      const [red, green, blue, density] = meanOverSpan(jump, 7 - share, 8 - share);
      expect(red, `share ${share}`).to.be.closeTo(share * extinction(0.2), 1e-12);
      expect(green).to.be.closeTo((1 - share) * extinction(0.9), 1e-12);
      expect(blue).to.equal(0);
      expect(density).to.be.closeTo(red + green, 1e-12);
    }
    // Ending or beginning at the jump, a span has nothing of its other side.
    expectNear(meanOverSpan(jump, 6, 7), [extinction(0.2), 0, 0, extinction(0.2)], 1e-14);
    expectNear(meanOverSpan(jump, 7, 8), [0, extinction(0.9), 0, extinction(0.9)], 1e-14);
  });

  it('stays at the ends outside, however far', () => {
    expectNear(meanOverSpan(stops, -20, -10), emission(stops, 0), 1e-14);
    expectNear(meanOverSpan(stops, 50, 1e30), emission(stops, 40), 1e-14);
    expectNear(meanOverSpan(stops, -30, 10), emission(stops, 0), 1e-14);
    // A share of 1e-15 of this span is inside.
    expectNear(meanOverSpan(stops, -1e17, 20), emission(stops, 0), 1e-13);
  });

  it('at one value is the emission there, from the right at a jump', () => {
    for (const value of [-5, 0, 3, 20, 33, 40, 99])
      expectNear(meanOverSpan(stops, value, value), emission(stops, value), 0);
  });

  it('does not ask which end comes first', () => {
    const random = randomNumbers(31);
    for (let i = 0; i < 200; i++) {
      const [from, to] = [random() * 60 - 10, random() * 60 - 10];
      expectNear(meanOverSpan(stops, from, to), meanOverSpan(stops, to, from), 0);
    }
  });

  it('of a span is the weighted mean of its pieces', () => {
    const random = randomNumbers(32);
    for (let i = 0; i < 200; i++) {
      const a = random() * 30 - 10;
      const b = a + random() * 20;
      const c = b + random() * 20;
      const share = (b - a) / (c - a);
      const [first, second] = [meanOverSpan(stops, a, b), meanOverSpan(stops, b, c)];
      // Gauss's rule on a longer and on two shorter pieces of the one ramp.
      expectNear(
        meanOverSpan(stops, a, c),
        first.map((x, k) => x * share + second[k] * (1 - share)),
        2e-6,
      );
    }
  });

  it('may be of one stop', () => {
    const one: TransferFunction = [{ value: 3, color: [1, 0.5, 0], opacity: 0.4 }];
    for (const [from, to] of [
      [3, 3],
      [2, 4],
      [4, 9],
      [-9, 3],
    ])
      expectNear(meanOverSpan(one, from, to), emission(one, 0), 1e-15);
  });
});
