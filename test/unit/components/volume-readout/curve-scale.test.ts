import { expect } from '@esm-bundle/chai';
import {
  drawCurve,
  drawPoints,
  nearestScan,
  placeTimes,
  scaleValues,
} from '../../../../components/volume-readout/curve-scale.ts';

describe('the axes of a curve', () => {
  it('has scans at their times, with round numbers below', () => {
    const { at, ticks } = placeTimes(['0 s', '2 s', '10 s']);
    expect(at).to.deep.equal([0, 0.2, 1]);
    expect(ticks!.unit).to.equal('s');
    expect(ticks!.all.map(({ value }) => value)).to.deep.equal([0, 5, 10]);
    expect(ticks!.all.map(({ at: share }) => share)).to.deep.equal([0, 0.5, 1]);
    expect(placeTimes(['0.5 s', '900 ms', '2.1 s']).at).to.deep.equal([0, 0.25, 1]);
  });

  it('has scans at equal steps where times are unknown, of several units, or not in order', () => {
    for (const times of [
      [null, null, null],
      ['0 s', null, '9 s'],
      ['0 s', '1 Hz', '9 s'],
      ['0 s', '5 s', '5 s'],
      ['0 s', '2018-12-20T06:06:28Z', '9 s'],
    ])
      expect(placeTimes(times), String(times)).to.deep.equal({ at: [0, 0.5, 1], ticks: null });
    expect(placeTimes([null]).at).to.deep.equal([0]);
    const clock = placeTimes(['2018-12-20T06:00:00Z', '2018-12-20T06:10:00Z', '2018-12-20T06:40:00Z']);
    expect(clock).to.deep.equal({ at: [0, 0.25, 1], ticks: null });
  });

  it('goes from a round number below all values to one above', () => {
    const scale = scaleValues([3477.57, NaN, undefined, 3710.28])!;
    expect([scale.low, scale.high, scale.decimals]).to.deep.equal([3400, 3800, 0]);
    expect(scale.ticks.map(({ value }) => value)).to.deep.equal([3400, 3500, 3600, 3700, 3800]);
    const small = scaleValues([-0.012, 0.031])!;
    expect([small.low, small.high, small.decimals]).to.deep.equal([-0.02, 0.04, 2]);
  });

  it('has room around equal values, and is none where there is no value', () => {
    const flat = scaleValues([5, 5])!;
    expect(flat.low).to.be.below(5);
    expect(flat.high).to.be.above(5);
    const zero = scaleValues([0])!;
    expect([zero.low, zero.high]).to.deep.equal([-1, 1]);
    expect(scaleValues([NaN, undefined])).to.equal(null);
    for (const size of [1e-30, 1e30]) {
      const far = scaleValues([size, 2 * size])!;
      expect(far.low).to.be.at.most(size);
      expect(far.high).to.be.at.least(2 * size);
      expect(far.ticks.length).to.be.below(8);
    }
  });
});

describe('a curve', () => {
  const scale = { low: 0, high: 10 };
  it('ends where a value is missing, and a value alone is a point', () => {
    expect(drawCurve([0, 0.25, 0.5, 0.75, 1], [0, 10, NaN, 5, undefined], scale)).to.equal('M0 1L0.25 0M0.75 0.5h0');
    expect(drawCurve([0, 1], [NaN, undefined], scale)).to.equal('');
    expect(drawPoints([0, 0.5, 1], [0, NaN, 10], scale)).to.equal('M0 1h0M1 0h0');
  });

  it('has the scan that is nearest to a place', () => {
    expect([-1, 0.09, 0.11, 0.7, 3].map((share) => nearestScan([0, 0.2, 1], share))).to.deep.equal([0, 0, 1, 2, 2]);
  });
});
