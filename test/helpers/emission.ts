import { expect } from '@esm-bundle/chai';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';

/** Integral over opacity, from 0, of the extinction -ln(1 - a): (1 - a) ln(1 - a) + a. */
export function integrateExtinction(alpha: number): number {
  // At small opacities the two terms cancel, so use the series a^2 / 2 + a^3 / 6 + a^4 / 12 + ...
  if (alpha < 1e-3) return alpha ** 2 / 2 + alpha ** 3 / 6 + alpha ** 4 / 12;
  return alpha < 1 ? (1 - alpha) * Math.log1p(-alpha) + alpha : 1;
}

/** The mean extinction if the opacity changes linearly from one value to another. */
export function meanExtinction(from: number, to: number): number {
  return (integrateExtinction(to) - integrateExtinction(from)) / (to - from);
}

/** From clear to nearly opaque, without a jump; data values are equal to shares of the domain here. */
export const smooth: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 0.4, color: [1, 0.2, 0], opacity: 0.4 },
  { value: 1, color: [0.9, 1, 0.5], opacity: 0.9 },
];

/** The largest difference of two lists of numbers. */
export function worstDifference(got: readonly number[], expected: readonly number[]): number {
  return Math.max(...got.map((x, i) => Math.abs(x - expected[i])));
}

/** Expect that two lists of numbers agree within a tolerance, one by one. */
export function expectNear(got: readonly number[], expected: readonly number[], tolerance = 1e-15): void {
  expect(got).to.have.length(expected.length);
  got.forEach((x, i) => expect(x, `number ${i} of ${got.join(' ')}`).to.be.closeTo(expected[i], tolerance));
}
