import { expect } from '@esm-bundle/chai';
import { encodeValues, LossySum, unused, ValueRange } from '../../../src/prepare/video-codes.ts';
import type { CodeScale } from '../../../src/prepare/video-codes.ts';

const values = (...list: number[]): Float64Array => Float64Array.from(list);

function scaleOf(frames: readonly (readonly [number[], number])[], isLossy: boolean): CodeScale {
  const range = new ValueRange();
  for (const [list, step] of frames) range.add(values(...list), step);
  return range.scale(isLossy);
}

/** Values after a codec that adds some numbers to the codes. */
const decode = (codes: Uint8Array, { slope, intercept, noDataBelow }: CodeScale): number[] =>
  Array.from(codes, (code) => (code < noDataBelow ? NaN : slope * code + intercept));

describe('values as numbers of a video', () => {
  it('keep their steps where these have room, with and without places that have no data', () => {
    for (const isLossy of [false, true]) {
      for (const list of [
        [-32, -31.5, 10, 60],
        [-32, NaN, 10, 60.5],
      ]) {
        const scale = scaleOf([[list, 0.5]], isLossy);
        expect(scale.slope).to.equal(0.5);
        expect(decode(encodeValues(values(...list), scale), scale)).to.deep.equal(list);
      }
    }
  });

  it('get as many steps as there are codes where they have no room, and all frames the same', () => {
    const frames = [
      [[0, 1000, NaN], 1],
      [[200, 2000, 5], 1],
    ] as const;
    const scale = scaleOf(frames as never, false);
    expect(scale.slope).to.be.closeTo(2000 / 254, 1e-12);
    expect([...encodeValues(values(0, 2000, NaN), scale)]).to.deep.equal([1, 255, 0]);
    expect(scaleOf(frames as never, true).first).to.be.above(20);
  });

  it('frames of different steps, or of steps that begin elsewhere, share no steps', () => {
    expect(
      scaleOf(
        [
          [[0, 1], 1],
          [[0, 0.5], 0.5],
        ],
        false,
      ).slope,
    ).to.be.closeTo(1 / 255, 1e-12);
    expect(
      scaleOf(
        [
          [[0, 100], 1],
          [[0.25, 3.25], 1],
        ],
        false,
      ).slope,
    ).to.be.closeTo(100 / 255, 1e-12);
  });

  it('pixels that are no place of the volume change neither the scale nor the error', () => {
    const scale = scaleOf([[[100, 200, unused], 1]], true);
    expect(scale).to.deep.equal(scaleOf([[[100, 200], 1]], true));
    const sum = new LossySum(scale);
    const codes = encodeValues(values(100, 200, unused), scale);
    codes[2] = 77;
    sum.add(values(100, 200, unused), codes);
    expect([sum.error.max, sum.changed]).to.deep.equal([0, 0]);
  });

  it('a constant, and nothing at all, have a scale', () => {
    expect(
      decode(encodeValues(values(7, 7), scaleOf([[[7, 7], 2]], true)), scaleOf([[[7, 7], 2]], true)),
    ).to.deep.equal([7, 7]);
    expect(scaleOf([[[NaN, NaN], 1]], true).slope).to.equal(1);
  });

  it('the error is that of the differences, and places that gain or lose data are counted apart', () => {
    const scale: CodeScale = { slope: 2, intercept: -48, first: 24, noDataBelow: 12 };
    const sum = new LossySum(scale);
    const before = values(...Array.from({ length: 200 }, (_, i) => i), NaN, NaN, 100);
    const codes = encodeValues(before, scale);
    codes[0] += 3;
    codes[1] -= 1;
    codes[200] = 9; // Still none.
    codes[201] = 15;
    codes[202] = 3;
    sum.add(before, codes);
    expect(sum.changed).to.equal(2);
    const after = decode(codes, scale);
    const off = Array.from(before, (value, i) => Math.abs(after[i] - value)).filter((one) => one === one);
    off.sort((a, b) => a - b);
    expect(sum.error.max).to.equal(off.at(-1));
    expect(sum.error.rms).to.be.closeTo(Math.sqrt(off.reduce((all, one) => all + one * one, 0) / off.length), 1e-12);
    expect(sum.error.p99).to.be.within(
      off[Math.ceil(0.99 * off.length) - 1],
      off[Math.ceil(0.99 * off.length) - 1] + 2 / 64,
    );
  });
});
