// What is at a place of a picture: loaded when somebody asks.
import { loadPart } from '../load-part.ts';
import { viewMatrix } from '../optics/camera.ts';
import { brighten } from '../optics/brighten.ts';
import { clipInterval, cutoutInterval } from '../optics/clip-intervals.ts';
import type { Cutout, HalfSpace } from '../optics/clip-intervals.ts';
import { groupedStagesOf, groupOptics } from '../optics/label-groups.ts';
import { groupOf, labelStages } from '../optics/labels.ts';
import { pickPlaces, pickRay } from '../optics/pick-ray.ts';
import type { RayPick } from '../optics/pick-ray.ts';
import { planeInterval } from '../optics/plane-slices.ts';
import type { PlaneSlice } from '../optics/plane-slices.ts';
import { projectionGather } from '../optics/projection.ts';
import type { IntervalStage, RayStages } from '../optics/ray-stages.ts';
import type { RayOptics } from '../optics/ray-classify.ts';
import { cartesianField } from '../optics/ray-field.ts';
import { rayThrough, setUpRays } from '../optics/rays.ts';
import type { RaySetup } from '../optics/rays.ts';
import { opticsOf } from '../optics/reference.ts';
import type { ReferenceScene } from '../optics/reference.ts';
import { evaluate } from '../optics/transfer-function.ts';
import type { TransferFunction } from '../optics/transfer-function.ts';
import type { RayCut } from '../renderer/ray/ray-module.ts';
import { writeColor } from '../optics/write-transfer-function.ts';
import { finestSpacing, longestDiagonal, unitToWorld } from '../volume/grid.ts';
import { transformPoint } from '../volume/matrix.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { isOn, labelOf, layersAt } from './pick-label.ts';
import { nearestVoxel } from './pick-voxel.ts';
import type { PickOptions, RadarPlace, VolumePick } from './volume-pick.ts';
import type { Viewer } from './viewer.ts';
import type { VolumeOptics } from './volume-info.ts';

/** A ray has no more steps than this, each of which may be cut into substeps. */
const mostSteps = 1500;

const noStages: Pick<RayStages, 'moreFields' | 'shades'> = { moreFields: [], shades: [] };

/** What of a scene is read where rays meet it. */
interface Picked {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly scene: ReferenceScene;
}

/**
 * What is at a place of the picture that stands in the page.
 * @param place - CSS pixels from the left and top edge of the picture
 * @returns null where nothing shows, outside the picture, and before there is one
 * @throws {VolumeViewError} `format/unsupported` where a part of the package is not there
 */
