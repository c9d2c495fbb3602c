// In the browser: small things in an element's pictures at rest, and what the element says of their errors.
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { loadVolume } from '../../src/worker/load.ts';
import { boundingSphere, finestSpacing } from '../../src/volume/grid.ts';
import { transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { measureThing, measureTrueError } from './compare-shown.ts';
import type { KeptThing } from './compare-shown.ts';
import { compareWithExact } from './exact-rays.ts';
import { cameraOf, distanceFor, placeElement, setSight, takeAtRest, webglOf } from './element-picture.ts';
import type { Sight } from './element-picture.ts';
import { castFullRays, findPixel } from './full-rays.ts';
import { realScenes, smallScenes } from './small-scenes.ts';
import type { SceneView } from './small-scenes.ts';

/** One picture at rest. */
export interface SmallPicture {
  readonly stats: RenderStats;
  readonly error: CoveredError;
  /** Pixels that the volume covers, as a share of all. */
  readonly coverage: number;
  /** By thing; null where the view does not hold it. */
  readonly things: readonly (KeptThing | null)[];
}

interface Uncertain {
  readonly ofSteps: number;
  readonly ofFloats: number;
}

/** What one of the element's levels leaves, whether it is taken or not. */
export interface LevelResult {
  readonly stepsPerVoxel: number;
  readonly substeps: number;
  readonly e: number;
  readonly things: SmallPicture['things'];
}

/** Steps a voxel, and the most substeps of each. */
const levels = [
  [1, 1],
  [2, 1],
  [4, 1],
  [1, 8],
  [2, 8],
  [4, 8],
] as const;

/** A scene from several angles. */
export interface SmallResult {
  readonly name: string;
  readonly pixelsPerVoxel: number;
  readonly ratio: number;
  readonly minContrast: number;
  readonly webgl: 1 | 2;
  readonly pictures: readonly SmallPicture[];
  /** How far full rays are from such with twice the steps, and some of them from float64, at the first angle: the largest, 1/255. */
  readonly uncertain: Uncertain;
  /** At the first angle. */
  readonly levels: readonly LevelResult[];
}

/** Where `max-error` is not 1, things count that stand out by so many times as much. */
const lostPerError = 8;

/** Between neighbouring angles, degrees. */
const turn = 1;

const stepsPerVoxel = 4;

/** Load a volume as an element does. */
export async function loadHere(url: string): Promise<Volume> {
  const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 30 };
  return loadVolume({ url, limits }, { signal: new AbortController().signal, onProgress: () => {} });
}

/** Make a volume a file that is stored nowhere. @returns its address */
export function serveVolume(volume: Volume): string {
  return URL.createObjectURL(new Blob([niftiBytes(volume)]));
}

/** Where the camera stands at an angle of a scene. */
export function sightOf(volume: Volume, { pixels, pixelsPerVoxel, theta, phi }: SceneView, turns: number): Sight {
  const radius = distanceFor({ pixels, pixelsPerVoxel, voxel: finestSpacing(volume.grid) });
  return {
    theta: theta + turns * turn,
    phi: phi + 0.3 * turns * turn,
    radius,
    target: boundingSphere(volume.grid).center,
  };
}

/** What is shown, and where its small things are. */
export interface Shown {
  readonly volume: Volume;
  readonly bare: Volume | null;
  readonly src: string;
  readonly places: readonly Vector3[];
  readonly reach: number;
}

/** @param name - of a scene */
export async function show(name: string): Promise<Shown> {
  const scene = smallScenes.find((one) => one.name === name);
  if (!scene) {
    const { url } = realScenes.find((one) => one.name === name)!;
    return { volume: await loadHere(url), bare: null, src: url, places: [], reach: 0 };
  }
  const { block, bare, places } = scene.make();
  const volume = block.toVolume();
  const toWorld = (place: Vector3): Vector3 => transformPoint(volume.grid.indexToWorld, place);
  return { volume, bare: bare.toVolume(), src: serveVolume(volume), places: places.map(toWorld), reach: scene.reach };
}

/** How a scene is measured. */
interface HowMeasured {
  /** Their number. */
  readonly angles: number;
  /** Whether full rays are held against better ones. */
  readonly doubts?: boolean;
  /** The element's; 1 if undefined. */
  readonly maxError?: number;
  /** What is being done. */
  readonly notify?: (what: string) => void;
}

