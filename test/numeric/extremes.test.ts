import { expect } from '@esm-bundle/chai';
import { niftiTypes } from '../../src/formats/number-types.ts';
import { storeSamples } from '../../src/formats/store-samples.ts';
import { interpolate } from '../../src/optics/interpolate.ts';
import { extinction } from '../../src/optics/opacity.ts';
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import { intersectUnitCube, rayThrough } from '../../src/optics/rays.ts';
import type { RaySetup } from '../../src/optics/rays.ts';
import { windowFromHistogram } from '../../src/optics/window.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { length, scale, scaleAndTranslate } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { checkMosaicLayout, cutMosaic } from '../../src/volume/mosaic.ts';
import { extremes } from '../helpers/extremes.ts';
import { height, plainOptics, raysOf, width } from '../helpers/picture.ts';
import type { View } from '../helpers/picture.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

/** Only one pixel in so many, across and down, is cast. */
const every = 4;

/** A sparse picture in float64, 0..255, and the world length of each of its rays inside the volume. */
function castSparsely(view: View): { pixels: number[][]; lengths: number[] } {
  const rays = raysOf(view);
  const { volume, stepLength, optics = plainOptics } = view;
  const scene = { ...volume, ...optics, stepLength };
  const rayOptics = opticsOf(scene);
  const pixels: number[][] = [];
  const lengths: number[] = [];
  for (let row = 1; row < height; row += every) {
    for (let column = 1; column < width; column += every) {
      const ray = rayThrough(rays, ((column + 0.5) / width) * 2 - 1, 1 - ((row + 0.5) / height) * 2);
      const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
      lengths.push(Math.max(0, exit - Math.max(entry, rays.eyeT)) * ray.lengthPerT * rays.diameter);
      pixels.push(castSceneRay(scene, rays, ray, rayOptics).map((x) => x * 255));
    }
  }
  return { pixels, lengths };
}

describe('the reference at the extremes', () => {
  for (const { name, view, alpha, same, near } of extremes) {
    it(name, () => {
      const { pixels, lengths } = castSparsely(view);
      for (const pixel of pixels) {
        for (const x of pixel) expect(x, pixel.join(' ')).to.be.within(0, 255 * (1 + 1e-12));
        expect(Math.max(...pixel.slice(0, 3)), 'no channel above its opacity').to.be.at.most(pixel[3] * (1 + 1e-12));
      }
      if (alpha) {
        lengths.forEach((length, i) => {
          const expected = alpha(length) * 255;
          // Relative as well: 1e-6 of opacity 1 is to be no less precise than 1.
          expect(pixels[i][3], `ray of ${length}`).to.be.closeTo(expected, 1e-6 * expected + 1e-12);
        });
      }
      if (same) {
        const other = castSparsely(same).pixels;
        expect(Math.max(...other.flat()), 'the moderate picture shows something').to.be.above(20);
        pixels.forEach((pixel, i) => pixel.forEach((x, c) => expect(x, `pixel ${i}`).to.be.closeTo(other[i][c], near!)));
      }
    });
  }
});

