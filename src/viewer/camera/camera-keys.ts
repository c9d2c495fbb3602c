import { pan, rotate, zoomFrom } from './camera-moves.ts';
import type { CameraRig } from './camera-rig.ts';

/** One press of an arrow key, radians. */
const turnPerKey = Math.PI / 24;

/** One press with Shift, in units of half the picture's height. */
const panPerKey = 0.1;

const zoomPerKey = 1.1;

const arrows: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const zooms: Readonly<Record<string, number>> = {
  '+': 1 / zoomPerKey,
  '=': 1 / zoomPerKey,
  '-': zoomPerKey,
  _: zoomPerKey,
};

/**
 * Handle a key: the arrows turn the volume in their direction, as dragging does, and move it with Shift; plus and minus zoom.
 * @param reset - called for the keys that go back to the first view
 * @returns whether the key has an effect here
 */
export function pressKey({ key, shiftKey }: KeyboardEvent, rig: CameraRig, reset: () => void): boolean {
  if (Object.hasOwn(arrows, key)) {
    const [x, y] = arrows[key];
    if (shiftKey) pan(rig, [x * panPerKey, y * panPerKey]);
    else rotate(rig, -x * turnPerKey, y * turnPerKey);
  } else if (Object.hasOwn(zooms, key)) zoomFrom(rig, zooms[key], [0, 0]);
  else if (key === '0' || key === 'Home') reset();
  else return false;
  return true;
}
