// The rays of a viewer's picture in plain float64: loaded when somebody points at it, or checks it.
import { loadPart } from '../../core/load-part.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import { viewMatrix } from '../../optics/rays/camera.ts';
import { clipInterval, cutoutInterval } from '../../optics/rays/clip-intervals.ts';
import type { Cutout, HalfSpace } from '../../optics/rays/clip-intervals.ts';
import { groupedStagesOf, groupOptics } from '../../optics/label-groups.ts';
import { labelStages } from '../../optics/attachments/labels.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import { planeInterval } from '../../optics/attachments/plane-slices.ts';
import type { PlaneSlice } from '../../optics/attachments/plane-slices.ts';
import { projectionGather } from '../../optics/rays/projection.ts';
import type { RayOptics } from '../../optics/rays/ray-classify.ts';
import { cartesianField } from '../../optics/rays/ray-field.ts';
import type { IntervalStage, RayStages } from '../../optics/rays/ray-stages.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { opticsOf } from '../../optics/reference.ts';
import type { ReferenceScene } from '../../optics/reference.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import { longestDiagonal } from '../../volume/grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { isOn } from './pick-label.ts';
import type { Viewer } from '../view/viewer.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** How rays are walked. */
export type Walk = Pick<ReferenceScene, 'stepLength' | 'maxSubsteps' | 'leastSubsteps'>;

/** What a viewer shows, and the rays of its picture. Meshes and other shapes end none of them. */
export interface ViewRays {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly setup: RaySetup;
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Brightened: of groups of labels, from 1. */
  readonly functions: readonly TransferFunction[];
  /** Whether surfaces of values are shown. */
  readonly hasSurfaces: boolean;
  stages(walk: Walk): RayStages;
}

/** What is added to rays by one thing beside the volume. */
type Beside = Partial<ReferenceScene> & Pick<RayStages, 'moreFields' | 'shades'>;

const nothing: Beside = { moreFields: [], shades: [] };

/**
 * @param lights - what shines on the volume; null where only places and opacities matter, which light leaves as they are
 * @returns null before there is a picture, and where a coarser volume stands for what is on its way
 * @throws {VolumeViewError} `format/unsupported` where a part of the package is not there
 */
export async function raysOfView(viewer: Viewer, lights: SceneLights | null): Promise<ViewRays | null> {
  const polar = viewer.volume && isPolar(viewer.volume) ? await loadPart(import('./pick-radar.ts'), 'looks into radar volumes') : null;
  const { volume, optics } = viewer;
  // What stands for a larger volume until that is there has none of its voxels.
  if (!volume || !optics || !viewer.drawn || volume.coarse || isPolar(volume) !== (polar !== null)) return null;
  const setup = setUpView(viewer, volume);
  if (!setup) return null;
  const { cuts: { slices, cuts }, labels, overlay } = viewer.pictures.parts.shown;
  const transferFunction = brighten(optics.transferFunction, optics.lightFactor);
  const grouped = labels?.shown && isOn(labels.shown, volume) ? (labels.shown.functions ?? []) : [];
  const functions = optics.projection ? [] : grouped;
  const met = polar && isPolar(volume) ? polar.radarStages(volume, slices, { transferFunction, lightFactor: optics.lightFactor }) : planeStages(volume, cuts, transferFunction);
  const beside: Beside[] = [
    labels?.shown && isOn(labels.shown, volume) ? labelStages(labels.shown, optics.projection !== null) : nothing,
    !optics.projection && overlay?.isOver(volume) ? overlay.stages(optics, longestDiagonal(volume.grid)) : nothing,
    ...(optics.projection ? [{ ...nothing, gather: projectionGather(optics.projection, optics.intensityThreshold) }] : await styleStages({ volume, optics, setup, cuts, lights, hasGroups: grouped.length > 0 })),
  ];
  const scene = {
    ...volume,
    ...optics,
    ...beside.reduce((all, one) => ({ ...all, ...one }), nothing),
    ...met,
    ends: [...clipStages(cuts), ...met.ends!],
    moreFields: beside.flatMap((one) => one.moreFields),
    shades: beside.flatMap((one) => one.shades),
    stepLength: 0,
  };
  const [own, ...groups] = keptOptics({ volume, optics, scene }, functions);
  return {
    volume, optics, setup, transferFunction,
    functions: functions.map((one) => brighten(one, optics.lightFactor)),
    hasSurfaces: showsSurfaces(volume, optics),
    stages: (walk) => groupedStagesOf({ ...scene, ...walk }, setup, groups, own),
  };
}

/** The rays of the picture: those of the scene, or else of where its camera stood when it went. */
function setUpView({ pictures: { parts }, rig, place: { host } }: Viewer, { grid }: Volume): RaySetup | null {
  const { region } = parts.shown.cuts;
  const view = parts.keeper.scene?.getView();
  if (view) return setUpRays(grid, view.view, view.projection, region);
  const { camera } = rig;
  const reach = 1 / Math.tan(camera.fieldOfView / 2);
  // Where rays run does not depend on how depth is written.
  return setUpRays(grid, viewMatrix(camera), [(reach * host.clientHeight) / host.clientWidth, 0, 0, 0, 0, reach, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0], region);
}

/** What styles are made of. */
interface Styled {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly setup: RaySetup;
  readonly cuts: readonly RayCut[];
  readonly lights: SceneLights | null;
  /** Whether groups of labels have transfer functions of their own. */
  readonly hasGroups: boolean;
}

/** Neither values that are projected nor labels have surfaces. */
function showsSurfaces({ isDiscrete }: Volume, { projection, surfaces }: VolumeOptics): boolean {
  return surfaces !== null && !projection && !isDiscrete;
}

async function styleStages({ volume, optics, setup, cuts, lights, hasGroups }: Styled): Promise<Beside[]> {
  const { styles, patches, surfaces } = optics;
  const all: Beside[] = [];
  if (lights) all.push((await loadPart(import('./shaded-rays.ts'), 'lights rays')).shadedRays({ volume, optics, setup, cuts, lights }));
  else {
    const dress = surfaces?.surfaceStyles;
    const part = styles || dress ? await loadPart(import('./pick-styles.ts'), 'picks in rendering styles') : null;
    const rays = { volume, optics, setup, cuts };
    if (styles) all.push(part!.styledStages(rays, styles));
    if (surfaces && showsSurfaces(volume, optics)) {
      const { surfaceStages } = await loadPart(import('../../optics/pick-iso-surfaces.ts'), 'finds surfaces');
      all.push({ ...nothing, ...surfaceStages(surfaces.surfaces, surfaces.clear === true, dress && part!.surfaceStylesOf(rays, dress)) });
    }
  }
  if (patches && !hasGroups) all.push((await loadPart(import('./pick-patches.ts'), 'picks by gradients')).patchedStages({ volume, optics: { ...optics, patches }, setup }));
  return all;
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

let last: { readonly of: readonly unknown[]; readonly optics: readonly RayOptics[] } | null = null;

/** To make these takes longer than to cast the ray. */
function keptOptics({ volume, optics, scene }: { readonly volume: Volume; readonly optics: VolumeOptics; readonly scene: ReferenceScene }, functions: readonly TransferFunction[]): readonly RayOptics[] {
  const of = [volume.grid, optics, ...functions];
  if (last?.of.length !== of.length || !last.of.every((one, i) => one === of[i])) last = { of, optics: [opticsOf(scene), ...groupOptics(functions, scene)] };
  return last.optics;
}