describe('rays along an axis, and next to it', () => {
  const volume = syntheticVolume({ dimensions: [1, 1, 1], kind: 'float32', field: () => 0.5 });
  const stop = { value: 0, color: [1, 1, 1] as const, opacity: 0.5 };
  const scene = { ...volume, transferFunction: [stop], referenceLength: 1, opacityFactor: 1, lightFactor: 1, stepLength: 0.1 };
  const setup = { eyeT: -Infinity, diameter: 1, unitToRegion: scaleAndTranslate([1, 1, 1], [0, 0, 0]) } as unknown as RaySetup;
  const cast = (point: Vector3, direction: Vector3) => castSceneRay(scene, setup, { point, direction, lengthPerT: length(direction) });

  it('cross as much of the cube as lies ahead', () => {
    for (const axis of [0, 1, 2]) {
      for (const sign of [1, -1]) {
        for (const off of [0, -0, 1e-7, -1e-7, 1e-9, 1e-12, 1e-300]) {
          const direction = [0, 1, 2].map((i) => (i === axis ? sign : off)) as unknown as Vector3;
          const alpha = cast([0.5, 0.5, 0.5], scale(direction, 3))[3];
          expect(alpha, direction.join(' ')).to.be.closeTo(1 - Math.exp(-extinction(0.5)), 1e-9);
        }
      }
    }
  });

  it('in the plane of a face are pushed aside by 1e-9, and see the cube or not, but nothing else', () => {
    // Exactly in a face there is no right answer: half of the rays beside it are inside.
    for (const face of [0, 1]) {
      for (const off of [0, 1e-7, -1e-7]) {
        const alpha = cast([face, 0.5, 0.5], [off, 1, 0])[3];
        const inside = face === 0 ? off : -off;
        if (inside !== 0) expect(alpha).to.be.closeTo(1 - Math.exp(-extinction(0.5) / 2), 1e-6);
        else expect(Math.min(Math.abs(alpha), Math.abs(alpha - 0.5), Math.abs(alpha - (1 - Math.SQRT1_2)))).to.be.below(1e-6);
      }
    }
  });
});

describe('what comes before the picture at the extremes', () => {
  const storeFloats = (...values: number[]) =>
    storeSamples(new Uint8Array(Float32Array.of(...values).buffer), niftiTypes.get(16)!, true, { slope: 1, intercept: 0 });

  it('files\' infinities become no data, as NaN is', () => {
    expect([...storeFloats(1, Infinity, -Infinity, NaN, -2).samples]).to.deep.equal([1, NaN, NaN, NaN, -2]);
  });

  it('a volume that has infinities all the same treats them as no data', () => {
    const samples = Float32Array.of(Infinity, 2, 2, -Infinity, 2, 2, 2, 2);
    expect(interpolate(samples, [2, 2, 2], [0.5, 0.5, 0.5])).to.equal(2);
    expect(interpolate(samples, [2, 2, 2], [0.25, 0.25, 0.25])).to.deep.equal(NaN);
    expect(summarize(samples, 1, 0)).to.deep.include({ hasNoData: true, range: [2, 2] });
  });

  it('denormals keep what they are', () => {
    const denormal = Math.fround(1e-42);
    expect([...storeFloats(denormal, -denormal, 0).samples]).to.deep.equal([denormal, -denormal, 0]);
    const { range } = summarize(Float32Array.of(denormal, 0), 1, 0);
    expect(range).to.deep.equal([0, denormal]);
  });

  it('int16 at both ends fills uint16', () => {
    const bytes = new Uint8Array(Int16Array.of(-32768, 0, 32767).buffer);
    const stored = storeSamples(bytes, niftiTypes.get(4)!, true, { slope: 1, intercept: 0 });
    expect([...stored.samples]).to.deep.equal([0, 32768, 65535]);
    expect([stored.scale, stored.offset]).to.deep.equal([1, -32768]);
  });

  it('a mosaic of tiles of one pixel, its last row half empty, is a column of voxels', () => {
    const data = Uint8Array.from({ length: 12 }, (_, i) => i * 20);
    const layout = checkMosaicLayout({ width: 4, height: 3 }, { columns: 4, rows: 3 }, 10);
    expect([...cutMosaic({ width: 4, height: 3, data }, layout)]).to.deep.equal([...data.subarray(0, 10)]);
  });

  it('a constant volume has a window, where its value can have neighbours at all', () => {
    for (const value of [0, 1, -32768, 1e-42]) {
      const { histogram } = summarize(Float32Array.of(value, value), 1, 0);
      const [low, high] = windowFromHistogram(histogram);
      expect(low, String(value)).to.be.below(value);
      expect(high).to.be.above(value);
    }
    // Far from 0 it is the value alone; a transfer function over it then is a jump, which has its right limit too.
    const { histogram } = summarize(Float32Array.of(1e30, 1e30), 1, 0);
    expect(windowFromHistogram(histogram)).to.deep.equal([Math.fround(1e30), Math.fround(1e30)]);
  });
});
