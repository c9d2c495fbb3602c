import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import type { Cutout, HalfSpace } from '../../src/optics/rays/clip-intervals.ts';
import type { ShownOverlay } from '../../src/optics/attachments/overlay.ts';
import type { PlaneSlice } from '../../src/optics/attachments/plane-slices.ts';
import { askTwoByteFilter } from '../../src/renderer/probes/probe-device.ts';
import type { ProjectionKind } from '../../src/optics/rays/ray-style.ts';
import { maxSubsteps } from '../../src/optics/transfer/substep-limits.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../src/optics/rays/rays.ts';
import { renderStages } from '../../src/optics/reference.ts';
import type { RayStages } from '../../src/optics/rays/ray-stages.ts';
import type { ReferenceScene } from '../../src/optics/reference.ts';
import { radarTwins } from '../../src/radar/gpu/radar-twins.ts';
import { sameGates } from '../../src/radar/gpu/second-moment.ts';
import type { Slice } from '../../src/radar/slices.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { isPolar } from '../../src/volume/volume.ts';
import { unitToWorld } from '../../src/volume/grid.ts';
import type { GridFrame } from '../../src/volume/grid.ts';
import type { ShownLabels } from '../../src/volume/labels.ts';
import { transformDirection, transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { loadCartesianChunks } from '../../src/renderer/ray/modules/cartesian-field.ts';
import { createPlanes } from '../../src/renderer/ray/modules/plane-slices.ts';
import { createClip } from '../../src/renderer/ray/modules/clip.ts';
import { createCutout } from '../../src/renderer/ray/modules/cutout.ts';
import type { VolumeLayer } from '../../src/renderer/layers/volume-layer.ts';
import { composeTwins } from '../../src/renderer/ray/compose-twins.ts';
import { groupsTwin } from '../../src/renderer/ray/modules/label-functions.ts';
import { groupAppearances, labelAppearances } from '../../src/renderer/ray/modules/label-appearances.ts';
import { labelsTwin } from '../../src/renderer/ray/modules/labels.ts';
import { shadingTwins } from '../../src/renderer/ray/modules/field-taps.ts';
import { overlayTwins } from '../../src/renderer/ray/modules/overlay.ts';
import { projectionTwin } from '../../src/renderer/ray/modules/projection.ts';
import { usualTwins } from '../../src/renderer/ray/ray-twin.ts';
import type { Optics, RayCut, RayModule, RayTwin, StageName } from '../../src/renderer/ray/ray-module.ts';
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { takesAll } from './cases.ts';
import { keyOf } from './key-of.ts';
import { createQuietLayer } from './quiet-layer.ts';
import { readPixels } from './read-pixels.ts';
import { syntheticVolume } from './synthetic.ts';
import { evenAzimuths, radarVolume } from './synthetic-radar.ts';

/** The size of a test picture in pixels: large enough for every kind of ray, small enough for software GL. */
export const [width, height] = [48, 36];

/** Blue air, red shell, white core; no jumps, no opacity of 1. */
export const shells: TransferFunction = [
  { value: 0.15, color: [0, 0, 0.4], opacity: 0 },
  { value: 0.4, color: [0.9, 0.3, 0.1], opacity: 0.06 },
  { value: 0.8, color: [1, 1, 0.8], opacity: 0.35 },
];

/** A transfer function that the usual table can't hold. */
const jump: TransferFunction = [shells[0], { ...shells[1], value: shells[0].value }];

export const plainOptics: Optics = { transferFunction: shells, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };

export interface SceneOptions {
  /** Request WebGL 1, as x3dom does on Apple's systems. */
  readonly webgl1?: boolean;
  /** X3D of the page's author, as HTML. */
  readonly children?: string;
  readonly needsFrame?: () => void;
}

/** Run `use` with its own scene, which is removed afterwards. */
export async function withScene<T>(
  options: SceneOptions,
  use: (scene: VolumeScene, host: HTMLElement) => T | Promise<T>,
): Promise<T> {
  const host = document.createElement('div');
  host.innerHTML = options.children ?? '';
  const container = document.createElement('div');
  document.body.append(host, container);
  const scene = await createScene(host, container, options);
  try {
    return await use(scene, host);
  } finally {
    scene.dispose();
    host.remove();
    container.remove();
  }
}

/** Timeout of a scene's first draws, ms: they wait for the draws of all other pages, because one process draws for all pages. */
const sceneTimeout = 120_000;

/**
 * A scene for all tests of a suite: it starts before the first test and is removed after the last one. Call it within `describe`.
 * Each test finds the scene in the state in which the test before left it.
 */
export function shareScene(options: SceneOptions): () => VolumeScene {
  const container = document.createElement('div');
  let scene: VolumeScene;
  before(async function () {
    this.timeout(sceneTimeout);
    document.body.append(container);
    scene = await createScene(document.createElement('div'), container, options);
  });
  after(() => {
    scene.dispose();
    container.remove();
  });
  return () => scene;
}

async function createScene(host: Element, container: Element, options: SceneOptions): Promise<VolumeScene> {
  if (options.webgl1) Object.defineProperty(navigator, 'platform', { value: 'MacIntel', configurable: true });
  try {
    const scene = await VolumeScene.create(host, container, options.needsFrame ?? (() => {}), fieldProviders);
    await Promise.all([askTwoByteFilter(scene.device), loadCartesianChunks()]); // Load now, because tests set volumes without `prepare`.
    await scene.setAppearance({ optics: { ...plainOptics, transferFunction: jump } });
    await scene.setAppearance({ optics: plainOptics });
    scene.apply({ ...scene.plan, picture: { width, height } });
    return scene;
  } finally {
    if (options.webgl1) Reflect.deleteProperty(navigator, 'platform');
  }
}

/** Half-spaces that are kept, and a box that is cut out. */
export interface Clips {
  readonly kept?: readonly HalfSpace[];
  readonly cutout?: Cutout;
}

export interface View {
  readonly volume: Volume;
  readonly camera: Camera;
  /** Length of a step in world units. */
  readonly stepLength: number;
  readonly optics?: Optics;
  readonly slices?: readonly Slice[];
  /** Planes that are shown. */
  readonly planes?: readonly PlaneSlice[];
  /** The cuts of the volume. */
  readonly clips?: Clips;
  /** The projection of the reference; the test has to set it in the scene with `setAppearance`. */
  readonly projection?: ProjectionKind | null;
  /** See `RayStyle.intensityThreshold`. */
  readonly intensityThreshold?: number;
  /** The labels of the reference; the test has to set them in the scene with `setLabels`. */
  readonly labels?: ShownLabels | null;
  /** The second field of the reference; the test has to set it in the scene with `setOverlay`. */
  readonly overlay?: ShownOverlay | null;
  /** The part of the volume that is shown; the whole volume if absent. */
  readonly region?: GridFrame | null;
  /** More modules of the reference; the test has to set them in the scene with `setModules`, or with `setAppearance` if they belong to a style. */
  readonly modules?: readonly RayModule[];
  /** The maximum substeps of a step. If absent: the general maximum in the reference, and the scene's own setting in the picture. */
  readonly maxSubsteps?: number;
  /** Pixels across and down; the scene has to have this size. `width` and `height` if absent. */
  readonly size?: readonly [number, number];
}

/** A view with each of the two walks of a ray, see walk-steps.glsl and walk-substeps.glsl. */
export function bothWalks(view: View): View[] {
  return [1, maxSubsteps].map((max) => ({ ...view, maxSubsteps: max }));
}

/**
 * The walks that a test of many views draws: one for each view, in turns. `npm run accuracy -- claims` draws both in WebGL 2.
 * @param index - of the view among those of the test
 */
export function walksOf(view: View, index: number): readonly View[] {
  const both = bothWalks(view);
  return takesAll ? both : [both[index % both.length]];
}

/**
 * Chooses the walks of a view that a version of WebGL draws, of those that `walksOf` gave: WebGL 1 never draws both.
 * @param index - of the view among those of the test
 */
export function walksIn<T>(version: 1 | 2, index: number, walks: readonly T[]): readonly T[] {
  return version === 2 ? walks : [walks[index % walks.length]];
}

/** Draw a view with the GPU. */
export function drawPicture(scene: VolumeScene, view: View): Uint8ClampedArray {
  const { volume, camera, stepLength, optics = plainOptics, slices = [], region = null, maxSubsteps } = view;
  scene.setVolume(volume);
  void scene.setAppearance({ optics }); // It resolves at once: `createScene` has loaded all parts that optics may need.
  const substeps = maxSubsteps ? { ...allSubsteps, max: maxSubsteps } : scene.plan.substeps;
  scene.apply({ ...scene.plan, camera, stepLength, substeps, slices, cuts: cutsOf(view), region });
  scene.draw();
  return readPixels(scene);
}

function cutsOf({ planes = [], clips }: View): readonly RayCut[] {
  const cuts: RayCut[] = [
    { create: createClip, items: clips?.kept ?? [] },
    { create: createCutout, items: clips?.cutout ? [clips.cutout] : [] },
    { create: createPlanes, items: planes },
  ];
  return cuts.filter(({ items }) => items.length > 0);
}

/** The rays of a camera, computed without x3dom. */
export function raysOf({ volume, camera, region = null, size: [across, down] = [width, height] }: View): RaySetup {
  return setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, across / down, 1, 2), region)!;
}

