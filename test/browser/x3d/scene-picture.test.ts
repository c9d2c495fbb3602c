import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Camera, Orbit } from '../../../src/optics/rays/camera.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import type { Optics } from '../../../src/renderer/ray/ray-module.ts';
import { casesIn } from '../../helpers/cases.ts';
import { drawAsExpected, expectWalks } from '../../helpers/compare-with-twin.ts';
import { bothWalks, comparePictures, drawPicture, plainOptics, shareScene, withScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { obliqueAffine, randomNumbers, smoothField, syntheticVolume } from '../../helpers/synthetic.ts';
import type { SyntheticOptions } from '../../helpers/synthetic.ts';

interface Case {
  readonly name: string;
  readonly data?: Partial<SyntheticOptions>;
  /** Radius in diagonals of the volume. */
  readonly orbit?: Partial<Orbit>;
  readonly camera?: Camera;
  readonly steps?: number;
  readonly optics?: Partial<Optics>;
}

const random = randomNumbers(20);
const hole = (x: number, y: number, z: number): number =>
  Math.hypot(x - 0.4, y - 0.6, z - 0.5) < 0.25 ? NaN : smoothField(x, y, z);
const amongWhole = (name: string, transferFunction: TransferFunction): Case => ({
  name,
  data: { kind: 'float32', field: (x, y, z) => Math.round(4095 * hole(x, y, z)) - 1000 },
  optics: { transferFunction },
});
const quarter = Math.PI / 2;

const cases: Case[] = [
  { name: '8 bit' },
  { name: '16 bit', data: { kind: 'uint16' } },
  { name: 'float', data: { kind: 'float32' } },
  { name: '16 bit in Hounsfield units', data: { kind: 'uint16', slope: 3000, intercept: -1000 } },
  { name: 'no data', data: { kind: 'float32', field: hole } },
  // Two bytes of a whole number in a texel, with a weight, where the device filters these.
  amongWhole('no data among whole numbers', [
    { value: -900, color: [0.2, 0.5, 1], opacity: 0 },
    { value: 3000, color: [1, 0.9, 0.2], opacity: 0.6 },
  ]),
  amongWhole('no data among whole numbers, opaque from a value on', [
    { value: -1000, color: [0.2, 0.5, 1], opacity: 0 },
    { value: 1100, color: [0.2, 0.5, 1], opacity: 0.2 },
    { value: 1100, color: [1, 0.9, 0.2], opacity: 1 },
    { value: 3095, color: [1, 0.9, 0.2], opacity: 1 },
  ]),
  { name: 'anisotropic', data: { spacing: [0.5, 1, 3] } },
  { name: 'flipped', data: { kind: 'uint16', indexToWorld: [2, 0, 0, 5, 0, -1, 0, 9, 0, 0, -1.5, -4, 0, 0, 0, 1] } },
  { name: 'oblique and sheared', data: { indexToWorld: obliqueAffine(random, [1, -1.3, 0.8], [30, -20, 10]) } },
  { name: 'nanometres', data: { spacing: [1e-6, 1e-6, 2e-6] }, optics: { referenceLength: 1e-6 } },
  {
    name: 'kilometres, far from 0',
    data: { indexToWorld: [1e3, 0, 0, 4e6, 0, 1e3, 0, -3e6, 0, 0, 2e3, 0, 0, 0, 0, 1] },
    optics: { referenceLength: 1e3 },
  },
  { name: 'one slice', data: { dimensions: [24, 20, 1], spacing: [1, 1, 6] } },
  { name: 'eye inside', data: { kind: 'float32' }, orbit: { radius: 0.15 } },
  { name: 'eye at the centre', orbit: { radius: 1e-3 } },
  { name: 'eye on a face', camera: { eye: [0, 10, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 1.2 } },
  { name: 'along y', orbit: { theta: 0, phi: quarter } },
  { name: 'along -z', orbit: { theta: 0, phi: 0 } },
  { name: 'along x', data: { kind: 'uint16' }, orbit: { theta: quarter, phi: quarter } },
  { name: 'grazing a face', camera: { eye: [-40, 9.9, 2], target: [0, 9.9, 0], up: [0, 0, 1], fieldOfView: 0.6 } },
  { name: 'from afar', camera: { eye: [1e4, 2e4, 5e3], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 1.4e-3 } },
  { name: '8 steps', steps: 8 },
  { name: '500 steps', steps: 500 },
  { name: 'factors', optics: { opacityFactor: 2.5, lightFactor: 1.7 } },
  {
    name: 'opaque, 500 steps',
    steps: 500,
    optics: {
      transferFunction: [
        { value: 0.3, color: [0.2, 0.5, 1], opacity: 0 },
        { value: 0.7, color: [1, 0.9, 0.2], opacity: 1 },
      ],
    },
  },
  {
    name: 'opaque',
    optics: {
      transferFunction: [
        { value: 0.3, color: [0.2, 0.5, 1], opacity: 0 },
        { value: 0.9, color: [1, 0.9, 0.2], opacity: 1 },
      ],
    },
  },
];

function viewOf({ data, orbit, camera, steps = 60, optics }: Case): View {
  const volume: Volume = syntheticVolume({ dimensions: [24, 20, 16], ...data });
  const diagonal = longestDiagonal(volume.grid);
  const stand = { theta: 0.6, phi: 1.2, radius: 1.6, ...orbit };
  const rescale = (value: number): number => value * (data?.slope ?? 1) + (data?.intercept ?? 0);
  const both = { ...plainOptics, ...optics };
  return {
    volume,
    camera:
      camera ?? orbitCamera({ ...stand, radius: stand.radius * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / steps,
    optics: {
      ...both,
      transferFunction: both.transferFunction.map((stop) => ({ ...stop, value: rescale(stop.value) })),
    },
  };
}

const expectationOf = remember((one: Case) => expectWalks(viewOf(one)));

/** One for each kind of texture and of table. */
const fromTextures = new Set([
  '8 bit',
  '16 bit',
  'float',
  'no data',
  'no data among whole numbers, opaque from a value on',
  'one slice',
  'opaque',
]);

for (const version of [2, 1] as const) {
  describe(`the picture in WebGL ${version} is the reference's`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ name }) => fromTextures.has(name))) {
      it(one.name, () => {
        expect(scene().device.webgl2).to.equal(version === 2);
        for (const expectation of expectationOf(one)) {
          drawAsExpected(scene(), expectation, { name: `WebGL ${version} ${one.name}`, minShown: 60 });
        }
      });
    }
  });
}

describe('the pictures of WebGL 1 and 2', () => {
  for (const kind of ['uint8', 'uint16', 'float32'] as const) {
    it(`are the same: ${kind}`, async () => {
      const views = bothWalks(viewOf({ name: kind, data: { kind, spacing: [1, 1.5, 0.7] } }));
      const second = await withScene({}, (scene) => views.map((view) => drawPicture(scene, view)));
      const first = await withScene({ webgl1: true }, (scene) => views.map((view) => drawPicture(scene, view)));
      // Two roundings to 8 bits that fall on different sides.
      for (const [i, picture] of first.entries()) expect(comparePictures(picture, second[i]).worst).to.be.at.most(1);
    });
  }
});
