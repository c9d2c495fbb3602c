import { expect } from '@esm-bundle/chai';
import { levelOfPixels } from '../../../src/bricks/pixel-levels.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';

const levels = [128, 64, 32, 16].map((n): Vector3 => [n, n, n]);
/** Millimetres. */
const voxel = 2;
const grid = cartesianGrid([16, 16, 16], axialIndexToWorld([16, 16, 16], [8 * voxel, 8 * voxel, 8 * voxel]));
const fieldOfView = 0.6;

/** @returns the level by what a pixel covers: a level's voxels are at most half as large as it */
const levelFor = (pixel: number): number => Math.min(3, Math.max(0, Math.floor(Math.log2(pixel / (2 * voxel)))));

describe('The level that the pixels of a picture need', () => {
  it('has voxels of at most half a pixel at each depth, from each side, in perspective', () => {
    const met = new Set<number>();
    for (const [theta, phi] of [
      [0, Math.PI / 2],
      [0.7, 1.1],
      [3, 2.4],
    ])
      for (const radius of [300, 1500, 6000])
        for (const rows of [40, 300]) {
          const camera = orbitCamera({ theta, phi, radius }, [0, 0, 0], fieldOfView);
          const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(fieldOfView, 2, 1, 1e5))!;
          const levelAt = levelOfPixels(rays, [2 * rows, rows], levels);
          for (let t = -0.5; t <= 0.5; t += 0.0173) {
            const depth = rays.planeDepth + t * rays.diameter;
            const level = levelFor((2 * depth * Math.tan(fieldOfView / 2)) / rows);
            met.add(level);
            expect(levelAt(t), `${theta}, ${radius}, ${rows}, ${t}`).to.equal(level);
          }
        }
    expect(met.size).to.equal(4);
  });

  it('is the same everywhere in a parallel projection; the way in which pixels are smaller counts', () => {
    const camera = orbitCamera({ theta: 0.4, phi: 1, radius: 500 }, [0, 0, 0], fieldOfView);
    // 400 x 200 world units.
    const parallel: Matrix4 = [1 / 200, 0, 0, 0, 0, 1 / 100, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];
    const rays = setUpRays(grid, viewMatrix(camera), parallel)!;
    for (const [across, down] of [
      [100, 50],
      [25, 50],
      [10, 10],
      [400, 10],
    ])
      for (const t of [-0.5, 0, 0.4]) {
        const level = levelFor(Math.min(400 / across, 200 / down));
        expect(levelOfPixels(rays, [across, down], levels)(t)).to.equal(level);
      }
  });

  it('counts the voxels of each axis: slices that are far apart need the finest level from the side', () => {
    const flat = cartesianGrid([16, 16, 2], axialIndexToWorld([16, 16, 2], [16, 16, 128]));
    const seen = (phi: number): number => {
      const camera = orbitCamera({ theta: 0, phi, radius: 2000 }, [0, 0, 0], fieldOfView);
      const rays = setUpRays(flat, viewMatrix(camera), projectionMatrix(fieldOfView, 1, 1, 1e5))!;
      const all = [128, 64, 32, 16].map((n): Vector3 => [n, n, n / 8]);
      return levelOfPixels(rays, [150, 150], all)(0);
    };
    // From above, the pixel's 8 mm are four voxels of 2 mm; from the side half a slice.
    expect(seen(0.01)).to.equal(1);
    expect(seen(Math.PI / 2)).to.equal(0);
  });
});
