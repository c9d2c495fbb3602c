// One call gives a scene its plan: a picture depends on the plan alone, not on the plans, probes and pieces before it.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { allSubsteps, wholeSteps } from '../../../src/optics/cells/substeps.ts';
import { createClip } from '../../../src/renderer/ray/modules/clip.ts';
import { plainRays } from '../../../src/renderer/ray/ray-plan.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import type { ScenePlan, VolumeScene } from '../../../src/x3d/scene.ts';
import { keep } from '../../helpers/clips.ts';
import { drawInPieces } from '../../helpers/draw-in-pieces.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import '../../helpers/provide-substeps.ts';

const volume = syntheticVolume({ dimensions: [24, 20, 16] });
const diagonal = longestDiagonal(volume.grid);
const { center } = boundingSphere(volume.grid);
const around = (distance: number): number[] => center.map((x) => x + distance);
const cameraAt = (theta: number): ScenePlan['camera'] =>
  orbitCamera({ theta, phi: 1.1, radius: 1.4 * diagonal }, center, 0.7);

const plain: ScenePlan = {
  ...plainRays,
  picture: { width: 60, height: 44 },
  camera: cameraAt(0.5),
  ground: null,
  stepLength: diagonal / 40,
};

/** Plans that differ from each other in every member. */
const plans: readonly ScenePlan[] = [
  plain,
  {
    ...plain,
    picture: { width: 44, height: 60 },
    camera: cameraAt(2.5),
    region: cutRegion(volume.grid, [...around(-7), ...around(7)]),
    substeps: wholeSteps,
    stepLength: diagonal / 15,
  },
  {
    ...plain,
    cuts: [{ create: createClip, items: [keep(volume.grid, [1, 0.2, 0], center[0] + 0.2 * center[1])] }],
    substeps: { ...allSubsteps, max: 2 },
    maxCurvature: 12,
    edgeCurvature: 30,
  },
  { ...plain, ground: { lines: [[center, [center[0] + diagonal, center[1], center[2]]]] } },
];

const draw = (scene: VolumeScene, plan: ScenePlan): Uint8ClampedArray => {
  scene.apply(plan);
  scene.draw(0);
  return readPixels(scene);
};

for (const webgl1 of [false, true]) {
  it(`a picture depends on its plan alone: WebGL ${webgl1 ? 1 : 2}`, () =>
    withScene({ webgl1 }, async (scene) => {
      await scene.prepare(volume);
      await scene.loadLines();
      scene.setVolume(volume);
      const first = plans.map((plan) => draw(scene, plan));
      for (const [i, picture] of first.entries()) {
        expect(
          picture.some((x) => x > 60),
          `${i}: something is seen`,
        ).to.equal(true);
        for (const [j, other] of first.entries())
          if (i !== j)
            expect(
              other.length !== picture.length ||
                comparePictures(other, picture).worst > 5 ||
                plans[j].picture.width !== plans[i].picture.width,
              `${i} and ${j} differ`,
            ).to.equal(true);
      }
      for (const [i, j] of [
        [3, 0],
        [2, 1],
        [1, 0],
        [0, 2],
        [2, 3],
        [3, 1],
        [1, 2],
      ]) {
        draw(scene, plans[i]);
        expect(comparePictures(draw(scene, plans[j]), first[j]).worst, `${j} after ${i}`).to.equal(0);
      }
    }));
}

it('probes and pieces have rays of their own, and leave the plan as it is', () =>
  withScene({}, async (scene) => {
    await scene.prepare(volume);
    scene.setVolume(volume);
    const size = plain.picture;
    const before = draw(scene, plain);
    const lattice = { stride: 8, first: [4, 4], width: 7, height: 5 } as const;
    const probe = (rays: Partial<ScenePlan>): readonly number[] => [...scene.startProbe(rays, lattice, size)!()!];
    const own = probe({});
    const coarse = probe({ stepLength: diagonal / 4, substeps: wholeSteps });
    expect(Math.max(...own.map((x, i) => Math.abs(x - coarse[i]))), 'other rays').to.be.above(0.001);
    expect(probe({}), 'and again those of the plan').to.deep.equal(own);
    drawInPieces(scene, diagonal / 4, size);
    scene.detail(wholeSteps);
    expect(scene.plan).to.equal(plain);
    expect(probe({})).to.deep.equal(own);
    scene.draw(0);
    expect(comparePictures(readPixels(scene), before).worst, 'the next picture').to.equal(0);
  }));
