// Surfaces that somebody points at: loaded with the first pick where there are some.
import type { FieldStage, IntervalStage } from '../../optics/rays/ray-stages.ts';
import type { Ray } from '../../optics/rays/rays.ts';
import { TriangleTree } from '../../optics/surfaces/triangle-tree.ts';
import type { WorldRay } from '../../optics/surfaces/triangle-tree.ts';
import type { Color, Premultiplied } from '../../optics/transfer/transfer-function.ts';
import { writeColor } from '../../optics/transfer/write-transfer-function.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import { unitToWorld } from '../../volume/grid.ts';
import type { SurfacePart } from '../../volume/surface.ts';
import { add, dot, scale, transformDirection, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { PolarVolume, Volume } from '../../volume/volume.ts';
import { isKept } from '../../volume/world-cut.ts';
import { socketOf } from '../model/view-socket.ts';
import { nearestVoxel } from './pick-voxel.ts';
import { readAuthorPlanes } from '../cuts/read-clips.ts';
import type { RadarPlace, VolumePick } from '../model/volume-pick.ts';

/** Where a ray meets a surface. */
export interface SurfaceHit {
  readonly element: Element;
  /** In the unit cube. */
  readonly place: Vector3;
  /** Of the ray. */
  readonly t: number;
  readonly color: Color;
}

/** A ray's end at a surface, and whether a place on it is that end. */
export interface SurfaceEnd {
  readonly hit: SurfaceHit;
  /** As slices do, the surface stands behind what is before it. */
  readonly stage: IntervalStage;
  /** @param place - that a pick found, in the unit cube */
  isPicked(ray: Ray, place: Vector3): boolean;
}

/** Made with the first ray that needs it. */
const trees = new WeakMap<SurfacePart, TriangleTree>();

/** More than rounding of a t. */
const slack = 1e-9;

/**
 * Where a ray ends at the surfaces of an element.
 * @param toWorld - from the unit cube in which the ray runs
 * @param eyeT - t at which it begins
 * @returns null where it meets none
 */
export function endAtSurface(host: Element, ray: Ray, toWorld: Matrix4, eyeT: number): SurfaceEnd | null {
  const met = meetSurfaces(host, { origin: transformPoint(toWorld, ray.point), direction: transformDirection(toWorld, ray.direction) }, eyeT);
  if (!met) return null;
  const hit = { ...met, place: add(ray.point, scale(ray.direction, met.t)) };
  const behind: Premultiplied = [...hit.color, 1];
  let end = Infinity;
  return {
    hit,
    stage: (_, interval) => {
      const { entry, exit } = interval;
      // Beside the volume a ray runs through nothing; a slice may stand before the surface.
      if (entry < exit && exit < hit.t && interval.behind) return interval;
      end = entry < exit ? Math.min(exit, hit.t) : entry;
      return { ...interval, exit: end, behind };
    },
    isPicked: ({ point, direction }, place) => {
      const along = add(place, scale(point, -1));
      return dot(along, direction) / dot(direction, direction) >= end - slack;
    },
  };
}

/** The nearest place at which a ray meets what is kept of an element's surfaces. */
function meetSurfaces(host: Element, ray: WorldRay, from: number): Omit<SurfaceHit, 'place'> | null {
  const author = { kept: readAuthorPlanes(host), removed: null };
  let nearest: Omit<SurfaceHit, 'place'> | null = null;
  for (const { element, surface: shown } of socketOf(host).parts) {
    if (!element || !shown) continue;
    const cuts = shown.cut ? [author, shown.cut.away] : [author];
    const isThere = (t: number): boolean => cuts.every((cut) => isKept(cut, add(ray.origin, scale(ray.direction, t))));
    // Trees of what is left would have to be made again after each cut.
    for (const part of (shown.cut?.whole ?? shown.surface).parts) {
      const t = treeOf(part).meet(ray, from).find(isThere);
      if (t !== undefined && !(nearest && nearest.t <= t)) nearest = { element, t, color: colorOf(shown) };
    }
  }
  return nearest;
}

/** What is told of a place on a surface: of the volume there too, where that has data. */
export function describeSurface(volume: Volume, { element, place, color }: SurfaceHit, field: FieldStage, describePlace?: (volume: PolarVolume, place: Vector3) => Omit<RadarPlace, 'gate'>): VolumePick {
  const isInside = place.every((x) => x >= 0 && x <= 1);
  const sampled = isInside ? field.sampleAt(place).value : Number.NaN;
  const interpolated = 'ids' in volume && volume.ids ? (volume.ids[sampled] ?? Number.NaN) : sampled;
  const voxel = !isPolar(volume) && !Number.isNaN(interpolated) ? nearestVoxel(volume, place) : null;
  return {
    value: voxel?.value ?? interpolated,
    interpolated,
    unit: volume.unit,
    voxel: voxel && voxel.index,
    world: transformPoint(unitToWorld(volume.grid), place),
    opacity: 1,
    color: writeColor(color),
    radar: null,
    surface: { type: element.localName === 'volume-terrain' ? 'terrain' : 'surface', element, radar: isPolar(volume) ? (describePlace?.(volume, place) ?? null) : null },
  };
}

function treeOf(part: SurfacePart): TriangleTree {
  const tree = trees.get(part) ?? new TriangleTree(part);
  trees.set(part, tree);
  return tree;
}

/** Of a surface of many colours the first: a pick's is that of a thing, not of a place. */
function colorOf({ surface, color, usesOwnColors }: ShownSurface): Color {
  const own = usesOwnColors ? surface.parts[0].colors : null;
  return own ? [own[0], own[1], own[2]] : color;
}