const references = new Map<string, Float64Array>();

/** The same view in float64, 0..255. It is computed once for each view, because both versions of WebGL draw it. */
export function drawReference(view: View, surfaceT?: (ray: Ray) => number): Float64Array {
  const key = keyOf([view, surfaceT]);
  const picture =
    references.get(key) ??
    renderStages(stagesOfView(view, surfaceT), raysOf(view), ...(view.size ?? [width, height])).map((x) => x * 255);
  references.set(key, picture);
  return picture.slice(); // A copy, so that a caller may write into it.
}

/** A layer that draws nothing: the twins of its modules give the reference. */
const quiet = await prepareLayer();

async function prepareLayer(): Promise<VolumeLayer> {
  const layer = createQuietLayer();
  const some = syntheticVolume({ dimensions: [2, 2, 2] });
  const radar = radarVolume({ sweeps: [{ elevation: 1, azimuths: evenAzimuths(4), gates: 2 }] });
  for (const volume of [some, { ...some, isDiscrete: true }, radar])
    await layer.prepare(volume, { ...plainOptics, transferFunction: jump });
  await Promise.all([usualTwins.load(), shadingTwins.load(), radarTwins.load(), loadCartesianChunks()]);
  return layer;
}

/** The stages of a view's rays in float64, from the twins of the modules that draw it. */
export function stagesOfView(view: View, surfaceT?: (ray: Ray) => number): RayStages {
  const { volume, optics = plainOptics, slices = [], stepLength, maxSubsteps: max = maxSubsteps } = view;
  quiet.set(volume);
  void quiet.setAppearance({ optics }); // It resolves at once: all parts that optics may need are loaded.
  quiet.plan = { ...quiet.plan, slices, cuts: cutsOf(view) };
  quiet.setModules(attachedModules(view));
  const frame = { volume, optics, rays: raysOf(view), placesOnly: false, ...(surfaceT && { shapeT: surfaceT }) };
  return composeTwins(quiet.twins(surfaceT !== undefined, max > 1)!, frame, { stepLength, maxSubsteps: max });
}

