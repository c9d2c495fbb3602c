// How values look, as far as it matters for what bricks bring to a picture.
import { expect } from '@esm-bundle/chai';
import { plainMaterial } from '../../../../src/optics/transfer/lights.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import type { Stop } from '../../../../src/optics/transfer/transfer-function.ts';
import { extremeOf, lightOf, paintedOf, seenValues } from '../../../../src/viewer/loading/brick-looks.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Volume } from '../../../../src/volume/volume.ts';

const fog: readonly Stop[] = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 100, color: [0, 0, 1], opacity: 0.2 },
];
const optics: VolumeOptics = {
  transferFunction: fog,
  window: [0, 100],
  referenceLength: 3,
  opacityFactor: 1,
  lightFactor: 1,
  projection: null,
  shading: 'unlit',
  surfaces: null,
};
const skin = { value: 30, color: [1, 0.8, 0.7], opacity: 0.3 } as const;
const bone = { value: 70, color: [1, 1, 0.9], opacity: 1 } as const;
const volume = { range: [0, 100], slope: 1, intercept: 0 } as unknown as Volume;
const grid = cartesianGrid([10, 20, 40], axialIndexToWorld([10, 20, 40], [1, 1, 1]));

const opacityAt = (looks: VolumeOptics, value: number): number => evaluate(seenValues(volume, looks, 50)[0], value)[3];

describe('what bricks are asked for by', () => {
  it('is the fog in front of an opaque surface, and the surface', () => {
    const both = { ...optics, surfaces: { surfaces: [skin, bone] } } as VolumeOptics;
    expect(opacityAt(both, 35)).to.be.closeTo(0.07, 1e-6);
    expect(opacityAt(both, 69.9)).to.be.closeTo(0.14, 1e-3);
    expect(opacityAt(both, 70)).to.equal(1);
    expect(evaluate(seenValues(volume, both, 50)[0], 95).slice(0, 3)).to.deep.equal([1, 1, 0.9]);
  });

  it('is the opaque one of several surfaces in nothing, where a translucent one lies around it', () => {
    const alone = { ...optics, surfaces: { surfaces: [skin, bone], clear: true } } as VolumeOptics;
    expect(opacityAt(alone, 69)).to.equal(0);
    expect(opacityAt(alone, 70)).to.equal(1);
    const onlySkin = { ...optics, surfaces: { surfaces: [skin], clear: true } } as VolumeOptics;
    expect(opacityAt(onlySkin, 30)).to.equal(1);
  });

  it('is light, where there is some', () => {
    expect(lightOf(optics, grid)).to.equal(undefined);
    expect(lightOf({ ...optics, shading: 'lit' }, grid)!.voxel).to.deep.equal([1 / 10, 1 / 20, 1 / 40]);
    expect(lightOf({ ...optics, surfaces: { surfaces: [bone] } }, grid)!.diffuse).to.equal(plainMaterial.diffuse);
    expect(lightOf({ ...optics, shading: 'lit', projection: 'max' }, grid)).to.equal(undefined);
  });

  it('is the largest or smallest value of a ray, where that is shown', () => {
    expect(extremeOf(optics, volume)).to.equal(undefined);
    expect(extremeOf({ ...optics, projection: 'average' }, volume)).to.equal(undefined);
    const { sign, colorOf } = extremeOf({ ...optics, projection: 'max' }, volume)!;
    expect(sign).to.equal(1);
    expect(colorOf(50)).to.deep.equal([0, 0, 0.5, 0.5]);
    // A larger stored value may be a smaller one of the file.
    const falling = extremeOf({ ...optics, projection: 'max' }, { slope: -1, intercept: 100 })!;
    expect(falling.sign).to.equal(-1);
    expect(falling.colorOf(100)).to.deep.equal([0, 0, 0, 0]);
    expect(extremeOf({ ...optics, projection: 'min' }, volume)!.sign).to.equal(-1);
    // The first one from a value on: a stored value, times the sign.
    const thresholdOf = (projection: 'max' | 'min', slope: number, intercept: number): number | undefined =>
      extremeOf({ ...optics, projection, intensityThreshold: 60 }, { slope, intercept })!.threshold;
    expect(thresholdOf('max', 2, 10)).to.equal(25);
    expect(thresholdOf('min', 2, 10)).to.equal(-25);
    expect(thresholdOf('max', -2, 100)).to.equal(-20);
    expect(extremeOf({ ...optics, projection: 'max' }, volume)!.threshold).to.equal(undefined);
  });

  it('is what planes show: greys of a window, or the colours of what can be seen', () => {
    const plane = { kind: 'plane', normal: [0, 0, 1], offset: 0.5, slab: null } as const;
    const greyAt = (value: number): number[] => {
      const means = new Float64Array(11);
      paintedOf({ ...plane, window: [20, 80] }, optics, [0, 100], volume).sums.addMeans(value, value, 1, means);
      return [...means.slice(0, 4)];
    };
    for (const [value, grey] of [
      [10, 0],
      [50, 0.5],
      [90, 1],
    ])
      greyAt(value).forEach((x, c) => expect(x, `${value}`).to.be.closeTo(c < 3 ? grey : 1, 1e-3));
    const ofClear = { ...optics, transferFunction: [{ ...fog[0], value: 40 }, ...fog.slice(1)] };
    const colored = paintedOf({ ...plane, window: null }, ofClear, [0, 100], volume);
    expect(colored.sums.meanOpacity(30, 30)).to.equal(0);
    expect(colored.sums.meanOpacity(60, 60)).to.be.closeTo(1, 1e-6);
  });

  it('is the own colours of a plane, also in a projection and among surfaces', () => {
    const plane = { kind: 'plane', normal: [0, 0, 1], offset: 0.5, slab: null, window: null } as const;
    for (const more of [{ projection: 'max' } as const, { surfaces: { surfaces: [bone], clear: true } }]) {
      const means = new Float64Array(11);
      paintedOf(plane, { ...optics, ...more } as VolumeOptics, [0, 100], volume).sums.addMeans(90, 90, 1, means);
      [0, 0, 1].forEach((x, c) => expect(means[c]).to.be.closeTo(x, 1e-6));
    }
  });
});
