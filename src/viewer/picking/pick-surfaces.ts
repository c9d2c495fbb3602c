// Picks surfaces: loaded with the first pick where there are some.
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

/** The place where a ray meets a surface. */
export interface SurfaceHit {
  readonly element: Element;
  /** In the unit cube. */
  readonly place: Vector3;
  /** Parameter along the ray. */
  readonly t: number;
  readonly color: Color;
}

/** The end of a ray at a surface, and whether a picked place is that end. */
export interface SurfaceEnd {
  readonly hit: SurfaceHit;
  /** The surface is behind the matter in front of it, as slices are. */
  readonly stage: IntervalStage;
  /** @param place - the result of a pick, in the unit cube */
  isPicked(ray: Ray, place: Vector3): boolean;
}

/** Made with the first ray that needs them. */
const trees = new WeakMap<SurfacePart, TriangleTree>();

/** Larger than the rounding of a t. */
const slack = 1e-9;

/**
 * Where a ray ends at the surfaces of an element.
 * @param toWorld - from the unit cube, in which the ray is given
 * @param eyeT - t at which the ray begins
 * @returns null where the ray meets no surface
 */
export function endAtSurface(host: Element, ray: Ray, toWorld: Matrix4, eyeT: number): SurfaceEnd | null {
  const met = meetSurfaces(
    host,
    { origin: transformPoint(toWorld, ray.point), direction: transformDirection(toWorld, ray.direction) },
    eyeT,
  );
  if (!met) return null;
  const hit = { ...met, place: add(ray.point, scale(ray.direction, met.t)) };
  const behind: Premultiplied = [...hit.color, 1];
  let end = Infinity;
  return {
    hit,
    stage: (_, interval) => {
      const { entry, exit } = interval;
      // Outside the volume a ray meets nothing; a slice may be in front of the surface.
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

/** The nearest place at which a ray meets the parts of an element's surfaces that are not cut away. */
function meetSurfaces(host: Element, ray: WorldRay, from: number): Omit<SurfaceHit, 'place'> | null {
  const author = { kept: readAuthorPlanes(host), removed: null };
  let nearest: Omit<SurfaceHit, 'place'> | null = null;
  for (const { element, surface: shown } of socketOf(host).parts) {
    if (!element || !shown) continue;
    const cuts = shown.cut ? [author, shown.cut.away] : [author];
    const isThere = (t: number): boolean => cuts.every((cut) => isKept(cut, add(ray.origin, scale(ray.direction, t))));
    // These trees are of the whole surface: trees of the cut one would have to be built again after each cut.
    for (const part of (shown.cut?.whole ?? shown.surface).parts) {
      const t = treeOf(part).meet(ray, from).find(isThere);
      if (t !== undefined && !(nearest && nearest.t <= t)) nearest = { element, t, color: colorOf(shown) };
    }
  }
  return nearest;
}

/** Describe a place on a surface, with the value of the volume there, where the volume has data. */
export function describeSurface(
  volume: Volume,
  { element, place, color }: SurfaceHit,
  field: FieldStage,
  describePlace?: (volume: PolarVolume, place: Vector3) => Omit<RadarPlace, 'gate'>,
): VolumePick {
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
    surface: {
      type: element.localName === 'volume-terrain' ? 'terrain' : 'surface',
      element,
      radar: isPolar(volume) ? (describePlace?.(volume, place) ?? null) : null,
    },
  };
}

function treeOf(part: SurfacePart): TriangleTree {
  const tree = trees.get(part) ?? new TriangleTree(part);
  trees.set(part, tree);
  return tree;
}

/** The colour of a surface; of several colours the first: a pick describes the surface as a whole, not the place. */
function colorOf({ surface, color, usesOwnColors }: ShownSurface): Color {
  const own = usesOwnColors ? surface.parts[0].colors : null;
  return own ? [own[0], own[1], own[2]] : color;
}
