import { expect } from '@esm-bundle/chai';
import { SteadyTime } from '../../../src/quality/steady-time.ts';

describe('what a frame takes as a rule', () => {
  it("is the clock's word where the GPU's time is not known", () => {
    const time = new SteadyTime();
    expect([40, 12, 90].map((ms) => time.of(ms, null))).to.deep.equal([40, 12, 90]);
  });

  it("is the GPU's time and the usual wait: a frame that a busy page held up takes the time of the others", () => {
    const time = new SteadyTime();
    for (const gpu of [10, 20, 30, 10]) expect(time.of(gpu + 4, gpu)).to.equal(gpu + 4);
    expect(time.of(120, 20), 'held up by 96 ms').to.equal(24);
    expect(time.of(31, 30), 'sooner than usual: no longer than it took').to.equal(31);
  });

  it('follows a page in which waits have become longer, within eight frames', () => {
    const time = new SteadyTime();
    for (let frame = 0; frame < 8; frame++) time.of(14, 10);
    expect(time.of(30, 10)).to.equal(14);
    for (let frame = 0; frame < 6; frame++) time.of(30, 10);
    expect(time.of(30, 10)).to.equal(30);
  });

  it('is never less than nothing besides, where two clocks disagree', () => {
    const time = new SteadyTime();
    expect(time.of(10, 10.5)).to.equal(10);
    expect(time.of(30, 20), 'the median of 0 and 10').to.equal(25);
  });
});
