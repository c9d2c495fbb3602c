import { expect } from '@esm-bundle/chai';
import { measureCellLimits } from '../../../../src/optics/cells/cell-limits.ts';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions: Vector3 = [30, 20, 25];

describe('limits of cells', () => {
  for (const [kind, scale, offset] of [
    ['uint8', 1.6 / 255, -0.3],
    ['uint16', -1.2 / 65535, 1.1],
    ['float32', 3, -1],
  ] as const) {
    it(`hold every value of a cell, and are no further off than two bytes' steps: ${kind}`, () => {
      const random = randomNumbers(63);
      const { samples, macrocells } = syntheticVolume({
        dimensions,
        kind,
        field: (x, y) => (x > 0.7 ? 0.1 * random() : 0.6 * random() + 0.3 * y),
      });
      for (const sign of [1, -1] as const) {
        const limits = measureCellLimits(macrocells, { scale, offset }, sign);
        const shares = [macrocells.low, macrocells.high].map((values) =>
          Array.from(values, (value) => sign * (scale * value + offset)),
        );
        limits.forEach((limit, cell) => {
          const share = (limit - 1) / 254 - (sign < 0 ? 1 : 0);
          const largest = Math.max(shares[0][cell], shares[1][cell]);
          const [from, to] = sign > 0 ? [0, 1] : [-1, 0];
          expect(share, `cell ${cell}`).to.be.at.least(Math.min(to, largest));
          expect(share, `cell ${cell}`).to.be.at.most(Math.min(to, Math.max(from, largest)) + 2 / 254);
        });
        for (let i = 0; i < 3000; i++) {
          const p: Vector3 = [random(), random(), random()];
          const [x, y, z] = p.map((u, axis) => Math.floor((u * dimensions[axis]) / macrocells.size));
          const limit = limits[x + macrocells.dimensions[0] * (y + macrocells.dimensions[1] * z)];
          const value = sign * (scale * interpolate(samples, dimensions, p) + offset);
          expect((limit - 1) / 254 - (sign < 0 ? 1 : 0)).to.be.at.least(Math.min(sign > 0 ? 1 : 0, value));
        }
      }
    });
  }

  it('know cells without data', () => {
    const { macrocells } = syntheticVolume({ dimensions, kind: 'float32', field: (x) => (x > 0.25 ? NaN : 0.5) });
    const limits = measureCellLimits(macrocells, { scale: 1, offset: 0 }, 1);
    expect(new Set(limits)).to.deep.equal(new Set([0, 1 + Math.ceil(254 * 0.5001)]));
  });
});
