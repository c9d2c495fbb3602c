// Handles over a picture: where a place of the world goes when it is dragged by pixels, and by keys.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import {
  axesOf,
  lengthOfPixel,
  moveByKey,
  placeInPlane,
  placeOnLine,
} from '../../../../src/viewer/camera/drag-place.ts';
import type { SeenPicture } from '../../../../src/viewer/camera/drag-place.ts';
import { projectPlace } from '../../../../src/viewer/camera/project-place.ts';
import { add, dot, scale, subtract } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

function expectNear(got: readonly number[], expected: readonly number[], tolerance = 1e-9): void {
  got.forEach((x, i) =>
    expect(x, `${got.join(' ')} is not ${expected.join(' ')}`).to.be.closeTo(expected[i], tolerance),
  );
}

/** From the front, at a distance of 10: x runs to the left, and a picture of 200 pixels is 20 tan(30 deg) high. */
const front: SeenPicture = {
  camera: orbitCamera({ theta: 0, phi: Math.PI / 2, radius: 10 }, [0, 0, 0], Math.PI / 3),
  width: 300,
  height: 200,
};
const pixel = (20 * Math.tan(Math.PI / 6)) / 200;

const random = randomNumbers(15);
const anyNumber = (size: number): number => (2 * random() - 1) * size;
const anyPlace = (size: number): Vector3 => [anyNumber(size), anyNumber(size), anyNumber(size)];
const anyPicture = (): SeenPicture => ({
  camera: orbitCamera(
    { theta: anyNumber(3), phi: 0.2 + random() * 2.7, radius: 20 + 10 * random() },
    anyPlace(3),
    0.3 + random(),
  ),
  width: 100 + 500 * random(),
  height: 100 + 500 * random(),
});

describe('a place that is dragged', () => {
  it('goes with the pointer, in the plane that faces the camera: by closed form', () => {
    expect(lengthOfPixel(front, [0, 0, 0])).to.be.closeTo(pixel, 1e-12);
    expect(lengthOfPixel(front, [3, 5, 1]), 'half as far away').to.be.closeTo(pixel / 2, 1e-12);
    expectNear(placeInPlane(front, [0, 0, 0], [150 + 30, 100 - 20]), [-30 * pixel, 0, 20 * pixel]);
    expectNear(placeInPlane(front, [1, 5, 2], [150, 100]), [0, 5, 0]);
  });

  it('is seen where the pointer is, and no nearer or farther than before, from anywhere', () => {
    for (let n = 0; n < 100; n++) {
      const picture = anyPicture();
      const start = anyPlace(4);
      const to = [random() * picture.width, random() * picture.height] as const;
      const moved = placeInPlane(picture, start, to);
      expectNear(projectPlace(picture.camera, moved, picture)!, to, 1e-8);
      expect(dot(subtract(moved, start), axesOf(picture.camera).away)).to.be.closeTo(0, 1e-9);
    }
  });

  it('stays on its line where it has one, at the foot of the pointer in the picture', () => {
    for (let n = 0; n < 100; n++) {
      const picture = anyPicture();
      const { right, up } = axesOf(picture.camera);
      const through = anyPlace(4);
      const direction = add(add(scale(right, 1 + random()), scale(up, anyNumber(2))), anyPlace(0.3));
      const from = projectPlace(picture.camera, through, picture)!;
      const goal = projectPlace(picture.camera, add(through, scale(direction, 0.7)), picture)!;
      const aside = anyNumber(1);
      const moved = placeOnLine(picture, { through, direction, from }, [
        goal[0] + aside * (goal[1] - from[1]),
        goal[1] + aside * (from[0] - goal[0]),
      ]);
      expectNear(moved, add(through, scale(direction, 0.7)), 1e-7);
    }
  });

  it('on a line that points at the eye goes away from it as the pointer goes up', () => {
    const line = { through: [0, 0, 0], direction: [0, 3, 0], from: [150, 100] } as const;
    expectNear(placeOnLine(front, line, [150, 90]), [0, -10 * pixel, 0]);
    expectNear(placeOnLine(front, { ...line, direction: [0, -1, 0] }, [170, 110]), [0, 10 * pixel, 0]);
  });
});

describe('a place that keys move', () => {
  const press = (key: string, shiftKey = false, along?: Vector3): Vector3 | null =>
    moveByKey(front, [0, 0, 0], { key, shiftKey }, along);

  it('goes by four pixels, with Shift by forty, across the picture, away and nearer', () => {
    expectNear(press('ArrowRight')!, [-4 * pixel, 0, 0]);
    expectNear(press('ArrowUp', true)!, [0, 0, 40 * pixel]);
    expectNear(press('PageUp')!, [0, -4 * pixel, 0]);
    expectNear(press('PageDown', true)!, [0, 40 * pixel, 0]);
    expect(press('Enter')).to.equal(null);
  });

  it('on a line goes the way that it runs in the picture, and by Page keys along it and back', () => {
    expectNear(press('ArrowRight', false, [2, 0, 0])!, [-4 * pixel, 0, 0]);
    expectNear(press('ArrowLeft', false, [2, 0, 0])!, [4 * pixel, 0, 0]);
    expect(press('ArrowUp', false, [2, 0, 0])).to.equal(null);
    expectNear(press('PageUp', false, [0, 5, 0])!, [0, 4 * pixel, 0]);
    expectNear(press('PageDown', false, [0, 5, 0])!, [0, -4 * pixel, 0]);
  });
});
