// What the programs of accuracy and benchmark measure errors with.
import { expect } from '@esm-bundle/chai';
import { measureThing, measureTrueError } from '../../accuracy/compare-shown.ts';
import { compareCovered } from '../../helpers/covered-error.ts';

const side = 40;

/** A picture of one colour in its lower half, with nothing above. */
function halfPicture(value: number): Float32Array {
  const picture = new Float32Array(4 * side * side);
  return picture.fill(value, 0, 2 * side * side);
}

describe('the error over what a volume covers', () => {
  it('leaves the background out', () => {
    const { rms, p99, max, e, covered } = compareCovered(halfPicture(100), halfPicture(103), 1);
    expect({ rms, p99, max, e, covered }).to.deep.equal({ rms: 3, p99: 3, max: 3, e: 3, covered: (side * side) / 2 });
  });

  it('counts what one of two pictures covers alone', () => {
    expect(compareCovered(halfPicture(0), halfPicture(10), 1).rms).to.equal(10);
  });

  it('counts three channels of pictures over black', () => {
    const [a, b] = [halfPicture(100), halfPicture(100)];
    for (let i = 3; i < a.length; i += 4) b[i] = 0;
    expect(compareCovered(a, b, 1, 3).max).to.equal(0);
    expect(compareCovered(a, b, 1, 4).rms).to.equal(50);
  });

  it('is an eighth of what one pixel in a thousand exceeds, where that is more than the root mean square', () => {
    const [a, b] = [halfPicture(100), halfPicture(100)];
    for (const pixel of [3, 500, 700]) b[4 * pixel] = 180; // Three of 800, in one of four channels.
    const { rms, p999, e } = compareCovered(a, b, 1);
    expect(rms).to.be.closeTo(80 * Math.sqrt(3 / 3200), 1e-9);
    expect([p999, e]).to.deep.equal([80, 10]);
  });

  it('takes the nearer of full rays that are not sure', () => {
    const shown = Uint8Array.from(halfPicture(128));
    const [near, far] = [halfPicture(130 / 255), halfPicture(1)];
    expect(measureTrueError(shown, far).max).to.be.closeTo(127, 1e-4);
    expect(measureTrueError(shown, far, near).max).to.be.closeTo(2, 1e-4);
  });
});

describe('what is left of a small thing', () => {
  const bare = halfPicture(0.2);
  const at = 4 * (10 * side + 12);
  const withThing = (strength: number): Float32Array => {
    const picture = bare.slice();
    for (const [offset, share] of [
      [0, 1],
      [4, 0.9],
      [8, 0.3],
    ])
      for (let c = 0; c < 4; c++) picture[at + offset + c] += strength * share;
    return picture;
  };
  const compare = (
    strength: number,
    around: readonly [number, number] = [12.5, 10.5],
  ): ReturnType<typeof measureThing> => {
    const shown = Uint8Array.from(withThing(strength), (x) => Math.round(255 * x));
    return measureThing({ shown, full: withThing(0.4), bare, size: side }, around, 3);
  };

  it('is the share of its contrast', () => {
    for (const share of [0, 0.25, 0.5, 1, 1.5]) expect(compare(0.4 * share)!.kept).to.be.closeTo(share, 0.01);
    expect(compare(0.4)!.contrast).to.be.closeTo(102, 1e-3);
  });

  it('is nothing where full rays show nothing, and unknown at the rim', () => {
    expect(compare(0.4, [30.5, 10.5])).to.equal(null);
    expect(compare(0.4, [1, 10.5])).to.equal(null);
  });
});
