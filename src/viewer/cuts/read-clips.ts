import { isWrapper } from '../../page/page-children.ts';
import { VolumeViewError } from '../../core/errors.ts';
import type { Cutout, HalfSpace } from '../../optics/rays/clip-intervals.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import { createClip, createClipOfSlices } from '../../renderer/ray/modules/clip.ts';
import { createCutout, createCutoutOfSlices } from '../../renderer/ray/modules/cutout.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import { corners, unitToWorld } from '../../volume/grid.ts';
import { invertAffine, multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { boundsBetween, sidesOf } from '../../volume/world-cut.ts';
import type { Bounds, HalfWorld, WorldCut } from '../../volume/world-cut.ts';
import { meantParent } from '../../page/unclosed.ts';
import type { ClipShape } from '../model/clip-source.ts';
import { socketOf } from '../model/view-socket.ts';
import { invalid, parseNumbers } from '../model/parse-attributes.ts';
import { middleAlong, planeInCube } from './plane-in-cube.ts';

/** Planes that cut a volume at a time: X3D scenes may count on six. */
const maxPlanes = 6;

/** What cuts a volume, collected from all who have a say; in scene coordinates, heights exaggerated. */
class Clips {
  readonly planes: HalfWorld[] = [];
  readonly inside: Bounds[] = [];
  readonly outside: Bounds[] = [];
  error: VolumeViewError | null = null;

  attempt(act: () => void): void {
    try {
      act();
    } catch (thrown) {
      this.error ??= thrown as VolumeViewError;
    }
  }

  /** @returns those that a program knows */
  some<T>(all: readonly T[], most: number, words: string): readonly T[] {
    if (all.length > most) this.error ??= new VolumeViewError('attribute/invalid', `volume-view got ${all.length} ${words}`);
    return all.slice(0, most);
  }
}

/**
 * What of an element's volume is cut away: by its ClipPlane children, by `cutout`, and by elements elsewhere in the page. What
 * can't be read is left out, and the first error is told.
 * @param hasSlices - whether there are slices, which are cut too
 * @returns what cuts rays, and the same in the world
 */
export function readClips(host: Element, volume: Volume, hasSlices = false): { readonly cuts: readonly RayCut[]; readonly away: WorldCut; readonly error: VolumeViewError | null } {
  const clips = new Clips();
  for (const child of host.getElementsByTagName('*')) {
    if (child.localName.toLowerCase() === 'clipplane' && isAtTop(child, host)) clips.attempt(() => readX3dPlane(child, host, clips));
  }
  clips.attempt(() => readCutout(host.getAttribute('cutout'), volume, clips));
  for (const part of socketOf(host).parts) clips.attempt(() => readClip(part.clip?.() ?? null, volume, clips));

  const planes = clips.some(clips.planes, maxPlanes, `planes that cut its volume; expected at most ${maxPlanes}. Set enabled="false" on ClipPlanes that are not needed, and "hidden" on volume-clip elements.`);
  const [cutout] = clips.some(clips.outside, 1, 'boxes to cut out of its volume; expected one: cutout, or one volume-clip type="box" that keeps what is outside.');
  const kept = [...planes, ...sidesOf(clips.inside.map((bounds) => nearTo(volume, bounds)))].map(({ normal, at }): HalfSpace => ({ kind: 'half-space', ...planeInCube(normal, at, volume.grid) }));
  const cut = cutout && boxIn(nearTo(volume, cutout), volume);
  return {
    cuts: [...(kept.length > 0 ? [{ create: hasSlices ? createClipOfSlices : createClip, items: kept }] : []), ...(cut ? [{ create: hasSlices ? createCutoutOfSlices : createCutout, items: [cut] }] : [])],
    away: { kept: [...planes, ...sidesOf(clips.inside)], removed: cutout ?? null },
    error: clips.error,
  };
}

/** The halves of the world that ClipPlanes at the top of an element's scene leave of shapes; those that can't be read are left out. */
export function readAuthorPlanes(host: Element): readonly HalfWorld[] {
  const clips = new Clips();
  for (const child of host.getElementsByTagName('*')) {
    if (child.localName.toLowerCase() === 'clipplane' && isAtTop(child, host)) clips.attempt(() => readX3dPlane(child, host, clips));
  }
  return clips.planes;
}

/** What follows a volume node that was not closed, or is in the frame of a scene, is as if it stood beside. */
function isAtTop(plane: Element, host: Element): boolean {
  let around = meantParent(plane)!;
  while (around !== host && (isWrapper(around) || /volume(style|data)$|^(x3d|scene)$/i.test(around.localName))) around = meantParent(around)!;
  return around === host;
}

/** An X3D ClipPlane that stands at the top of the scene, as the volume does. */
function readX3dPlane(child: Element, host: Element, { planes }: Clips): void {
  const use = child.getAttribute('USE') ?? child.getAttribute('use');
  const element = (use !== null && host.querySelector(`[DEF="${CSS.escape(use)}"], [def="${CSS.escape(use)}"]`)) || child;
  const isOff = (name: string): boolean => (element.getAttribute(name) ?? 'true').trim().toLowerCase() !== 'true';
  if (isOff('on') || isOff('enabled')) return;
  const text = element.getAttribute('plane') ?? '0 1 0 0';
  const [a, b, c, d] = readPlane(text);
  planes.push({ normal: [a, b, c], at: -d });
}

/** @returns four numbers, the first three of which are of length 1 */
function readPlane(text: string): number[] {
  const wrong = invalid('plane of a ClipPlane', text, 'four numbers "a b c d", which keep what is where a x + b y + c z + d is not below 0; a, b and c may not all be 0');
  let numbers: number[];
  try {
    numbers = parseNumbers('plane', text, 4);
  } catch {
    throw wrong;
  }
  const size = Math.max(...numbers.slice(0, 3).map(Math.abs));
  const length = size * Math.hypot(...numbers.slice(0, 3).map((x) => x / size));
  const plane = numbers.map((x) => x / length);
  if (!(size > 0) || !plane.every((x) => Math.abs(x) < farthest)) throw wrong;
  return plane;
}

/** World units that no volume has. */
const farthest = 1e12;

function readCutout(text: string | null, volume: Volume, { outside }: Clips): void {
  if (text !== null && text.trim() !== '') outside.push(boundsBetween(parseNumbers('cutout', text, 6), stretchOf(volume.grid)));
}

function readClip(shape: ClipShape | null, volume: Volume, clips: Clips): void {
  if (!shape) return;
  if (shape.kind === 'plane') clips.planes.push(planeOf(shape, volume));
  else clips[shape.keep].push(boundsBetween(shape.box, stretchOf(volume.grid)));
}

/** In scene coordinates, whose heights may be exaggerated. */
function planeOf({ normal: [x, y, z], at }: ClipShape & { kind: 'plane' }, { grid }: Volume): HalfWorld {
  const normal: Vector3 = [x, y, z / stretchOf(grid)];
  return { normal, at: at ?? middleAlong(normal, corners(grid)) };
}

/** What of a box is of interest to a volume: no side is farther from it than the volume is large. */
function nearTo({ grid }: Volume, bounds: Bounds): Bounds {
  const places = corners(grid);
  return bounds.map(([from, to], axis) => {
    const own = places.map((place) => place[axis]);
    const [low, high] = [Math.min(...own), Math.max(...own)];
    const within = (x: number): number => Math.min(2 * high - low, Math.max(2 * low - high, x));
    return [within(from), within(to)];
  });
}

/** @returns null for a box that holds nothing */
function boxIn(bounds: Bounds, { grid }: Volume): Cutout | null {
  const sizes = bounds.map(([low, high]) => high - low) as unknown as Vector3;
  const worldToBox = sizes.every((size) => size > 0) ? invertAffine(scaleAndTranslate(sizes, bounds.map(([low]) => low) as unknown as Vector3)) : null;
  return worldToBox && { kind: 'cutout', unitToBox: multiply(worldToBox, unitToWorld(grid)) };
}