export async function pick(viewer: Viewer | null, [x, y]: readonly [x: number, y: number], options?: PickOptions | null): Promise<VolumePick | null> {
  const at = pickPlaces.find((one) => one === options?.at) ?? 'jump';
  const polar = viewer?.volume && isPolar(viewer.volume) ? await loadPart(import('./pick-radar.ts'), 'looks into radar volumes') : null;
  const host = viewer?.place.host;
  const surfaces = host?._surfaces ? await loadPart(import('./pick-surfaces.ts'), 'picks surfaces') : null;
  const isoPart = viewer?.optics?.surfaces ? await loadPart(import('../optics/pick-iso-surfaces.ts'), 'finds surfaces') : null;
  const volume = viewer?.volume;
  const optics = viewer?.optics;
  // What stands for a larger volume until that is there has none of its voxels.
  if (!volume || !optics || !viewer.drawn || volume.coarse || isPolar(volume) !== (polar !== null)) return null;
  const setup = raysOf(viewer, volume);
  const [across, down] = [x, y].map((pixels, axis) => pixels / (axis ? viewer.place.host.clientHeight : viewer.place.host.clientWidth));
  if (!setup || !(across >= 0 && across <= 1 && down >= 0 && down <= 1)) return null;
  const iso = isoPart && hasSurfaces(volume, optics) ? isoPart.surfaceStages(optics.surfaces!.surfaces, isClear(optics)) : null;
  const scene = await sceneOf(viewer, setup, { volume, optics });
  const picked: Picked = { volume, optics, scene: { ...scene, ...iso, moreFields: [...(scene.moreFields ?? []), ...(iso?.moreFields ?? [])] } };
  const { projection, lightFactor } = optics;
  const functions = projection ? [] : functionsOf(viewer, volume);
  const look = { transferFunction: brighten(optics.transferFunction, lightFactor), functions: functions.map((one) => brighten(one, lightFactor)), projection, isClear: iso !== null && isClear(optics) };
  const { slices, cuts } = viewer.pictures.parts.shown.cuts;
  const met = polar && isPolar(volume) ? polar.radarStages(volume, slices, optics) : planeStages(volume, cuts, look.transferFunction);
  const [own, ...groups] = keptOptics(picked, functions);
  const ray = rayThrough(setup, 2 * across - 1, 1 - 2 * down);
  const end = surfaces?.endAtSurface(host!, ray, unitToWorld(volume.grid), setup.eyeT);
  const stages = groupedStagesOf({ ...picked.scene, ...met, ends: [...clipStages(cuts), ...met.ends!, ...(end ? [end.stage] : [])] }, setup, groups, own);
  const found = pickRay(stages, ray, { at, look });
  if (!found) return null;
  if (end?.isPicked(ray, found.place)) return surfaces!.describeSurface(volume, end.hit, stages.field, polar?.describePlace);
  const there = stages.moreFields.reduce((known, stage) => stage(found.place, known), stages.field.sampleAt(found.place));
  const colors = look.functions[groupOf(there) - 1] ?? look.transferFunction;
  const { value: interpolated } = stages.field.sampleAt(found.place);
  const radar = polar && isPolar(volume) ? polar.describeRadar(volume, found.place) : null;
  const { labels, overlay } = viewer.pictures.parts.shown;
  const beside = layersAt(overlay, found.place, volume);
  const described = describe(picked, found, { interpolated, colors, radar, hasLayer: overlay?.shown.blend === 'mix' && typeof beside.layers?.[0].value === 'number' });
  return described && { ...described, ...labelOf(labels, found.place, described, volume), ...beside };
}

/** Neither values that are projected nor labels have surfaces. */
function hasSurfaces({ isDiscrete }: Volume, { projection, surfaces }: VolumeOptics): boolean {
  return surfaces !== null && !projection && !isDiscrete;
}

const isClear = ({ surfaces }: VolumeOptics): boolean => surfaces?.clear === true;

/** The rays of the picture: those of the scene, or else of where its camera stood when it went. */
function raysOf({ pictures: { parts }, rig, place: { host } }: Viewer, { grid }: Volume): RaySetup | null {
  const { region } = parts.shown.cuts;
  const view = parts.keeper.scene?.getView();
  if (view) return setUpRays(grid, view.view, view.projection, region);
  const { camera } = rig;
  const reach = 1 / Math.tan(camera.fieldOfView / 2);
  // Where rays run does not depend on how depth is written.
  return setUpRays(grid, viewMatrix(camera), [(reach * host.clientHeight) / host.clientWidth, 0, 0, 0, 0, reach, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0], region);
}

