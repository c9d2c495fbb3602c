import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { VolumeScene } from '../../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import {
  comparePictures,
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
import { readPixels } from '../../helpers/read-pixels.ts';

const view: View = {
  volume: syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' }),
  camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 70 }, [0, 0, 0], 0.6),
  stepLength: 0.6,
};

/** A box that looks the same under any light. */
const box = (center: Vector3, size: number, color = '0 1 0'): string => `
  <transform translation="${center.join(' ')}"><shape>
    <appearance><material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="${color}"></material></appearance>
    <box size="${size} ${size} ${size}"></box>
  </shape></transform>`;

/** Let mutation observers, ours and x3dom's, see what was changed in the page. */
async function settle(scene: VolumeScene): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, 0));
  await scene.othersReady();
}

/** The reference with a green box in it, and the pixels on the box's outline, whose colour is partly the box's. */
function referenceWithBox(shown: View, place: { center: Vector3; size: number }) {
  const surfaceT = (ray: Ray): number => meetBox(shown.volume, ray, place);
  const expected = drawReference(shown, surfaceT);
  const bare = (dx: number, dy: number): boolean[] => {
    const setup = raysOf(shown);
    return Array.from({ length: width * height }, (_, pixel) => {
      const x = (((pixel % width) + 0.5 + dx) / width) * 2 - 1;
      const y = 1 - ((Math.floor(pixel / width) + 0.5 + dy) / height) * 2;
      const at = ([c, px, py]: (typeof setup)['point']) =>
        c.map((v, i) => v + px[i] * x + py[i] * y) as unknown as Vector3;
      return (
        meetBox(shown.volume, { point: at(setup.point), direction: at(setup.direction), lengthPerT: 1 }, place) ===
        Infinity
      );
    });
  };
  const tries = [
    [0, 0],
    [-0.6, -0.6],
    [0.6, -0.6],
    [-0.6, 0.6],
    [0.6, 0.6],
  ].map(([dx, dy]) => bare(dx, dy));
  const outline = (pixel: number): boolean => tries.some((hit) => hit[pixel] !== tries[0][pixel]);
  for (let pixel = 0; pixel < width * height; pixel++) {
    if (tries[0][pixel]) continue;
    expected[pixel * 4 + 1] += 255 - expected[pixel * 4 + 3];
    expected[pixel * 4 + 3] = 255;
  }
  return { expected, outline, covered: tries[0].filter((free) => !free).length };
}

describe('shapes of the author', () => {
  for (const webgl1 of [false, true]) {
    for (const [name, center, size] of [
      ['inside', [1, -2, 1], 7],
      ['cutting a face', [-11, 4, 3], 8],
      ['behind', [15, -30, -8], 8],
      ['in front', [-8, 18, 6], 5],
      ['around everything', [0, 0, 0], 60],
    ] as [string, Vector3, number][]) {
      it(`end rays: a box ${name}, WebGL ${webgl1 ? 1 : 2}`, () =>
        withScene({ webgl1, children: box(center, size) }, (scene) => {
          const got = drawPicture(scene, view);
          const { expected, outline, covered } = referenceWithBox(view, { center, size });
          const { worst, rmse } = comparePictures(got, expected, outline);
          console.log(
            `WebGL ${webgl1 ? 1 : 2} box ${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${covered} pixels`,
          );
          expect(covered).to.be.above(20);
          expect(worst).to.be.at.most(2);
          expect(rmse).to.be.at.most(0.5);
        }));
    }
  }

  it('join, change and leave while the scene runs', () =>
    withScene({}, async (scene, host) => {
      const alone = drawPicture(scene, view);
      const draw = async (): Promise<Uint8ClampedArray> => {
        await settle(scene);
        drawAt(scene, view.stepLength);
        return readPixels(scene);
      };
      host.innerHTML = box([1, -2, 1], 7);
      const withBox = await draw();
      const { expected, outline } = referenceWithBox(view, { center: [1, -2, 1], size: 7 });
      expect(comparePictures(withBox, expected, outline).worst, 'added').to.be.at.most(2);

      host.querySelector('material')!.setAttribute('emissiveColor', '1 0 1');
      expect(comparePictures(await draw(), withBox).worst, 'another colour').to.be.above(20);
      const material = host.querySelector('material')!;
      const other = material.cloneNode() as Element;
      other.setAttribute('emissiveColor', '0 1 0');
      material.replaceWith(other);
      expect(comparePictures(await draw(), withBox).worst, 'another material').to.equal(0);

      host.querySelector('transform')!.setAttribute('translation', '-11 4 3');
      const moved = referenceWithBox(view, { center: [-11, 4, 3], size: 7 });
      expect(comparePictures(await draw(), moved.expected, moved.outline).worst, 'moved').to.be.at.most(2);

      host.replaceChildren();
      expect(comparePictures(await draw(), alone).worst, 'removed').to.equal(0);
      host.innerHTML = box([1, -2, 1], 7);
      expect(comparePictures(await draw(), withBox).worst, 'added again').to.equal(0);
    }));

  it("stand before the author's first background, and before nothing where it is gone", () =>
    withScene({}, async (scene, host) => {
      const draw = async (): Promise<Uint8ClampedArray> => {
        await settle(scene);
        drawAt(scene, view.stepLength);
        return readPixels(scene);
      };
      const alone = drawPicture(scene, view);
      const cornerOf = (picture: ArrayLike<number>): number[] => Array.from({ length: 4 }, (_, c) => picture[c]);
      expect(cornerOf(alone), 'clear').to.deep.equal([0, 0, 0, 0]);
      host.innerHTML =
        '<group><background skyColor="1 0.4 0"></background></group><background skyColor="0 0 1"></background>';
      const orange = await draw();
      expect(cornerOf(orange)).to.deep.equal([255, 102, 0, 255]);
      const before = Array.from(alone, (x, i) =>
        i % 4 === 3 ? 255 : x + ((255 - alone[i - (i % 4) + 3]) * [255, 102, 0][i % 4]) / 255,
      );
      expect(comparePictures(orange, before).worst, 'the volume is over it').to.be.at.most(2);
      host.querySelector('background')!.setAttribute('skyColor', '0 1 0');
      expect(cornerOf(await draw()), 'changed').to.deep.equal([0, 255, 0, 255]);
      host.firstElementChild!.remove();
      expect(cornerOf(await draw()), 'the next one').to.deep.equal([0, 0, 255, 255]);
      host.replaceChildren();
      expect(comparePictures(await draw(), alone).worst, 'none').to.equal(0);
    }));

  it('call for a frame when they change', async () => {
    let calls = 0;
    await withScene({ children: box([0, 0, 0], 5), needsFrame: () => calls++ }, async (scene, host) => {
      drawPicture(scene, view);
      await settle(scene);
      const before = calls;
      await settle(scene);
      expect(calls, 'nothing changed').to.equal(before);
      host.querySelector('transform')!.setAttribute('translation', '3 0 0');
      await settle(scene);
      expect(calls).to.be.above(before);
    });
  });

  it('are lit by lights that come and go', () => {
    const lit = box([0, 0, 12], 6).replace(/diffuseColor.*emissiveColor="0 1 0"/, 'diffuseColor="1 1 1"');
    return withScene({ children: lit }, async (scene, host) => {
      const before = drawPicture(scene, view);
      host.insertAdjacentHTML(
        'beforeend',
        '<directionallight direction="0 0 -1" color="1 0 0" intensity="1"></directionallight>',
      );
      await settle(scene);
      drawAt(scene, view.stepLength);
      expect(comparePictures(readPixels(scene), before).worst).to.be.above(20);
      host.querySelector('directionallight')!.remove();
      await settle(scene);
      drawAt(scene, view.stepLength);
      expect(comparePictures(readPixels(scene), before).worst).to.be.at.most(1);
    });
  });
});