/** The modules of `setLabels`, `setOverlay` and `setAppearance`: these calls are asynchronous, so the quiet layer can't use them. */
function attachedModules({ labels, overlay, projection, intensityThreshold, modules = [] }: View): RayModule[] {
  const functions = (!projection && labels?.functions) || null;
  const layer = overlay && overlayTwins(overlay, isPolar(overlay.volume) ? sameGates : undefined);
  const own: (RayModule | null | false | undefined)[] = [
    labels && moduleOf('labels', 'field', labelsTwin(labels, Boolean(projection))),
    functions && moduleOf('labelFunctions', 'classify', groupsTwin(functions)),
    labels && !projection && (functions ? groupAppearances : labelAppearances),
    layer && moduleOf('overlay', 'field', layer.field),
    layer && moduleOf('overlayAppearance', 'shade', layer.look),
    projection && moduleOf(projection, 'gather', projectionTwin({ kind: projection, threshold: intensityThreshold })),
  ];
  return [...own.filter((one): one is RayModule => Boolean(one)), ...modules];
}

/** A module that is never drawn. */
function moduleOf(name: string, stage: StageName, twin: RayTwin): RayModule {
  return {
    name,
    stage,
    twin,
    ...(stage === 'field' && { members: [] }),
    defines: {},
    chunks: [],
    samplers: [],
    sparesRays: true,
    order: 1,
    inputs: () => ({ uniforms: {}, units: [] }),
  };
}

/** The same view as a scene of the reference, for tests that replace one of its stages. */
export function referenceOf(view: View, surfaceT?: (ray: Ray) => number): ReferenceScene {
  const { volume, optics = plainOptics, stepLength, projection, modules, maxSubsteps: max } = view;
  const {
    intervals: [, ...ends],
    field,
    moreFields,
    shades,
    gather,
    classify,
  } = stagesOfView(view, surfaceT);
  return {
    ...volume,
    ...optics,
    stepLength,
    ends,
    field,
    moreFields,
    shades,
    ...(projection && { gather }),
    ...(modules && { classifyBy: () => classify }),
    ...(max && { maxSubsteps: max }),
  };
}

export interface Difference {
  readonly worst: number;
  readonly rmse: number;
}

/** The difference of two pictures, in 1/255, without the pixels for which `skip` is true. */
export function comparePictures(
  a: ArrayLike<number>,
  b: ArrayLike<number>,
  skip: (pixel: number) => boolean = () => false,
): Difference {
  let [worst, sum, count] = [0, 0, 0];
  for (let i = 0; i < a.length; i++) {
    if (skip(i >> 2)) continue;
    const difference = Math.abs(a[i] - b[i]);
    worst = Math.max(worst, difference);
    sum += difference ** 2;
    count++;
  }
  return { worst, rmse: Math.sqrt(sum / count) };
}

/** A ray in the world: origin at t = 0, direction per t. */
export function rayInWorld(volume: Volume, ray: Ray): { origin: Vector3; direction: Vector3 } {
  const toWorld = unitToWorld(volume.grid);
  return { origin: transformPoint(toWorld, ray.point), direction: transformDirection(toWorld, ray.direction) };
}

/** t at which a ray meets a box with edges along the world's axes; Infinity if it misses the box. */
export function meetBox(volume: Volume, ray: Ray, { center, size }: { center: Vector3; size: number }): number {
  const { origin, direction } = rayInWorld(volume, ray);
  let [entry, exit] = [-Infinity, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    const ends = [-0.5, 0.5].map((side) => (center[axis] + side * size - origin[axis]) / direction[axis]);
    entry = Math.max(entry, Math.min(...ends));
    exit = Math.min(exit, Math.max(...ends));
  }
  return entry < exit ? entry : Infinity;
}
