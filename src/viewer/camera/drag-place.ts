// Computes where places of the world move that a person drags in a picture. Pixels are CSS pixels from the picture's left and top
// edge.
import { viewMatrix } from '../../optics/rays/camera.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import { add, dot, normalize, scale, transformDirection, transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** A picture, and its camera. */
export interface SeenPicture {
  readonly camera: Camera;
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
}

export type Pixel = readonly [x: number, y: number];

/** A line in the world that points almost at the eye has no useful direction in the picture: the limit is this share of its length. */
const foreshortened = 0.25;

/** World length of a pixel at a place in front of the eye; 0 or less behind it. */
export function lengthOfPixel({ camera, height }: SeenPicture, at: Vector3): number {
  return (-transformPoint(viewMatrix(camera), at)[2] * 2 * Math.tan(camera.fieldOfView / 2)) / height;
}

/** The directions of a picture in the world, each of length 1. */
export function axesOf(camera: Camera): { readonly right: Vector3; readonly up: Vector3; readonly away: Vector3 } {
  const m = viewMatrix(camera);
  return { right: [m[0], m[1], m[2]], up: [m[4], m[5], m[6]], away: [-m[8], -m[9], -m[10]] };
}

/** The place at a pixel, in the plane that faces the camera and contains the place `through`. */
export function placeInPlane(picture: SeenPicture, through: Vector3, [x, y]: Pixel): Vector3 {
  const { camera, width, height } = picture;
  const { right, up, away } = axesOf(camera);
  const pixel = lengthOfPixel(picture, through);
  const depth = -transformPoint(viewMatrix(camera), through)[2];
  return add(
    add(camera.eye, scale(away, depth)),
    add(scale(right, (x - width / 2) * pixel), scale(up, (height / 2 - y) * pixel)),
  );
}

/**
 * The place on a line that appears nearest to a pixel. If the line points at the eye, it has no direction in the picture: then a
 * drag upwards moves the place away from the eye.
 * @param from - the pixel where the drag started, at which the place `through` was
 * @param direction - of any length except zero
 */
export function placeOnLine(
  picture: SeenPicture,
  { through, direction, from }: { through: Vector3; direction: Vector3; from: Pixel },
  to: Pixel,
): Vector3 {
  const along = normalize(direction);
  const { camera, width, height } = picture;
  const view = viewMatrix(camera);
  const reach = height / 2 / Math.tan(camera.fieldOfView / 2);
  const [x, y, z] = transformPoint(view, through);
  const [dx, dy, dz] = transformDirection(view, along);
  // A pixel is (a + t b) / (c + t e) from the middle, to the right and up.
  const [a, b, c, e] = [[reach * x, reach * y], [reach * dx, reach * dy], -z, -dz];
  const speed = [0, 1].map((axis) => (b[axis] * c - a[axis] * e) / (c * c));
  const size = Math.hypot(...speed);
  if (size * c < foreshortened * reach)
    return add(
      through,
      scale(along, (from[1] - to[1]) * lengthOfPixel(picture, through) * Math.sign(dot(along, axesOf(camera).away))),
    );
  const line = speed.map((part) => part / size);
  const pixel = [to[0] - width / 2, height / 2 - to[1]];
  const [p, q, r] = [0, 1].reduce(
    (sums, axis) => [
      sums[0] + a[axis] * line[axis],
      sums[1] + b[axis] * line[axis],
      sums[2] + pixel[axis] * line[axis],
    ],
    [0, 0, 0],
  );
  return add(through, scale(along, (r * c - p) / (q - r * e)));
}

/** Pixels that a key moves a place, without and with Shift. */
const [keyStep, shiftStep] = [4, 40];

/** To the right, up, and away from the eye. */
const keys: Readonly<Record<string, Vector3>> = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

/** A key has no effect if the line has less than this share of its direction in the picture. */
const minShare = 0.2;

/**
 * Where a key moves a place: the arrows in the plane that faces the camera, Page up and Page down away from the eye and towards
 * it.
 * @param along - the only direction in which it moves: the arrows move it as the line runs in the picture, Page up and Page down
 * forwards and backwards on the line
 * @returns null where the key has no effect
 */
export function moveByKey(
  picture: SeenPicture,
  at: Vector3,
  { key, shiftKey }: { readonly key: string; readonly shiftKey: boolean },
  along?: Vector3,
): Vector3 | null {
  if (!Object.hasOwn(keys, key)) return null;
  const { right, up, away } = axesOf(picture.camera);
  const step = (shiftKey ? shiftStep : keyStep) * lengthOfPixel(picture, at);
  const [x, y, z] = keys[key];
  const way = add(add(scale(right, x), scale(up, y)), scale(away, z));
  if (!along) return add(at, scale(way, step));
  const line = normalize(along);
  if (z !== 0) return add(at, scale(line, z * step));
  const part = dot(line, way);
  return Math.abs(part) < minShare ? null : add(at, scale(line, Math.sign(part) * step));
}
