import { expect } from '@esm-bundle/chai';
import { extinction } from '../../../../src/optics/transfer/opacity.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';

/** Two layers, front to back. */
const over = (a: number, b: number): number => a + (1 - a) * b;

/** Opacity over `ratio` reference lengths of what has opacity `alpha` over one. */
const correct = (alpha: number, ratio: number): number => attenuate([0, 0, 0, extinction(alpha)], ratio)[3];

describe('opacity correction', () => {
  it('has the closed forms of whole numbers of reference lengths', () => {
    for (const alpha of [0.01, 0.3, 0.5, 0.9, 0.999]) {
      expect(correct(alpha, 1)).to.be.closeTo(alpha, 1e-15);
      expect(correct(alpha, 2)).to.be.closeTo(over(alpha, alpha), 1e-15);
      expect(correct(alpha, 3)).to.be.closeTo(over(over(alpha, alpha), alpha), 1e-15);
    }
    expect(correct(0.75, 0.5)).to.be.closeTo(0.5, 1e-15);
  });

  it('keeps its relative precision from 1e-6 (and 1e-18) to 1', () => {
    for (let exponent = -6; exponent < 0; exponent++) {
      const alpha = 10 ** exponent;
      for (const ratio of [1e-3, 0.1, 0.5, 7]) {
        // The series of 1 - (1 - a)^r to the third order in a; the next term is below a^4 (r + 1)^4.
        const r = ratio;
        const series = r * alpha - ((r * (r - 1)) / 2) * alpha ** 2 + ((r * (r - 1) * (r - 2)) / 6) * alpha ** 3;
        const rest = (alpha * (r + 1)) ** 4 + 1e-14 * series;
        expect(correct(alpha, ratio), `${alpha} over ${ratio}`).to.be.closeTo(series, rest);
      }
    }
    expect(correct(1e-18, 0.25) / 0.25e-18).to.be.closeTo(1, 1e-14);
    expect(correct(1 - 1e-12, 2)).to.be.closeTo(1, 1e-15);
  });

  it('of two half steps, or of a hundred substeps, is that of one step', () => {
    for (const alpha of [1e-6, 1e-3, 0.2, 0.8, 0.9999]) {
      const half = correct(alpha, 0.5 * 0.37);
      const whole = correct(alpha, 0.37);
      expect(over(half, half) / whole).to.be.closeTo(1, 1e-12);
      const part = correct(alpha, 0.0037);
      let sum = 0;
      for (let i = 0; i < 100; i++) sum = over(sum, part);
      expect(sum / whole).to.be.closeTo(1, 1e-12);
    }
  });

  it('leaves 0 and 1 what they are over any length, and makes nothing of no length', () => {
    for (const ratio of [1e-9, 1, 1e9]) {
      expect(correct(0, ratio)).to.equal(0);
      expect(correct(1, ratio)).to.equal(1);
    }
    expect(correct(1, 0)).to.equal(0);
    expect(correct(0.5, 0)).to.equal(0);
    expect(correct(0.5, NaN)).to.equal(0);
  });

  it('is Beer and Lambert of the extinction', () => {
    expect(extinction(1 - Math.exp(-0.7))).to.be.closeTo(0.7, 1e-15);
    expect(1 - Math.exp(-extinction(0.3) * 2.5)).to.be.closeTo(correct(0.3, 2.5), 1e-15);
    expect(extinction(1)).to.equal(Infinity);
  });
});
