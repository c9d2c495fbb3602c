import { expect } from '@esm-bundle/chai';
import { brighten } from '../../../../src/optics/transfer/brighten.ts';
import { emission } from '../../../../src/optics/transfer/emission.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { expectNear } from '../../../helpers/emission.ts';

/** Red fades in from transparent blue, jumps to green at 20. */
const stops: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 10, color: [1, 0, 0], opacity: 0.5 },
  { value: 20, color: [1, 0, 0], opacity: 0.5 },
  { value: 20, color: [0, 1, 0], opacity: 0.8 },
  { value: 40, color: [0.5, 0.5, 0.5], opacity: 0.2 },
];

/** What a length of one data value shows. */
const show = (value: number, ratio: number, lightFactor = 1) =>
  attenuate(emission(brighten(stops, lightFactor), value), ratio);

describe('a transfer function', () => {
  it('is interpolated premultiplied, as CSS gradients are: a transparent blue tints nothing', () => {
    expectNear(evaluate(stops, 5), [0.25, 0, 0, 0.25]);
    expectNear(evaluate(stops, 30), [0.05, 0.45, 0.05, 0.5]);
  });

  it('hits its stops, jumps at two of one value and is continuous from the right there', () => {
    expectNear(evaluate(stops, 10), [0.5, 0, 0, 0.5]);
    expectNear(evaluate(stops, 20 - 1e-9), [0.5, 0, 0, 0.5]);
    expectNear(evaluate(stops, 20), [0, 0.8, 0, 0.8]);
  });

  it('stays at its first and last stop outside, at infinity too', () => {
    for (const value of [-1, -1e300, -Infinity]) expectNear(evaluate(stops, value), [0, 0, 0, 0]);
    for (const value of [40, 41, 1e300, Infinity]) expectNear(evaluate(stops, value), [0.1, 0.1, 0.1, 0.2]);
  });

  it('may be a single stop, or begin and end with a jump', () => {
    const single: TransferFunction = [{ value: 3, color: [1, 0.5, 0], opacity: 0.4 }];
    for (const value of [-9, 3, 9]) expectNear(evaluate(single, value), [0.4, 0.2, 0, 0.4]);
    const step: TransferFunction = [
      { value: 3, color: [1, 1, 1], opacity: 0 },
      { value: 3, color: [1, 1, 1], opacity: 1 },
    ];
    expectNear(evaluate(step, 2.999), [0, 0, 0, 0]);
    expectNear(evaluate(step, 3), [1, 1, 1, 1]);
  });

  it('gives a step its share of the extinction, and its own colour', () => {
    const [red, green, blue, alpha] = show(30, 0.25);
    expect(alpha).to.be.closeTo(1 - 0.5 ** 0.25, 1e-15);
    expectNear([red / alpha, green / alpha, blue / alpha], [0.1, 0.9, 0.1]);
  });

  it('has its extinction multiplied by the opacity factor and its colour by the light factor, up to white', () => {
    expect(show(10, 3)[3]).to.be.closeTo(1 - 0.5 ** 3, 1e-15);
    expectNear(show(10, 0), [0, 0, 0, 0]);
    expectNear(show(30, 1, 0.5), [0.025, 0.225, 0.025, 0.5]);
    expectNear(show(30, 1, 4), [0.2, 0.5, 0.2, 0.5]);
  });

  it('is brightened exactly at every value, not only at its stops, and keeps its opacity', () => {
    for (const lightFactor of [0, 0.3, 1, 1.3, 2.5, 7, 100, 1e30]) {
      const bright = brighten(stops, lightFactor);
      for (let value = -5; value <= 45; value += 0.37) {
        const [red, green, blue, alpha] = evaluate(stops, value);
        const expected = [red, green, blue].map((channel) => Math.min(channel * lightFactor, alpha));
        expectNear(evaluate(bright, value), [...expected, alpha] as Premultiplied, 1e-12);
      }
    }
    expect(brighten(stops, 1)).to.equal(stops);
  });

  it('of a full step agrees with the correction of a share of it', () => {
    const full = show(30, 1)[3];
    expect(1 - (1 - full) ** 0.3).to.be.closeTo(show(30, 0.3)[3], 1e-15);
  });
});
