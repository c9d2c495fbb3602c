// An author's ClipPlanes cut shapes, which x3dom draws, and the volume, at the same place.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { clipInterval, cutoutInterval } from '../../../src/optics/rays/clip-intervals.ts';
import type { Cutout, HalfSpace } from '../../../src/optics/rays/clip-intervals.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { readClips } from '../../../src/viewer/cuts/read-clips.ts';
import { add, dot, scale } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { AuthorCopies } from '../../../src/x3d/author-copies.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import {
  comparePictures,
  height,
  meetBox,
  rayInWorld,
  raysOf,
  referenceOf,
  width,
  withScene,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const view: View = {
  volume: syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' }),
  camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 70 }, [0, 0, 0], 0.6),
  stepLength: 0.6,
};

const place = { center: [3, 6, 1] as Vector3, size: 9 };

const box = `<shape><appearance><material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="0 1 0"></material></appearance>
  <box size="${place.size} ${place.size} ${place.size}"></box></shape>`;
const moved = (inside: string): string => `<transform translation="${place.center.join(' ')}">${inside}</transform>`;

/** The picture, and what it has to be: the box ends rays where it is kept; what is behind its cut faces shows, as x3dom draws fronts alone. */
async function compare(
  scene: VolumeScene,
  host: Element,
  isKept: (world: Vector3) => boolean,
): Promise<{ worst: number; green: number }> {
  await new Promise((resolve) => setTimeout(resolve, 0));
  await scene.othersReady();
  changePlan(scene, { picture: { width, height } });
  scene.setVolume(view.volume);
  changePlan(scene, { camera: view.camera });
  const { cuts, error } = readClips(host, view.volume);
  expect(error).to.equal(null);
  changePlan(scene, { slices: [], cuts });
  const items = cuts.flatMap((cut) => cut.items) as readonly (HalfSpace | Cutout)[];
  const stages = [
    clipInterval(items.filter((item) => item.kind === 'half-space')),
    ...items.filter((item) => item.kind === 'cutout').map(cutoutInterval),
  ];
  drawAt(scene, view.stepLength);
  const picture = readPixels(scene);
  const surfaceT = (ray: Ray): number => {
    const t = meetBox(view.volume, ray, place);
    const { origin, direction } = rayInWorld(view.volume, ray);
    return t < Infinity && isKept(add(origin, scale(direction, t))) ? t : Infinity;
  };
  const setup = raysOf(view);
  const scenery = referenceOf(view, surfaceT);
  const reference = renderReference({ ...scenery, ends: [...stages, ...scenery.ends!] }, setup, width, height).map(
    (x) => 255 * x,
  );
  const hitsAt = (dx: number, dy: number): boolean[] =>
    Array.from({ length: width * height }, (_, pixel) => {
      const [x, y] = [
        (((pixel % width) + 0.5 + dx) / width) * 2 - 1,
        1 - ((Math.floor(pixel / width) + 0.5 + dy) / height) * 2,
      ];
      const at = ([c, px, py]: typeof setup.point): Vector3 => add(c, add(scale(px, x), scale(py, y)));
      return surfaceT({ point: at(setup.point), direction: at(setup.direction), lengthPerT: 1 }) < Infinity;
    });
  const [hits, ...around] = [
    [0, 0],
    [-0.6, -0.6],
    [0.6, -0.6],
    [-0.6, 0.6],
    [0.6, 0.6],
  ].map(([dx, dy]) => hitsAt(dx, dy));
  hits.forEach((hit, pixel) => {
    if (!hit) return;
    reference[4 * pixel + 1] += 255 - reference[4 * pixel + 3];
    reference[4 * pixel + 3] = 255;
  });
  // Pixels on the outline are partly the box's.
  const { worst } = comparePictures(picture, reference, (pixel) => around.some((some) => some[pixel] !== hits[pixel]));
  return { worst, green: hits.filter(Boolean).length };
}

describe('ClipPlanes of the author', () => {
  // Not of length 1: x3dom alone would take another place for it.
  const [normal, at]: [Vector3, number] = [[0.6, 2, -0.4], 9];
  const isKept = (world: Vector3): boolean => dot(normal, world) >= at;

  it('cut the volume and shapes alike, and neither once they are off or gone', () =>
    withScene(
      { children: `<clipplane plane="${normal.join(' ')} ${-at}"></clipplane>${moved(box)}` },
      async (scene, host) => {
        const cut = await compare(scene, host, isKept);
        expect(cut.worst).to.be.at.most(2);
        const plane = host.querySelector('clipplane')!;
        plane.setAttribute('enabled', 'false');
        const whole = await compare(scene, host, () => true);
        expect(whole.worst).to.be.at.most(2);
        expect(cut.green).to.be.within(10, whole.green - 10);
        plane.setAttribute('enabled', 'true');
        expect((await compare(scene, host, isKept)).worst).to.be.at.most(2);
        plane.remove();
        expect((await compare(scene, host, () => true)).worst).to.be.at.most(2);
      },
    ));

  it('cut what is next to them, in the coordinates there, and not the volume, within a Transform', () =>
    withScene({ children: moved(`<clipplane plane="0 0 -1 0.5"></clipplane>${box}`) }, async (scene, host) => {
      const cut = await compare(scene, host, ([, , z]) => z - place.center[2] <= 0.5);
      expect(cut.worst).to.be.at.most(2);
      expect(cut.green).to.be.above(10);
    }));

  it('leave to cutout what it does: a shape in the box that is removed is seen, and what stands behind the box is behind the shape', () =>
    withScene({ children: moved(box) }, async (scene, host) => {
      const seen: number[] = [];
      for (const cutout of ['-4 -2 -6 9 20 7', '-4 -2 -2 2 12 20', '4 3 -20 20 20 20']) {
        host.setAttribute('cutout', cutout);
        const { worst, green } = await compare(scene, host, () => true);
        expect(worst, cutout).to.be.at.most(2);
        seen.push(green);
      }
      expect(Math.min(...seen)).to.be.above(60);
    }));

  it('are sixteen at most: each makes the shaders of shapes longer', () => {
    const reported: string[] = [];
    const copies = new AuthorCopies((_, what, why) => reported.push(`${what}: ${why}`));
    const made = Array.from({ length: 18 }, () => copies.copy(document.createElement('clipplane'))).filter(Boolean);
    expect(made).to.have.length(16);
    expect(reported).to.deep.equal(Array.from({ length: 2 }, () => '<clipplane>: there are more than 16 clipplanes'));
    expect(copies.copy(document.createElement('pointlight'))).not.to.equal(null);
  });
});
