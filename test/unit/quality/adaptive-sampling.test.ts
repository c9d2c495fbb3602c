import { expect } from '@esm-bundle/chai';
import { emptyQuad, interpolateQuad } from '../../../src/optics/rays/between-pixels.ts';
import type { Pixels } from '../../../src/optics/rays/between-pixels.ts';
import { predictSampling } from '../../../src/quality/adaptive-sampling.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

function paint(width: number, height: number, color: (x: number, y: number, channel: number) => number): Pixels {
  const data = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++)
      for (let c = 0; c < 4; c++) data[4 * (y * width + x) + c] = Math.round(color(x, y, c));
  }
  return { data, width, height };
}

/** A picture drawn with adaptive ray sampling as the shader does it, with its cost; rays get the picture's own pixels. */
function drawAdaptively(picture: Pixels, maxCurvature: number): { picture: Float64Array; share: number } {
  const { width, height } = picture;
  const known = { data: Float64Array.from(picture.data), width, height };
  let cast = (width * height) / 16;
  for (const stride of [2, 1]) {
    const before = { ...known, data: known.data.slice() };
    const quad = emptyQuad();
    for (let y = 0; y < height / (2 * stride); y++) {
      for (let x = 0; x < width / (2 * stride); x++) {
        interpolateQuad(before, 2 * stride, [x, y], quad);
        if (quad.curvature > maxCurvature) {
          cast += 4;
          continue;
        }
        for (let i = 1; i < 4; i++) {
          const at = 4 * stride * ((2 * y + (i >> 1)) * width + 2 * x + (i & 1));
          for (let c = 0; c < 4; c++) known.data[at + c] = Math.round(quad.colors[4 * i + c]);
        }
      }
    }
  }
  return { picture: known.data, share: cast / (width * height) };
}

function rms(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / a.length);
}

/** Soft hills with a sharp edge across, seen everywhere. */
const hills = paint(256, 192, (x, y, c) => {
  const hill = 90 + 50 * Math.sin(x / (11 + 3 * c)) * Math.cos(y / 13) + 20 * Math.sin((x + 2 * y) / 4);
  return x + 0.3 * y > 150 ? hill : hill / 3;
});

describe('pixels between others', () => {
  it('are exact where the picture is a polynomial of third degree', () => {
    const cubic = (x: number, y: number, c: number): number =>
      3 + x - 2 * y + 0.3 * x * x - 0.2 * x * y + 0.1 * y * y + 0.01 * (x ** 3 - x * x * y + (c - 2) * y ** 3);
    const [width, height] = [12, 10];
    const data = Float64Array.from({ length: 4 * width * height }, (_, i) =>
      cubic((i >> 2) % width, Math.floor((i >> 2) / width), i & 3),
    );
    const quad = emptyQuad();
    for (let y = 1; y < 3; y++) {
      for (let x = 1; x < 4; x++) {
        interpolateQuad({ data, width, height }, 2, [x, y], quad);
        for (let i = 0; i < 16; i++) {
          const expected = cubic(2 * x + ((i >> 2) & 1), 2 * y + (i >> 3), i & 3);
          expect(quad.colors[i], `${x} ${y} ${i}`).to.be.closeTo(expected, 1e-10);
        }
      }
    }
  });

  it('have the largest second difference around them as curvature, and none on a slope', () => {
    const quad = emptyQuad();
    const slope = paint(16, 16, (x, y) => 20 + 3 * x + 5 * y);
    interpolateQuad(slope, 2, [3, 3], quad);
    expect(quad.curvature).to.equal(0);
    const spike = { ...slope, data: Uint8Array.from(slope.data) };
    spike.data[4 * (6 * 16 + 10) + 2] += 30; // Right of the quad's right known pixels.
    interpolateQuad(spike, 2, [3, 3], quad);
    expect(quad.curvature).to.equal(30);
    interpolateQuad(spike, 2, [1, 3], quad);
    expect(quad.curvature, 'out of reach').to.equal(0);
  });
});

describe('the effect of adaptive sampling', () => {
  it('is predicted from the whole picture: rays cast, and the error that is left', () => {
    const outcomes = predictSampling(hills);
    for (const maxCurvature of [8, 16, 32, 64]) {
      const foretold = outcomes.find((one) => one.maxCurvature === maxCurvature)!;
      const { picture, share } = drawAdaptively(hills, maxCurvature);
      expect(foretold.share / share, `share at ${maxCurvature}`).to.be.within(0.85, 1.2);
      expect(foretold.error - rms(picture, hills.data), `error at ${maxCurvature}`).to.be.within(-0.25, 0.35);
    }
    const shares = outcomes.map(({ share }) => share);
    expect(shares[0]).to.be.above(2 * shares[shares.length - 1]);
  });

  it('is nothing good where neighbours have nothing in common', () => {
    const random = randomNumbers(5);
    const outcomes = predictSampling(paint(128, 128, () => 60 + 120 * random()));
    expect(outcomes[0].share).to.be.within(1.25, 1.35);
  });

  it('saves all but a sixteenth of the rays without curvature, and is not predicted for an empty picture', () => {
    const [first] = predictSampling(paint(128, 128, (x, y) => 50 + x / 2 + y / 2));
    expect(first.share).to.be.closeTo(1 / 16, 1e-9);
    expect(first.error).to.be.below(0.3);
    expect(predictSampling(paint(64, 64, () => 0))).to.deep.equal([]);
  });
});
