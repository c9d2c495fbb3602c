import { expect } from '@esm-bundle/chai';
import { chooseDomain } from '../../../src/editor/transfer-function-axes.ts';
import { finishVolume } from '../../../src/formats/finish-volume.ts';
import { niftiTypes } from '../../../src/formats/base/number-types.ts';
import { storeSamples } from '../../../src/formats/base/store-samples.ts';
import { buildDefaultPreset } from '../../../src/optics/transfer/default-preset.ts';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import { extinction } from '../../../src/optics/transfer/opacity.ts';
import { castSceneRay, opticsOf } from '../../../src/optics/reference.ts';
import { intersectUnitCube, rayThrough } from '../../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../../src/optics/rays/rays.ts';
import { windowFromHistogram } from '../../../src/optics/transfer/window.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import { summarize } from '../../../src/volume/histogram.ts';
import { length, scale, scaleAndTranslate } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { checkMosaicLayout, cutMosaic } from '../../../src/volume/mosaic.ts';
import { expectError, roomyLimits } from '../../helpers/decode.ts';
import { extremes } from '../../helpers/extremes.ts';
import { height, plainOptics, raysOf, width } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

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
        pixels.forEach((pixel, i) =>
          pixel.forEach((x, c) => expect(x, `pixel ${i}`).to.be.closeTo(other[i][c], near!)),
        );
      }
    });
  }
});

describe('rays along an axis, and next to it', () => {
  const volume = syntheticVolume({ dimensions: [1, 1, 1], kind: 'float32', field: () => 0.5 });
  const stop = { value: 0, color: [1, 1, 1] as const, opacity: 0.5 };
  const scene = {
    ...volume,
    transferFunction: [stop],
    referenceLength: 1,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength: 0.1,
  };
  const setup = {
    eyeT: -Infinity,
    diameter: 1,
    unitToRegion: scaleAndTranslate([1, 1, 1], [0, 0, 0]),
  } as unknown as RaySetup;
  const optics = opticsOf(scene);
  const cast = (point: Vector3, direction: Vector3) =>
    castSceneRay(scene, setup, { point, direction, lengthPerT: length(direction) }, optics);

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
        else
          expect(Math.min(Math.abs(alpha), Math.abs(alpha - 0.5), Math.abs(alpha - (1 - Math.SQRT1_2)))).to.be.below(
            1e-6,
          );
      }
    }
  });
});

describe('what comes before the picture at the extremes', () => {
  const storeFloats = (...values: number[]) =>
    storeSamples(new Uint8Array(Float32Array.of(...values).buffer), niftiTypes.get(16)!, true, {
      slope: 1,
      intercept: 0,
    });

  it("files' infinities become no data, as NaN is", () => {
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
    // A graphics processor may take denormals for 0, so samples are shares.
    const { samples, scale, offset } = storeFloats(denormal, -denormal, 0);
    expect(Array.from(samples, (sample) => sample * scale + offset)).to.deep.equal([denormal, -denormal, 0]);
    expect(Math.min(...Array.from(samples, Math.abs).filter((size) => size > 0))).to.be.above(2 ** -100);
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

  it('a constant volume has a window around its value, of numbers that differ', () => {
    for (const value of [0, 1, -32768, 1e-42, 1e17, -1e30, 1e300, Number.MAX_VALUE, -Number.MAX_VALUE]) {
      const { histogram, range } = summarize(Float32Array.of(0, 0), 1, value);
      const [low, high] = windowFromHistogram(histogram);
      expect(range).to.deep.equal([value, value]);
      expect(high - low, String(value))
        .to.be.above(0)
        .and.below(Infinity);
      expect(value).to.be.within(low, high);
      for (const stop of buildDefaultPreset([low, high])) expect(stop.value).to.be.within(low, high);
      const domain = chooseDomain(histogram, {
        transferFunction: [{ value, color: [1, 1, 1], opacity: 1 }],
        window: [value, value],
      });
      expect(domain[1] - domain[0], 'of the editor')
        .to.be.above(0)
        .and.below(Infinity);
    }
  });

  /** What doubles are stored as, told again. */
  const distinguishDoubles = (values: readonly number[]): { reported: number[]; scale: number } => {
    const { samples, scale, offset } = storeSamples(
      new Uint8Array(Float64Array.from(values).buffer),
      niftiTypes.get(64)!,
      true,
      { slope: 1, intercept: 0 },
    );
    return { reported: Array.from(samples, (sample) => sample * scale + offset), scale };
  };

  it('doubles that are all the same are kept to their last digit', () => {
    for (const value of [1e17, 1e300, -1e300, 0.1, 1.7e308, 1e-320])
      expect(distinguishDoubles([value, NaN, value, value]).reported, String(value)).to.deep.equal([
        value,
        NaN,
        value,
        value,
      ]);
  });

  it('doubles that are all the same are in units in which float32 can hold the window around them', () => {
    for (const value of [1e17, 1e40, -1e300, 1.7e308])
      expect(2 ** -20 * (Math.abs(value) / distinguishDoubles([value, value]).scale), String(value)).to.be.within(
        1e-10,
        1e12,
      );
  });

  it('doubles far from 0 keep their differences, to the last digit that they have; what doubles do not distinguish is one value', () => {
    for (const [far, unit] of [
      [1e17, 16],
      [-1e17, 16],
      [1e300, 2 ** 944],
    ] as const) {
      const values = Array.from({ length: 64 }, (_, i) => far + unit * (i % 5));
      expect(new Set(values).size, 'of the file').to.equal(5);
      expect(distinguishDoubles(values).reported, String(far)).to.deep.equal(values);
    }
    expect(new Set(distinguishDoubles(Array.from({ length: 64 }, (_, i) => 1e17 + i / 64e3)).reported)).to.deep.equal(
      new Set([1e17]),
    );
  });

  it('says in words where values are too far apart, and takes those that differ by less than numbers can for one', async () => {
    const grid = cartesianGrid([4, 4, 4], axialIndexToWorld([4, 4, 4], [1, 1, 1]));
    const load = (type: number, values: Float64Array | BigInt64Array): Promise<unknown> => {
      const {
        samples,
        scale: slope,
        offset: intercept,
      } = storeSamples(new Uint8Array(values.buffer as ArrayBuffer), niftiTypes.get(type)!, true, {
        slope: 1,
        intercept: 0,
      });
      return finishVolume({ grid, samples, slope, intercept, unit: '', format: 'NIfTI-1' }, roomyLimits);
    };
    const doubles = (value: (i: number) => number): Float64Array =>
      Float64Array.from({ length: 64 }, (_, i) => value(i));
    expect(
      (
        await expectError(
          load(
            64,
            doubles((i) => (i % 2 ? 1e308 : -1e308)),
          ),
        )
      ).message,
    ).to.match(/from -9\.9+\d*e\+307 to 9\.9+\d*e\+307, which lie too far apart/);
    expect(
      await load(
        1024,
        BigInt64Array.from({ length: 64 }, (_, i) => 2n ** 62n + BigInt(i)),
      ),
    ).to.deep.include({ range: [2 ** 62, 2 ** 62] });
    for (const value of [1e17, 1e300])
      expect(
        await load(
          64,
          doubles(() => value),
        ),
      ).to.deep.include({ range: [value, value] });
    expect(
      await load(
        1024,
        BigInt64Array.from({ length: 64 }, () => 2n ** 62n),
      ),
    ).to.deep.include({ range: [2 ** 62, 2 ** 62] });
  });
});
