import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { extinction } from '../../../src/optics/transfer/opacity.ts';
import { intersectUnitCube, rayThrough } from '../../../src/optics/rays/rays.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { comparePictures, drawPicture, height, plainOptics, raysOf, width, withScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const gray: TransferFunction = [
  { value: 0, color: [1, 1, 1], opacity: 0 },
  { value: 1, color: [1, 1, 1], opacity: 0.04 },
];

/** World length of each pixel's ray inside the volume. */
function rayLengths(view: View): number[] {
  const rays = raysOf(view);
  return Array.from({ length: width * height }, (_, pixel) => {
    const x = (((pixel % width) + 0.5) / width) * 2 - 1;
    const y = 1 - ((Math.floor(pixel / width) + 0.5) / height) * 2;
    const ray = rayThrough(rays, x, y);
    const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
    return Math.max(0, exit - entry) * ray.lengthPerT * rays.diameter;
  });
}

describe('a uniform slab', () => {
  for (const webgl1 of [false, true]) {
    it(`shows 1 - exp(-tau L) for 8 to 2,048 steps in WebGL ${webgl1 ? 1 : 2}`, () =>
      withScene({ webgl1 }, (scene) => {
        const volume = syntheticVolume({
          dimensions: [12, 10, 4],
          spacing: [2, 2, 3],
          kind: 'float32',
          field: () => 0.5,
        });
        const camera = orbitCamera({ theta: 0.4, phi: 0.5, radius: 60 }, [0, 0, 0], 0.6);
        for (const tau of [0.005, 0.04, 0.3]) {
          const color: TransferFunction = [{ value: 0.5, color: [1, 1, 1], opacity: 1 - Math.exp(-tau) }];
          for (const steps of [8, 9.3, 64, 500, 2048]) {
            const view = {
              volume,
              camera,
              stepLength: longestDiagonal(volume.grid) / steps,
              optics: { ...plainOptics, transferFunction: color },
            };
            const got = drawPicture(scene, view);
            const worst = Math.max(
              ...rayLengths(view).map((l, i) => Math.abs(got[i * 4 + 3] / 255 - (1 - Math.exp(-tau * l)))),
            );
            // The bound. Rounding to 8 bits takes 1/510 = 0.00196 of it.
            expect(worst, `tau ${tau}, ${steps} steps`).to.be.at.most(0.002);
          }
        }
      }));
  }

  it('is as opaque in voxels of any size and in any unit', () =>
    withScene({}, (scene) => {
      const picture = (n: number, unit: number) => {
        const spacing = [(24 * unit) / n, (24 * unit) / n, (12 * unit) / n] as const;
        const volume = syntheticVolume({ dimensions: [n, n, n], spacing, kind: 'uint8', field: () => 0.6 });
        const camera = orbitCamera({ theta: 1, phi: 1, radius: 60 * unit }, [0, 0, 0], 0.6);
        const optics = { ...plainOptics, transferFunction: gray, referenceLength: unit };
        return drawPicture(scene, { volume, camera, stepLength: unit, optics });
      };
      const expected = picture(8, 1);
      expect(Math.max(...expected)).to.be.above(60);
      for (const [n, unit] of [
        [1, 1],
        [33, 1],
        [8, 1e-3],
        [8, 1e5],
      ]) {
        expect(comparePictures(picture(n, unit), expected).worst, `${n} voxels, unit ${unit}`).to.be.at.most(1);
      }
    }));
});

describe('one field at several resolutions', () => {
  const [fx, fy, fz] = [1, 2, 1];
  /** Its slope across each face is 0, so that holding it constant in the outer half voxels costs no more than inside. */
  const field = (x: number, y: number, z: number): number =>
    0.5 + 0.5 * Math.cos(fx * Math.PI * x) * Math.cos(fy * Math.PI * y) * Math.cos(fz * Math.PI * z);

  /**
   * Largest error of tri-linear interpolation: the sum over the axes of h^2 / 8 times the largest second derivative,
   * where h is a voxel in units of the cube.
   */
  const interpolationError = (n: number): number =>
    [fx, fy, fz].reduce((sum, f) => sum + (0.5 * (f * Math.PI) ** 2) / (8 * n * n), 0);

  function viewAt(n: number): View {
    const dimensions: Vector3 = [n, n, n];
    const volume = syntheticVolume({ dimensions, spacing: [40 / n, 50 / n, 30 / n], kind: 'float32', field });
    const camera = orbitCamera({ theta: 0.7, phi: 1, radius: 110 }, [0, 0, 0], 0.6);
    return { volume, camera, stepLength: 0.25, optics: { ...plainOptics, transferFunction: gray } };
  }

  it('gives one picture, within the interpolation error', () =>
    withScene({}, (scene) => {
      const lengths = rayLengths(viewAt(4));
      // The extinction's largest slope over the data value is at opacity 0.04.
      const slope = 0.04 / (1 - 0.04);
      const full = drawPicture(scene, viewAt(20));
      expect(extinction(0.04)).to.be.below(slope);
      for (const n of [10, 40]) {
        const got = drawPicture(scene, viewAt(n));
        let [tightest, worst] = [0, 0];
        lengths.forEach((length, i) => {
          // |exp(-a) - exp(-b)| <= exp(-min(a, b)) |a - b|, and the optical depths differ by no more than this:
          const depths = slope * (interpolationError(n) + interpolationError(20)) * length;
          const seen = 1 - Math.min(got[i * 4 + 3], full[i * 4 + 3]) / 255;
          const bound = 255 * seen * depths + 1; // both roundings to 8 bits
          const difference = Math.abs(got[i * 4 + 3] - full[i * 4 + 3]);
          tightest = Math.max(tightest, difference / bound);
          worst = Math.max(worst, difference);
          expect(difference, `${n} voxels, pixel ${i}`).to.be.at.most(bound);
        });
        console.log(
          `${n} against 20 voxels an axis: worst ${worst}/255, at most ${(100 * tightest).toFixed(0)} % of the bound`,
        );
      }
    }));
});
