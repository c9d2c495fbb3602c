import { expect } from '@esm-bundle/chai';
import { correctOpacity } from '../../src/optics/opacity.ts';
import { buildStepTable } from '../../src/optics/table.ts';
import { classifyStep, evaluate } from '../../src/optics/transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer-function.ts';

const plain = { opacityFactor: 1, lightFactor: 1 };

/** Red fades in from transparent blue, jumps to green at 20. */
const stops: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 10, color: [1, 0, 0], opacity: 0.5 },
  { value: 20, color: [1, 0, 0], opacity: 0.5 },
  { value: 20, color: [0, 1, 0], opacity: 0.8 },
  { value: 40, color: [0.5, 0.5, 0.5], opacity: 0.2 },
];

function expectNear(got: readonly number[], expected: readonly number[], tolerance = 1e-15): void {
  expect(got).to.have.length(expected.length);
  got.forEach((x, i) => expect(x, `channel ${i} of ${got.join(' ')}`).to.be.closeTo(expected[i], tolerance));
}

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

  it('gives a step its part of the extinction, and its own colour', () => {
    const [red, green, blue, alpha] = classifyStep(stops, 30, 0.25, plain);
    expect(alpha).to.be.closeTo(1 - 0.5 ** 0.25, 1e-15);
    expectNear([red / alpha, green / alpha, blue / alpha], [0.1, 0.9, 0.1]);
  });

  it('has its extinction multiplied by the opacity factor and its colour by the light factor, up to white', () => {
    expect(classifyStep(stops, 10, 1, { opacityFactor: 3, lightFactor: 1 })[3]).to.be.closeTo(1 - 0.5 ** 3, 1e-15);
    expectNear(classifyStep(stops, 10, 1, { opacityFactor: 0, lightFactor: 1 }), [0, 0, 0, 0]);
    expectNear(classifyStep(stops, 30, 1, { opacityFactor: 1, lightFactor: 0.5 }), [0.025, 0.225, 0.025, 0.5]);
    expectNear(classifyStep(stops, 30, 1, { opacityFactor: 1, lightFactor: 4 }), [0.2, 0.5, 0.2, 0.5]);
  });
});

describe('the table of a transfer function', () => {
  const factors = { opacityFactor: 1.5, lightFactor: 0.8 };

  it('holds what the function gives at the centres of its texels', () => {
    const table = buildStepTable(stops, 0.3, factors);
    expect([table.low, table.high, table.texels.length]).to.deep.equal([0, 40, 2048 * 4]);
    for (const i of [0, 1, 512, 1023, 1500, 2047]) {
      const expected = classifyStep(stops, (40 * i) / 2047, 0.3, factors);
      // Half a unit in the last place of a float32 below 1.
      expectNear([...table.texels.subarray(i * 4, i * 4 + 4)], expected, 2 ** -25);
    }
  });

  it('read linearly is the function within half a level of 8 bits, away from jumps', () => {
    const table = buildStepTable(stops, 0.3, factors);
    let worst = 0;
    for (let value = -5; value < 45; value += 0.0137) {
      const texel = Math.min(2047, Math.max(0, (value / 40) * 2047));
      // The texels next to the jump mix both of its sides.
      if (Math.abs(texel - (20 / 40) * 2047) < 1) continue;
      const low = Math.min(2046, Math.floor(texel));
      const expected = classifyStep(stops, value, 0.3, factors);
      for (let c = 0; c < 4; c++) {
        const got = table.texels[low * 4 + c] * (1 - (texel - low)) + table.texels[low * 4 + 4 + c] * (texel - low);
        worst = Math.max(worst, Math.abs(got - expected[c]));
      }
    }
    expect(worst).to.be.below(0.5 / 255);
  });

  it('of one stop, or of a jump alone, is as wide as it must be', () => {
    const table = buildStepTable([{ value: 3, color: [1, 0, 0], opacity: 0.4 }], 1, plain);
    expect(table.low).to.be.below(3);
    expect(table.high).to.be.above(3);
    expect(table.texels[3]).to.be.closeTo(0.4, 1e-7);
    expect(table.texels[2047 * 4 + 3]).to.be.closeTo(0.4, 1e-7);
    expect(() => buildStepTable([], 1, plain)).to.throw(RangeError, /expected 1 or more/);
  });

  it('of a full step agrees with the correction of a part of it', () => {
    const full = classifyStep(stops, 30, 1, plain)[3];
    expect(correctOpacity(full, 0.3)).to.be.closeTo(classifyStep(stops, 30, 0.3, plain)[3], 1e-15);
  });
});