describe('viewpoints of the author', () => {
  const standard = '<viewpoint position="0 0 70" orientation="0 0 1 0" fieldOfView="0.5"></viewpoint>';

  it('win over the camera, and give it back', () =>
    withScene({}, async (scene, host) => {
      const own = drawPicture(scene, view);
      host.innerHTML = standard;
      await settle(scene);
      drawAt(scene, view.stepLength);
      // From +z with y up, which is how X3D looks by default.
      const camera = { eye: [0, 0, 70], target: [0, 0, 0], up: [0, 1, 0], fieldOfView: 0.5 } as const;
      expect(comparePictures(readPixels(scene), drawReference({ ...view, camera })).worst).to.be.at.most(2);
      const found = scene.authorCamera()!.camera;
      found.eye.forEach((x, i) => expect(x).to.be.closeTo(camera.eye[i], 1e-9));
      expect(found.fieldOfView).to.equal(0.5);
      expect(scene.authorCamera()!.centerOfRotation, "the default is not the author's").to.equal(null);
      host.querySelector('viewpoint')!.setAttribute('centerOfRotation', '1 2 3');
      await settle(scene);
      expect(scene.authorCamera()!.centerOfRotation).to.deep.equal([1, 2, 3]);
      host.replaceChildren();
      await settle(scene);
      expect(scene.authorCamera()).to.equal(null);
      expect(comparePictures(drawPicture(scene, view), own).worst).to.equal(0);
    }));

  it('may be parallel projections', () => {
    const parallel =
      '<orthoviewpoint position="0 0 50" orientation="0 0 1 0" fieldOfView="-16 -12 16 12"></orthoviewpoint>';
    return withScene({ children: parallel }, (scene) => {
      scene.setVolume(view.volume);
      void scene.setAppearance({ optics: plainOptics });
      drawAt(scene, view.stepLength);
      const identityAt50 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -50, 0, 0, 0, 1];
      const rays = setUpRays(view.volume.grid, identityAt50, [
        1 / 16,
        0,
        0,
        0,
        0,
        1 / 12,
        0,
        0,
        0,
        0,
        -0.1,
        0,
        0,
        0,
        0,
        1,
      ])!;
      const reference = { ...view.volume, ...plainOptics, stepLength: view.stepLength };
      const expected = renderReference(reference, rays, width, height).map((x) => x * 255);
      expect(comparePictures(readPixels(scene), expected).worst).to.be.at.most(2);
    });
  });
});

describe("an author's elements", () => {
  it('are given back when the scene is taken down, and serve another one', async () => {
    const host = document.createElement('div');
    host.innerHTML = box([1, -2, 1], 7);
    const markup = host.innerHTML;
    const elements = [...host.querySelectorAll('*')];
    const pictures: Uint8ClampedArray[] = [];
    for (let i = 0; i < 3; i++) {
      const container = document.createElement('div');
      document.body.append(host, container);
      const scene = await VolumeScene.create(host, container, () => {});
      changePlan(scene, { picture: { width, height } });
      pictures.push(drawPicture(scene, view));
      scene.dispose();
      expect([...host.querySelectorAll('*')], 'the same elements').to.have.ordered.members(elements);
      expect(host.innerHTML).to.equal(markup);
      for (const element of elements) expect(Object.keys(element), element.localName).to.deep.equal([]);
      container.remove();
    }
    host.remove();
    expect(comparePictures(pictures[0], pictures[1]).worst).to.equal(0);
    expect(comparePictures(pictures[0], pictures[2]).worst).to.equal(0);
  });
});
