import { expect } from '@esm-bundle/chai';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import type { PictureError } from '../../../src/quality/error-estimate.ts';
import { changeOfColors, includePart, scaleLoss } from '../../../src/quality/include-loss.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const steps: PictureError = { rms: 0.3, p99: 1, max: 4, probed: 2, rays: 900 };

/** From transparent black to white. */
const ramp = (from: number, to: number, opacity = 0.9): TransferFunction => [
  { value: from, color: [0, 0, 0], opacity: 0 },
  { value: to, color: [1, 1, 1], opacity },
];

const volume = syntheticVolume({ dimensions: [12, 12, 12], slope: 255 });
const look = (transferFunction: TransferFunction, opticalScale = 0.01) => ({ transferFunction, opticalScale });
const usual = look(ramp(0, 255));
const lossy = { rms: 2, p99: 6, max: 20, picture: { rms: 1.5, p99: 5, max: 9 } };

describe('the error of a picture with one more cause', () => {
  it('adds squares, and the largest ones; what the steps leave stays known', () => {
    const whole = includePart(steps, 'lossy', { rms: 0.4, p99: 2, max: 10 });
    expect(whole.rms).to.be.closeTo(0.5, 1e-12);
    expect(whole).to.deep.include({ p99: 3, max: 14, probed: 2, rays: 900 });
    expect(whole.parts).to.deep.equal({
      steps: { rms: 0.3, p99: 1, max: 4 },
      lossy: { rms: 0.4, p99: 2, max: 10 },
    });
  });

  it('has no bound where one of them has none, and none above the full range', () => {
    const part = { rms: 1, p99: 1, max: null };
    expect(includePart(steps, 'lossy', part).max).to.equal(null);
    expect(includePart({ ...steps, max: null }, 'lossy', { ...part, max: 1 }).max).to.equal(null);
    expect(includePart({ ...steps, max: 250 }, 'lossy', { ...part, max: 200 }).max).to.equal(255);
  });
});

describe('what a lossy form leaves in a picture', () => {
  it('is what was measured, where the colours are those of then', () => {
    expect(scaleLoss(lossy, volume, { now: usual, made: usual })).to.deep.equal({ rms: 1.5, p99: 5, max: null });
  });

  it('grows with the slope of the colours, is nothing where all values have one colour, and is at most all', () => {
    const at = (now: TransferFunction) => scaleLoss(lossy, volume, { now: look(now), made: usual })!.rms;
    expect(at(ramp(60, 190))).to.be.within(1.6 * 1.5, 2.6 * 1.5);
    expect(at(ramp(-255, 510))).to.be.within(0.2 * 1.5, 0.6 * 1.5);
    expect(at(ramp(0, 255).map((stop) => ({ ...stop, opacity: 0.5, color: [1, 1, 1] })))).to.equal(0);
    const worst = { ...lossy, picture: { ...lossy.picture, rms: 200 } };
    expect(scaleLoss(worst, volume, { now: look(ramp(120, 130)), made: usual })!.rms).to.equal(255);
  });

  it('is nothing, with a bound, where no value changed, and not known where no pictures were compared', () => {
    const zero = { rms: 0, p99: 0, max: 0 };
    expect(scaleLoss({ ...zero, picture: zero }, volume, { now: usual, made: usual })).to.deep.equal(zero);
    expect(scaleLoss({ rms: 2, p99: 6, max: 20 }, volume, { now: usual, made: usual })).to.equal(null);
  });

  it('is what was measured where the pictures of then showed nothing', () => {
    const hidden = look(ramp(300, 400));
    expect(scaleLoss(lossy, volume, { now: usual, made: hidden })!.rms).to.equal(1.5);
  });

  it('counts values that are visible, by how many there are', () => {
    const counted = (counts: number[]) => ({
      histogram: { low: 0, high: 2, counts: Uint32Array.from(counts) },
      grid: volume.grid,
    });
    // Of the two bins, at 0.5 and 1.5, the first shows nothing.
    const one: TransferFunction = [
      { value: 1, color: [1, 1, 1], opacity: 0 },
      { value: 2, color: [1, 1, 1], opacity: 0.8 },
    ];
    const seen = changeOfColors(look(one), counted([0, 10]), 0.25);
    expect(seen).to.be.above(0);
    expect(changeOfColors(look(one), counted([1000, 10]), 0.25)).to.equal(seen);
  });
});
