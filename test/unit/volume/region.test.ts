import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { countSamples } from '../../../src/optics/rays/count-samples.ts';
import { crossVolume, rayThrough, setUpRays } from '../../../src/optics/rays/rays.ts';
import { autoSteps, stepLengthOf } from '../../../src/quality/steps.ts';
import {
  boundingSphere,
  cartesianGrid,
  edgeLengths,
  finestSpacing,
  longestDiagonal,
  unitToWorld,
} from '../../../src/volume/grid.ts';
import { transformDirection, transformPoint } from '../../../src/volume/matrix.ts';
import type { Matrix4 } from '../../../src/volume/matrix.ts';
import { stretchOf } from '../../../src/radar/polar-geometry.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import { radarVolume, polarScenes } from '../../helpers/synthetic-radar.ts';

/** 10 x 8 x 6 voxels of 2 x 3 x 4, the first one's centre at 1 1.5 2: the world's box from the origin to 20 24 24. */
const grid = cartesianGrid([10, 8, 6], [2, 0, 0, 1, 0, 3, 0, 1.5, 0, 0, 4, 2, 0, 0, 0, 1]);
/** Turned by 30 degrees around z. */
const oblique: Matrix4 = [Math.sqrt(3), -1.5, 0, 0, 1, 1.5 * Math.sqrt(3), 0, 0, 0, 0, 4, 0, 0, 0, 0, 1];

describe('a region of a volume', () => {
  it('is its box, whichever corners are given, and no more than the volume has', () => {
    for (const box of [
      [5, 6, 7, 15, 10, 40],
      [15, 10, 40, 5, 6, 7],
      [5, 10, 40, 15, 6, 7],
    ]) {
      const region = cutRegion(grid, box)!;
      expect(boundingSphere(region).center).to.deep.equal([10, 8, 15.5]);
      expect(edgeLengths(region)).to.deep.equal([10, 4, 17]);
    }
  });

  it('is none where the box holds nothing of the volume', () => {
    for (const box of [
      [21, 0, 0, 30, 10, 10],
      [0, 0, 0, 0, 10, 10],
      [0, 0, -5, 10, 10, 0],
    ])
      expect(cutRegion(grid, box)).to.equal(null);
  });

  it('is as fine as the volume: a step is as long, and there are fewer', () => {
    const region = cutRegion(grid, [0, 0, 0, 10, 12, 12])!;
    expect(finestSpacing(region)).to.equal(finestSpacing(grid));
    expect(longestDiagonal(region)).to.be.closeTo(longestDiagonal(grid) / 2, 1e-12);
    expect(autoSteps(region)).to.equal(Math.ceil(autoSteps(grid) / 2));
    expect(stepLengthOf(region, autoSteps(region))).to.be.closeTo(stepLengthOf(grid, autoSteps(grid)), 0.1);
  });

  it('of a radar volume is in metres before heights are stretched', () => {
    const volume = radarVolume(polarScenes['five sweeps'], { verticalExaggeration: 7 });
    expect(stretchOf(volume.grid)).to.be.closeTo(7, 1e-9);
    const region = cutRegion(volume.grid, [-3000, -2000, 100, 3000, 5000, 1100], stretchOf(volume.grid))!;
    expect(edgeLengths(region)[2]).to.be.closeTo(7000, 1e-6);
    expect(boundingSphere(region).center[2]).to.be.closeTo(4200, 1e-6);
  });

  it("ends rays at the world's planes, in oblique volumes too", () => {
    for (const volume of [grid, cartesianGrid(grid.dimensions, oblique)]) {
      const region = cutRegion(volume, [2, 5, 6, 9, 14, 18])!;
      const camera = orbitCamera({ theta: 0.7, phi: 1.1, radius: 60 }, boundingSphere(region).center, 0.5);
      const rays = setUpRays(volume, viewMatrix(camera), projectionMatrix(0.5, 1, 1, 2), region)!;
      const toWorld = unitToWorld(volume);
      let met = 0;
      for (let i = 0; i < 200; i++) {
        const ray = rayThrough(rays, ((i % 20) - 9.5) / 20, (Math.floor(i / 20) - 4.5) / 10);
        const [entry, exit] = crossVolume(rays, ray);
        if (!(entry < exit)) continue;
        met++;
        for (const t of [entry, exit]) {
          const world = [0, 1, 2].map(
            (c) => transformPoint(toWorld, ray.point)[c] + t * transformDirection(toWorld, ray.direction)[c],
          );
          const unit = ray.point.map((x, c) => x + t * ray.direction[c]);
          const ends = [
            ...world.map((x, c) => Math.min(x - [2, 5, 6][c], [9, 14, 18][c] - x)),
            ...unit.map((x) => 10 * Math.min(x, 1 - x)),
          ];
          // Inside of all planes, and on one of them.
          expect(Math.min(...ends)).to.be.closeTo(0, 1e-9);
        }
      }
      expect(met).to.be.above(40);
      const all = setUpRays(volume, viewMatrix(camera), projectionMatrix(0.5, 1, 1, 2))!;
      expect(countSamples(rays, 0.1, 1e6)).to.be.below(0.6 * countSamples(all, 0.1, 1e6));
    }
  });
});
