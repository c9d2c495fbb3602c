// Finds what is at a place of a picture: loaded with the first pick.
import { loadPart } from '../../core/load-part.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import { channelShade } from '../../optics/attachments/channel-colors.ts';
import { groupOf } from '../../optics/attachments/labels.ts';
import { pickPlaces, pickRay } from '../../optics/pick-ray.ts';
import type { RayPick } from '../../optics/pick-ray.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import { rayThrough } from '../../optics/rays/rays.ts';
import type { Ray } from '../../optics/rays/rays.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { evaluate } from '../../optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { writeColor } from '../../optics/transfer/write-transfer-function.ts';
import { finestSpacing, longestDiagonal, unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { invertAffine, transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type * as RadarPicks from './pick-radar.ts';
import { labelOf, layersAt } from './pick-label.ts';
import { nearestVoxel } from './pick-voxel.ts';
import { socketOf } from '../model/view-socket.ts';
import { raysOfView } from './view-rays.ts';
import type { ViewRays } from './view-rays.ts';
import type { Viewer } from '../view/viewer.ts';
import type { PickOptions, RadarPlace, VolumePick } from '../model/volume-pick.ts';

/** Maximum number of steps of a ray; each of them may be cut into substeps. */
const maxSteps = 1500;

/** A place that was picked, and the ray on which it lies. */
export interface PickedOnRay {
  readonly pick: VolumePick;
  /** In the unit cube. */
  readonly place: Vector3;
  readonly ray: Ray;
  readonly rays: ViewRays;
  /** Of the ray, without meshes. */
  readonly stages: RayStages;
}

/**
 * What is at a place of the picture that is on the page.
 * @param place - CSS pixels from the left and top edge of the picture
 * @returns null where nothing is visible, outside the picture, and before there is a picture
 * @throws {VolumeViewError} `format/unsupported` where a part of the package could not be loaded
 */
export async function pick(
  viewer: Viewer | null,
  place: readonly [x: number, y: number],
  options?: PickOptions | null,
): Promise<VolumePick | null> {
  return (await pickOnRay(viewer, place, options))?.pick ?? null;
}

/** See `pick`. */
export async function pickOnRay(
  viewer: Viewer | null,
  [x, y]: readonly [x: number, y: number],
  options?: PickOptions | null,
): Promise<PickedOnRay | null> {
  const at = pickPlaces.find((one) => one === options?.at) ?? 'jump';
  const polar = await loadPolar(viewer);
  const host = viewer?.place.host;
  const surfaces =
    host && socketOf(host).last('surface') ? await loadPart(import('./pick-surfaces.ts'), 'picks surfaces') : null;
  const rays = viewer && (await raysOfView(viewer, { placesOnly: true }));
  if (!rays || isPolar(rays.volume) !== (polar !== null)) return null;
  const { volume, optics, setup } = rays;
  const [across, down] = [x, y].map(
    (pixels, axis) => pixels / (axis ? viewer.place.host.clientHeight : viewer.place.host.clientWidth),
  );
  if (!(across >= 0 && across <= 1 && down >= 0 && down <= 1)) return null;
  const { shown } = viewer;
  const stages = rays.stages({
    stepLength: Math.max(finestSpacing(volume.finer?.grid ?? volume.grid), longestDiagonal(shown.grid) / maxSteps),
    maxSubsteps,
  });
  const ray = rayThrough(setup, 2 * across - 1, 1 - 2 * down);
  const end = surfaces?.endAtSurface(host!, ray, unitToWorld(volume.grid), setup.eyeT);
  const appearance = {
    ...rays,
    projection: optics.projection,
    intensityThreshold: optics.intensityThreshold,
    isClear: rays.hasSurfaces && optics.surfaces?.clear === true,
  };
  const found = pickRay({ ...stages, intervals: [...stages.intervals, ...(end ? [end.stage] : [])] }, ray, {
    at,
    look: appearance,
  });
  if (!found) return null;
  if (options?.finest !== false) await volume.finer?.planes?.readAt(found.place);
  const onRay = { place: found.place, ray, rays, stages };
  if (end?.isPicked(ray, found.place))
    return { ...onRay, pick: surfaces!.describeSurface(volume, end.hit, stages.field, polar?.describePlace) };
  const described = describeFound(found, { rays, stages, viewer, polar });
  return described && { ...onRay, pick: described };
}

/** What is looked at: a picture's rays, and the code for radars where the volume is a radar's. */
interface Looked {
  readonly rays: ViewRays;
  readonly stages: RayStages;
  readonly viewer: Viewer;
  readonly polar: typeof RadarPicks | null;
}

/** All about a place in the volume, with its label and layers; null where there is no data. */
function describeFound(found: RayPick, { rays, stages, viewer: { shown }, polar }: Looked): VolumePick | null {
  const { volume } = rays;
  const there = stages.moreFields.reduce(
    (known, stage) => stage(found.place, known),
    stages.field.sampleAt(found.place),
  );
  const colors = rays.functions[groupOf(there) - 1] ?? rays.transferFunction;
  const { value: interpolated } = stages.field.sampleAt(found.place);
  const radar = polar && isPolar(volume) ? polar.describeRadar(volume, found.place) : null;
  const { labels, overlay } = shown;
  const attached = layersAt(overlay, found.place, volume);
  const described = describe(rays, found, {
    interpolated,
    colors,
    radar,
    light: there.channels as Premultiplied | undefined,
    hasLayer: overlay?.shown.blend === 'mix' && typeof attached.layers?.at(-1)!.value === 'number',
  });
  return described && { ...described, ...labelOf(labels, found.place, described, volume), ...attached };
}

/**
 * What is at a place of the volume, whether anything hides it or not, with the opacity 1.
 * @param world - its world coordinates
 * @returns null where there is no data, outside of the volume, and before there is a picture
 * @throws {VolumeViewError} `format/unsupported` where a part of the package could not be loaded
 */
export async function pickPlace(viewer: Viewer | null, world: Vector3): Promise<VolumePick | null> {
  const polar = await loadPolar(viewer);
  const rays = viewer && (await raysOfView(viewer, { placesOnly: true }));
  if (!rays || isPolar(rays.volume) !== (polar !== null)) return null;
  const place = placeInCube(rays.volume.grid, world);
  if (!place) return null;
  const stages = rays.stages({ stepLength: finestSpacing(rays.volume.grid), maxSubsteps });
  return describeFound({ place, color: [0, 0, 0, 1] }, { rays, stages, viewer, polar });
}

/**
 * The value of another volume at a place, as a pick in it would give it; NaN where it has no data.
 * @param world - world coordinates
 */
export async function valueInVolume(volume: Volume, world: Vector3): Promise<number> {
  const place = placeInCube(volume.grid, world);
  if (!place) return NaN;
  if (!isPolar(volume)) return nearestVoxel(volume, place)?.value ?? NaN;
  const { describeRadar } = await loadPart(import('./pick-radar.ts'), 'looks into radar volumes');
  return describeRadar(volume, place)?.value ?? NaN;
}

/** A place in the unit cube of a volume; null outside of the volume. @param world - world coordinates */
function placeInCube(grid: GridFrame, world: Vector3): Vector3 | null {
  const toCube = invertAffine(unitToWorld(grid));
  const place = toCube && transformPoint(toCube, world);
  return place?.every((p) => p >= 0 && p <= 1) ? place : null;
}

const loadPolar = async (viewer: Viewer | null): Promise<typeof RadarPicks | null> =>
  viewer?.volume && isPolar(viewer.volume) ? loadPart(import('./pick-radar.ts'), 'looks into radar volumes') : null;

/** The colour of a place in the light of its channels. */
function underLight(own: Premultiplied, light: Premultiplied): Premultiplied {
  const end = { value: 0, valid: true, channels: light };
  return channelShade({ front: end, back: end, begin: 0, span: 0 }, own, {
    point: [0, 0, 0],
    direction: [0, 0, 1],
    lengthPerT: 1,
  });
}

/** What is known about a place, in addition to the place itself. */
interface Known {
  readonly interpolated: number;
  /** The transfer function of the label there, or of the volume. Brightened. */
  readonly colors: TransferFunction;
  readonly radar: { readonly value: number; readonly place: RadarPlace } | null;
  /** The light of the channels there, and their brightness; undefined where the volume has none. */
  readonly light: Premultiplied | undefined;
  /** Whether a layer has a value of its own there. */
  readonly hasLayer: boolean;
}

function describe(
  { volume, optics }: ViewRays,
  { place, color, surface }: RayPick,
  { interpolated, colors, radar, light, hasLayer }: Known,
): VolumePick | null {
  const hasData = !Number.isNaN(interpolated);
  const voxel = radar || !hasData || isPolar(volume) ? null : nearestVoxel(volume, place);
  // For labels: what the picture shows there, which may differ from the nearest voxel.
  const shown = volume.ids ? volume.ids[interpolated] : interpolated;
  const value = radar?.value ?? (volume.isDiscrete ? shown : (voxel?.value ?? NaN));
  if ((Number.isNaN(value) || !hasData) && !hasLayer) return null;
  const { unit, isDiscrete } = volume;
  const of = optics.surfaces?.surfaces.find(({ value: wanted }) => wanted === surface);
  const own = evaluate(of ? brighten([{ ...of, opacity: 1 }], optics.lightFactor) : colors, interpolated);
  const [red, green, blue, opacity] = light ? underLight(own, light) : own;
  return {
    value,
    interpolated: shown,
    ...(surface === undefined ? {} : { isoValue: surface }),
    unit,
    voxel: voxel && voxel.index,
    world: transformPoint(unitToWorld(volume.grid), place),
    ...(isDiscrete && hasData ? { label: String(value) } : {}),
    opacity: Math.min(1, color[3]),
    color: opacity > 0 ? writeColor([red / opacity, green / opacity, blue / opacity]) : '#000000',
    radar: radar && radar.place,
  };
}