/** @param name - of a scene */
export async function measureScene(
  name: string,
  { angles, doubts = true, maxError = 1, notify }: HowMeasured,
): Promise<SmallResult> {
  const { view, transferFunction } = [...smallScenes, ...realScenes].find((one) => one.name === name)!;
  const shown = await show(name);
  const gl = new StudyGl();
  // The rays that it is compared with have no light, which a scan has where its page asks for nothing.
  const attributes: Record<string, string> = {
    ...(transferFunction === null ? { shading: 'unlit' } : { 'transfer-function': transferFunction }),
    ...(maxError !== 1 && { 'max-error': String(maxError) }),
  };
  const element = placeElement({ src: shown.src, sight: sightOf(shown.volume, view, 0), attributes, ...view });
  const pictures: SmallPicture[] = [];
  let first: Pick<SmallResult, 'uncertain' | 'levels'> = { uncertain: { ofSteps: 0, ofFloats: 0 }, levels: [] };
  for (let angle = 0; angle < angles; angle++) {
    notify?.(`${name}, angle ${angle + 1} of ${angles}`);
    const sight = sightOf(shown.volume, view, angle);
    setSight(element, sight);
    const taken = await measureView(gl, element, shown, { sight, view });
    pictures.push(taken.picture);
    if (angle === 0 && doubts) first = { uncertain: await taken.doubt(), levels: await taken.drawLevels() };
  }
  const webgl = webglOf(element);
  element.remove();
  gl.forget(shown.volume);
  gl.dispose();
  const own = smallScenes.find((one) => one.name === name)?.minContrast ?? 0;
  const minContrast = own > 0 && maxError !== 1 ? Math.max(own, lostPerError * maxError) : own;
  return { name, pixelsPerVoxel: view.pixelsPerVoxel, ratio: view.ratio, minContrast, webgl, pictures, ...first };
}

/** A view that has been measured, and what else can be. */
interface MeasuredView {
  readonly picture: SmallPicture;
  doubt(): Promise<Uncertain>;
  drawLevels(): Promise<LevelResult[]>;
}

async function measureView(
  gl: StudyGl,
  element: VolumeView,
  { volume, bare, places, reach }: Shown,
  { sight, view }: { sight: Sight; view: SceneView },
): Promise<MeasuredView> {
  const size = view.pixels;
  const { data, stats } = await takeAtRest(element, size);
  const camera = cameraOf(sight);
  const asked = { volume, camera, optics: element.optics!, size, stepsPerVoxel };
  const full = await castFullRays(gl, asked);
  const without = bare && (await castFullRays(gl, { ...asked, volume: bare }));
  const measureThings = (shown: Uint8Array): SmallPicture['things'] =>
    without
      ? places.map((place) =>
          measureThing(
            { shown, full, bare: without, size },
            findPixel(camera, place, size),
            Math.max(1, reach * view.pixelsPerVoxel),
          ),
        )
      : [];
  const error = measureTrueError(data, full);
  const picture = { stats, error, coverage: error.covered / size ** 2, things: measureThings(data) };
  return {
    picture,
    async doubt() {
      const finer = await castFullRays(gl, { ...asked, stepsPerVoxel: 2 * stepsPerVoxel });
      const ofSteps = full.reduce((max, x, i) => Math.max(max, 255 * Math.abs(x - finer[i])), 0);
      return { ofSteps, ofFloats: Math.max(0, ...compareWithExact(asked, full)) };
    },
    async drawLevels() {
      const results: LevelResult[] = [];
      for (const [share, substeps] of levels) {
        const floats = await castFullRays(gl, { ...asked, stepsPerVoxel: share, substeps });
        const bytes = Uint8Array.from(floats, (x) => Math.round(255 * x));
        results.push({
          stepsPerVoxel: share,
          substeps,
          e: measureTrueError(bytes, full).e,
          things: measureThings(bytes),
        });
      }
      return results;
    },
  };
}

/** All scenes in their order, and whether small things are known in them. */
export function listScenes(): { name: string; hasThings: boolean }[] {
  return [
    ...smallScenes.map(({ name }) => ({ name, hasThings: true })),
    ...realScenes.map(({ name }) => ({ name, hasThings: false })),
  ];
}
