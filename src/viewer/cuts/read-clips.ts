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

/** The number of planes that may cut a volume at a time: X3D scenes may rely on six. */
const maxPlanes = 6;

/** Collects all that cuts a volume; in scene coordinates, with exaggerated heights. */
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

  /** @returns as many of them as the shader supports */
  some<T>(all: readonly T[], max: number, words: string): readonly T[] {
    if (all.length > max)
      this.error ??= new VolumeViewError('attribute/invalid', `volume-view got ${all.length} ${words}`);
    return all.slice(0, max);
  }
}

/**
 * All that is cut away from an element's volume: by its ClipPlane children, by `cutout`, and by elements elsewhere in the page.
 * What can't be read is left out, and the first error is returned.
 * @param hasSlices - whether there are slices: they are cut too
 * @returns the cuts for rays, and the same cuts in the world
 */
export function readClips(
  host: Element,
  volume: Volume,
  hasSlices = false,
): { readonly cuts: readonly RayCut[]; readonly away: WorldCut; readonly error: VolumeViewError | null } {
  const clips = new Clips();
  for (const child of host.getElementsByTagName('*')) {
    if (child.localName.toLowerCase() === 'clipplane' && isAtTop(child, host))
      clips.attempt(() => readX3dPlane(child, host, clips));
  }
  clips.attempt(() => readCutout(host.getAttribute('cutout'), volume, clips));
  for (const part of socketOf(host).parts) clips.attempt(() => readClip(part.clip?.() ?? null, volume, clips));

  const planes = clips.some(
    clips.planes,
    maxPlanes,
    `planes that cut its volume; expected at most ${maxPlanes}. Set enabled="false" on ClipPlanes that are not needed, and "hidden" on volume-clip elements.`,
  );
  const [cutout] = clips.some(
    clips.outside,
    1,
    'boxes to cut out of its volume; expected one: cutout, or one volume-clip type="box" that keeps what is outside.',
  );
  const kept = [...planes, ...sidesOf(clips.inside.map((bounds) => nearTo(volume, bounds)))].map(
    ({ normal, at }): HalfSpace => ({ kind: 'half-space', ...planeInCube(normal, at, volume.grid) }),
  );
  const cut = cutout && boxIn(nearTo(volume, cutout), volume);
  return {
    cuts: [
      ...(kept.length > 0 ? [{ create: hasSlices ? createClipOfSlices : createClip, items: kept }] : []),
      ...(cut ? [{ create: hasSlices ? createCutoutOfSlices : createCutout, items: [cut] }] : []),
    ],
    away: { kept: [...planes, ...sidesOf(clips.inside)], removed: cutout ?? null },
    error: clips.error,
  };
}

/** The half worlds that ClipPlanes at the top of an element's scene keep of shapes; planes that can't be read are left out. */
export function readAuthorPlanes(host: Element): readonly HalfWorld[] {
  const clips = new Clips();
  for (const child of host.getElementsByTagName('*')) {
    if (child.localName.toLowerCase() === 'clipplane' && isAtTop(child, host))
      clips.attempt(() => readX3dPlane(child, host, clips));
  }
  return clips.planes;
}

/**
 * Whether a plane is at the top of the scene. Elements that follow a volume node without an end tag, or that are inside the scene
 * element, count as siblings of the volume.
 */
function isAtTop(plane: Element, host: Element): boolean {
  let around = meantParent(plane)!;
  while (around !== host && (isWrapper(around) || /volume(style|data)$|^(x3d|scene)$/i.test(around.localName)))
    around = meantParent(around)!;
  return around === host;
}

/** Read an X3D ClipPlane at the top of the scene, where the volume is too. */
function readX3dPlane(child: Element, host: Element, { planes }: Clips): void {
  const use = child.getAttribute('USE') ?? child.getAttribute('use');
  const element =
    (use !== null && host.querySelector(`[DEF="${CSS.escape(use)}"], [def="${CSS.escape(use)}"]`)) || child;
  const isOff = (name: string): boolean => (element.getAttribute(name) ?? 'true').trim().toLowerCase() !== 'true';
  if (isOff('on') || isOff('enabled')) return;
  const text = element.getAttribute('plane') ?? '0 1 0 0';
  const [a, b, c, d] = readPlane(text);
  planes.push({ normal: [a, b, c], at: -d });
}

/** @returns four numbers; the vector of the first three has length 1 */
function readPlane(text: string): number[] {
  const wrong = invalid(
    'plane of a ClipPlane',
    text,
    'four numbers "a b c d", which keep what is where a x + b y + c z + d is not below 0; a, b and c may not all be 0',
  );
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

/** A distance in world units that is larger than any volume. */
const farthest = 1e12;

function readCutout(text: string | null, volume: Volume, { outside }: Clips): void {
  if (text !== null && text.trim() !== '')
    outside.push(boundsBetween(parseNumbers('cutout', text, 6), stretchOf(volume.grid)));
}

function readClip(shape: ClipShape | null, volume: Volume, clips: Clips): void {
  if (!shape) return;
  if (shape.kind === 'plane') clips.planes.push(planeOf(shape, volume));
  else clips[shape.keep].push(boundsBetween(shape.box, stretchOf(volume.grid)));
}

/** A plane in scene coordinates, whose heights may be exaggerated. */
function planeOf({ normal: [x, y, z], at }: ClipShape & { kind: 'plane' }, { grid }: Volume): HalfWorld {
  const normal: Vector3 = [x, y, z / stretchOf(grid)];
  return { normal, at: at ?? middleAlong(normal, corners(grid)) };
}

/** Limit a box to the surroundings of a volume: no side is farther from the volume than the volume is large. */
function nearTo({ grid }: Volume, bounds: Bounds): Bounds {
  const places = corners(grid);
  return bounds.map(([from, to], axis) => {
    const own = places.map((place) => place[axis]);
    const [low, high] = [Math.min(...own), Math.max(...own)];
    const within = (x: number): number => Math.min(2 * high - low, Math.max(2 * low - high, x));
    return [within(from), within(to)];
  });
}

/** @returns null for an empty box */
function boxIn(bounds: Bounds, { grid }: Volume): Cutout | null {
  const sizes = bounds.map(([low, high]) => high - low) as unknown as Vector3;
  const worldToBox = sizes.every((size) => size > 0)
    ? invertAffine(scaleAndTranslate(sizes, bounds.map(([low]) => low) as unknown as Vector3))
    : null;
  return worldToBox && { kind: 'cutout', unitToBox: multiply(worldToBox, unitToWorld(grid)) };
}
