// The element as the page gets it by its script: the studio does not bundle it.
import type { VolumeView } from '../../../../src/index.ts';
import { cameraAttributes } from '../model/lesson.ts';

export type View = VolumeView;

/** The picture that the author works on. */
export const findPicture = (): View | null => document.querySelector<View>('#picture');

/** The picture of a scan that was opened and is not yet that of the lesson. */
export const findSource = (): View | null => document.querySelector<View>('#source');

/**
 * Sets attributes of a view, and those of the slice in it. The camera goes to its attributes if they change: they are then where it is.
 * @param goes - whether the camera goes there also if they do not change, as a person may have turned it
 */
export function applyView(view: View, wanted: Readonly<Record<string, string>>, goes: boolean): void {
  const { slice, ...own } = wanted;
  const before = (view.dataset.applied ?? '').split(' ').filter(Boolean);
  const names = new Set([...before, ...Object.keys(own), ...cameraNames]);
  let isCameraSet = false;
  for (const name of names) {
    const text = own[name] ?? null;
    const isForced = goes && cameraNames.includes(name);
    if (!isForced && view.getAttribute(name) === text) continue;
    isCameraSet ||= cameraNames.includes(name);
    // Only an attribute that is set takes a person's turn back.
    if (text === null && isForced) view.setAttribute(name, '');
    if (text === null) view.removeAttribute(name);
    else view.setAttribute(name, text);
  }
  view.dataset.applied = Object.keys(own).join(' ');
  if (isCameraSet && !goes) view.jumpCameraToGoal();
  applySlice(view.querySelector('volume-slice'), slice);
}

const cameraNames: readonly string[] = cameraAttributes;

/** @param text - 'axial 20', as the attribute of a step */
function applySlice(slice: Element | null, text: string | undefined): void {
  if (!slice) return;
  const [type, at] = (text ?? 'none').split(' ');
  slice.toggleAttribute('hidden', type === 'none');
  if (type === 'none') return;
  slice.setAttribute('type', type);
  if (at === undefined) slice.removeAttribute('at');
  else slice.setAttribute('at', at);
}

/**
 * The camera of a view as attributes. Where nobody has come nearer or moved it, its distance stays open, so that the volume fills narrow pictures
 * too.
 */
export function readCamera(view: View, home: Home | null): Record<string, string | null> {
  const texts = view.getView();
  const orbit = texts['camera-orbit'] ?? null;
  const { camera } = view;
  const isNear = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-3 * Math.abs(home!.radius);
  if (
    orbit !== null &&
    camera &&
    home &&
    isNear(camera.orbit.radius, home.radius) &&
    camera.target.every((x, i) => isNear(x, home.target[i]))
  ) {
    const [theta, phi] = orbit.split(' ');
    return { 'camera-orbit': `${theta} ${phi} auto`, 'camera-target': null, 'field-of-view': null };
  }
  return Object.fromEntries(cameraNames.map((name) => [name, texts[name] ?? null]));
}

/** Where the camera is before anybody moves it. */
export interface Home {
  readonly radius: number;
  readonly target: readonly number[];
}
