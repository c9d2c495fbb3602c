import { expect } from '@esm-bundle/chai';
import { histogramBins, summarize } from '../../../src/volume/histogram.ts';

const total = (counts: Uint32Array): number => counts.reduce((sum, n) => sum + n, 0);

describe('a histogram', () => {
  it('counts every valid sample once, the largest in the last bin', () => {
    const { histogram, range, hasNoData } = summarize(new Uint8Array([0, 0, 1, 128, 255, 255, 255]), 1, 0);
    expect(range).to.deep.equal([0, 255]);
    expect(hasNoData).to.equal(false);
    expect(total(histogram.counts)).to.equal(7);
    expect([histogram.counts[0], histogram.counts[1], histogram.counts[128], histogram.counts[255]]).to.deep.equal([
      2, 1, 1, 3,
    ]);
  });

  it('is in data units, low to high, also where the slope is negative', () => {
    const { histogram, range } = summarize(new Uint16Array([0, 0, 0, 1000]), -2, 100);
    expect(range).to.deep.equal([-1900, 100]);
    expect([histogram.low, histogram.high]).to.deep.equal([-1900, 100]);
    expect(histogram.counts[0]).to.equal(1);
    expect(histogram.counts[histogramBins - 1]).to.equal(3);
  });

  it('leaves NaN and infinities out and says so', () => {
    const { histogram, range, hasNoData } = summarize(new Float32Array([NaN, -1, 3, Infinity, -Infinity]), 1, 0);
    expect(range).to.deep.equal([-1, 3]);
    expect(hasNoData).to.equal(true);
    expect(total(histogram.counts)).to.equal(2);
  });

  it('holds for constant and for empty data', () => {
    const constant = summarize(new Uint8Array([7, 7, 7]), 2, 1);
    expect(constant.range).to.deep.equal([15, 15]);
    expect(total(constant.histogram.counts)).to.equal(3);
    const nothing = summarize(new Float32Array([NaN, NaN]), 2, 1);
    expect(nothing.range).to.deep.equal([1, 1]);
    expect(total(nothing.histogram.counts)).to.equal(0);
  });
});
