// Lines where opaque shapes cut surfaces: at rest each of a pixel's five rays ends where the shape stands for it.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { castRay } from '../../../src/optics/rays/cast-ray.ts';
import { edgeOffsets } from '../../../src/optics/rays/edge-rays.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import {
  drawPicture,
  height,
  meetBox,
  plainOptics,
  raysOf,
  referenceOf,
  width,
  withScene,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { rayAt } from '../../helpers/edges.ts';
import { surfaceStages } from '../../helpers/surfaces.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

/** Over a corner: its faces cut the ball along lines of all slopes. */
const box: { readonly center: Vector3; readonly size: number } = { center: [3, 2, 1], size: 12 };
const children = `<transform translation="${box.center.join(' ')}"><shape><appearance><material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="0 0 1"></material></appearance><box size="12 12 12"></box></shape></transform>`;

const ball = syntheticVolume({
  dimensions: [24, 24, 24],
  kind: 'float32',
  field: (x, y, z) => 1 - 2 * Math.hypot(x - 0.5, y - 0.5, z - 0.5),
});
const diagonal = longestDiagonal(ball.grid);
const view: View = {
  volume: ball,
  camera: orbitCamera({ theta: 0.6, phi: 1.1, radius: 1.1 * diagonal }, [0, 0, 0], 0.6),
  stepLength: diagonal / 60,
};
const style: RayStyle = { clear: true, plain: true, surfaces: [{ value: 0.3, color: [1, 0.8, 0.6], opacity: 1 }] };

const rays = raysOf(view);
const meet = (ray: Ray): number => meetBox(ball, ray, box);
const around = (pixel: number): number[] => [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => pixel + dy * width + dx));

/** What the ball shows in some pixels: the mean of rays beside each pixel's middle, 0..255 of red. */
function meansOf(pixels: readonly number[], shifts: readonly (readonly [number, number])[]): Map<number, number> {
  const stages = stagesOf(
    { ...referenceOf(view, meet), ...surfaceStages(ball, style, plainOptics.transferFunction) },
    rays,
  );
  const cast = (pixel: number) =>
    shifts.reduce((sum, [right, up]) => sum + castRay(stages, rayAt(rays, pixel, [right, -up]))[0], 0);
  return new Map(pixels.map((pixel) => [pixel, (255 / shifts.length) * cast(pixel)]));
}

const even = Array.from({ length: 64 }, (_, i) => [((i % 8) - 3.5) / 8, (Math.floor(i / 8) - 3.5) / 8] as const);

describe('lines where shapes cut surfaces', function () {
  this.timeout(120_000);
  // Away from the box's own outline.
  const isBox = Array.from({ length: width * height }, (_, pixel) => Number.isFinite(meet(rayAt(rays, pixel))));
  const five = meansOf(
    [...isBox.keys()].filter((pixel) => around(pixel).every((one) => isBox[one])),
    [[0, 0], ...edgeOffsets],
  );
  const right = meansOf(
    [...five.keys()].filter((pixel) => around(pixel).some((one) => five.has(one) && five.get(one) !== five.get(pixel))),
    even,
  );
  const partly = [...right].filter(([, red]) => red > 1 && red < 254).map(([pixel]) => pixel);
  const off = (got: (pixel: number) => number, expected: ReadonlyMap<number, number>): number =>
    Math.sqrt(partly.reduce((sum, pixel) => sum + (got(pixel) - expected.get(pixel)!) ** 2, 0) / partly.length);

  for (const webgl1 of [false, true]) {
    it(`are smooth at rest in WebGL ${webgl1 ? 1 : 2}`, () =>
      withScene({ webgl1, children }, async (scene) => {
        await scene.setAppearance({ style });
        const [once, atRest] = [Infinity, 1].map((edgeCurvature) => {
          changePlan(scene, { maxCurvature: 0, edgeCurvature });
          const picture = drawPicture(scene, view);
          return (pixel: number): number => picture[4 * pixel];
        });
        const wrong = [...five].filter(([pixel, red]) => Math.abs(atRest(pixel) - red) > 2);
        console.log(
          `WebGL ${webgl1 ? 1 : 2}: ${partly.length} pixels on lines of ${five.size}; RMSE to 64 rays ${off(once, right).toFixed(1)} with one ray, ${off(atRest, right).toFixed(1)} at rest, ${off((pixel) => five.get(pixel)!, right).toFixed(1)} of five in float64; ${wrong.length} unlike these`,
        );
        expect(partly.length, 'pixels on lines').to.be.above(30);
        expect(off(once, right), 'stairs').to.be.above(50);
        // One depth for all five rays leaves 48.
        expect(off(atRest, right), 'RMSE').to.be.below(27);
        // Quads in which one ray a pixel finds no edge keep that.
        expect(wrong.length, 'unlike five rays').to.be.at.most(5);
      }));
  }
});