async function sceneOf(viewer: Viewer, setup: RaySetup, { volume, optics }: Pick<Picked, 'volume' | 'optics'>): Promise<ReferenceScene> {
  const { parts } = viewer.pictures;
  const { projection, styles, patches } = optics;
  const stepLength = Math.max(finestSpacing(volume.grid), longestDiagonal(parts.shown.grid) / mostSteps);
  const { labels, overlay } = parts.shown;
  const labelled = labels?.shown && isOn(labels.shown, volume) ? labelStages(labels.shown, projection !== null) : noStages;
  const overlaid = !projection && overlay?.isOver(volume) ? overlay.stages(optics, longestDiagonal(volume.grid)) : noStages;
  const styled = styles && !projection ? (await loadPart(import('./pick-styles.ts'), 'picks in rendering styles')).styledStages({ volume, optics: { ...optics, styles }, setup, cuts: parts.shown.cuts.cuts }) : noStages;
  const byGradient = patches && !projection && functionsOf(viewer, volume).length === 0;
  const patched: Partial<ReferenceScene> & typeof noStages = byGradient ? (await loadPart(import('./pick-patches.ts'), 'picks by gradients')).patchedStages({ volume, optics: { ...optics, patches }, setup }) : noStages;
  const beside = [labelled, overlaid, styled, patched];
  return { ...volume, ...optics, ...patched, stepLength, moreFields: beside.flatMap((one) => one.moreFields), shades: beside.flatMap((one) => one.shades), ...(projection && { gather: projectionGather(projection) }) };
}

/** What rays meet in a volume on a cartesian grid. */
function planeStages(volume: Volume, cuts: readonly RayCut[], colors: TransferFunction): Pick<ReferenceScene, 'field' | 'ends'> {
  const field = cartesianField({ ...volume, dimensions: volume.grid.dimensions });
  const planes = cuts.flatMap(({ items }) => items.filter((item) => (item as Partial<PlaneSlice>).kind === 'plane')) as readonly PlaneSlice[];
  return { field, ends: planes.length > 0 ? [planeInterval(planes, field, colors)] : [] };
}

/** What is cut away before rays meet anything. */
function clipStages(cuts: readonly RayCut[]): IntervalStage[] {
  const items = cuts.flatMap((cut) => cut.items) as readonly (HalfSpace | Cutout | PlaneSlice)[];
  const kept = items.filter((item) => item.kind === 'half-space');
  return [...(kept.length > 0 ? [clipInterval(kept)] : []), ...items.filter((item) => item.kind === 'cutout').map(cutoutInterval)];
}

/** The transfer functions of groups of labels. */
function functionsOf({ pictures: { parts } }: Viewer, volume: Volume): readonly TransferFunction[] {
  const { shown } = parts.shown.labels ?? {};
  return (shown && isOn(shown, volume) && shown.functions) || [];
}

let last: { readonly of: readonly unknown[]; readonly optics: readonly RayOptics[] } | null = null;

/** To make these takes longer than to cast the ray. */
function keptOptics({ volume, optics, scene }: Picked, functions: readonly TransferFunction[]): readonly RayOptics[] {
  const of = [volume.grid, optics, ...functions];
  if (last?.of.length !== of.length || !last.of.every((one, i) => one === of[i])) last = { of, optics: [opticsOf(scene), ...groupOptics(functions, scene)] };
  return last.optics;
}

/** What is known of a place beside the place itself. */
interface Known {
  readonly interpolated: number;
  /** Of the label there, or of the volume. Brightened. */
  readonly colors: TransferFunction;
  readonly radar: { readonly value: number; readonly place: RadarPlace } | null;
  /** Whether a layer shows there what is its own. */
  readonly hasLayer: boolean;
}

function describe({ volume, optics }: Picked, { place, color, surface }: RayPick, { interpolated, colors, radar, hasLayer }: Known): VolumePick | null {
  const hasData = !Number.isNaN(interpolated);
  const voxel = radar || !hasData || isPolar(volume) ? null : nearestVoxel(volume, place);
  // Of labels what the picture shows there, which need not be the nearest voxel's.
  const value = radar?.value ?? (volume.isDiscrete ? interpolated : (voxel?.value ?? NaN));
  if ((Number.isNaN(value) || !hasData) && !hasLayer) return null;
  const { unit, isDiscrete } = volume;
  const of = optics.surfaces?.surfaces.find(({ value: wanted }) => wanted === surface);
  const [red, green, blue, opacity] = evaluate(of ? brighten([{ ...of, opacity: 1 }], optics.lightFactor) : colors, interpolated);
  return {
    value,
    interpolated,
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
