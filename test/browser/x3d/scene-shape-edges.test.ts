// Edges of opaque shapes in fog: the canvas has several samples a pixel, and each gets the fog before what it shows.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { rayThrough } from '../../../src/optics/rays/rays.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import {
  drawPicture,
  drawReference,
  height,
  meetBox,
  plainOptics,
  raysOf,
  width,
  withScene,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

/** In the middle of the fog, seen over a corner: its edges run across pixels. */
const box: { readonly center: Vector3; readonly size: number } = { center: [1, 2, 0], size: 10 };
const children = `<transform translation="${box.center.join(' ')}"><shape><appearance><material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="0 0 1"></material></appearance><box size="10 10 10"></box></shape></transform>`;

const view: View = (() => {
  const volume = syntheticVolume({ dimensions: [24, 20, 16] });
  const diagonal = longestDiagonal(volume.grid);
  return {
    volume,
    camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, [0, 0, 0], 0.6),
    stepLength: diagonal / 60,
    optics: { ...plainOptics, opacityFactor: 2 },
  };
})();

/** Rays a pixel each way, of the picture that is right. */
const fine = 4;

/** The picture with many rays a pixel; and how much of each pixel the box covers. */
function expectPicture(): { readonly picture: Float64Array; readonly coverage: Float64Array } {
  const all: View = { ...view, size: [fine * width, fine * height] };
  const meet = (ray: Ray): number => meetBox(view.volume, ray, box);
  const fog = drawReference(all, meet);
  const rays = raysOf(all);
  const picture = new Float64Array(width * height * 4);
  const coverage = new Float64Array(width * height);
  for (let y = 0; y < fine * height; y++) {
    for (let x = 0; x < fine * width; x++) {
      const isBox = Number.isFinite(
        meet(rayThrough(rays, (2 * x + 1) / (fine * width) - 1, 1 - (2 * y + 1) / (fine * height))),
      );
      const [from, to] = [y * fine * width + x, Math.floor(y / fine) * width + Math.floor(x / fine)];
      coverage[to] += Number(isBox) / fine ** 2;
      for (let c = 0; c < 4; c++)
        picture[4 * to + c] += (fog[4 * from + c] + (isBox && c > 1 ? 255 - fog[4 * from + 3] : 0)) / fine ** 2;
    }
  }
  return { picture, coverage };
}

describe('edges of shapes in fog', function () {
  this.timeout(180_000);
  const expected = expectPicture();

  for (const [webgl1, atRest, max] of [
    [false, true, 5.5],
    [true, true, 5.5],
    [false, false, 7],
    [true, false, 7],
  ] as const) {
    it(`show on each of their sides the fog in front of the volume or the shape, WebGL ${webgl1 ? 1 : 2}, ${atRest ? 'at rest' : 'in motion'}`, () =>
      withScene({ webgl1, children }, (scene) => {
        changePlan(scene, { maxCurvature: 0, edgeCurvature: atRest ? 30 : Infinity });
        const got = drawPicture(scene, view);
        const { picture, coverage } = expected;
        let [sum, count, worst] = [0, 0, 0];
        coverage.forEach((share, pixel) => {
          if (share === 0 || share === 1) return;
          count++;
          // Red: of it the box has nothing, so that it tells what was put together of two kinds of rays; but for how much of a pixel four samples think is covered.
          const off = Math.abs(got[4 * pixel] - picture[4 * pixel]);
          sum += off ** 2;
          worst = Math.max(worst, off);
        });
        console.log(
          `WebGL ${webgl1 ? 1 : 2}: ${count} pixels at edges, RMSE ${Math.sqrt(sum / count).toFixed(2)}, worst ${worst.toFixed(2)}`,
        );
        expect(count).to.be.above(40);
        expect(Math.sqrt(sum / count), 'RMSE at edges').to.be.below(max);
      }));
  }
});
