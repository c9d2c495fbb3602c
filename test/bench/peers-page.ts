// In the browser: time to a picture of a given error, ours and other renderers'.
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../src/optics/rays/rays.ts';
import { fogMaterial } from '../../src/optics/transfer/lights.ts';
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { cutSteps, listLevels } from '../../src/quality/levels.ts';
import type { Level } from '../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { maxSubsteps } from '../../src/optics/rays/segment.ts';
import type { Matrix4, Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { eachVolume } from './bench-scenes.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { litStages } from '../helpers/lit.ts';
import { findFewest, findLevel, listCounts, remember } from './find-steps.ts';
import type { FoundSteps } from './find-steps.ts';
import { alignVolume, describeScene, findCamera } from './peer-scene.ts';
import type { PeerCamera, PeerScene } from './peer-scene.ts';
import type { QualityOptions } from './quality-page.ts';
import { median } from './table.mjs';
import '../helpers/provide-substeps.ts';

/** A renderer with a scene, see peers/README.md. */
interface Peer {
  readonly gl: WebGL2RenderingContext;
  readonly isFixed?: boolean;
  readonly parallel?: { readonly target: Vector3; readonly halfHeight: number };
  setSize(pixels: number): void;
  draw(stepLength: number): void;
  dispose(): void;
  /** Ours: the levels of a picture at rest, and which one is drawn from now on; others take any number of steps. */
  readonly levels?: readonly Level[];
  cut?(level: Level): void;
}

export interface PeerResult {
  /** Of its limit from the float64 reference: RMSE, 1/255; and the limit's steps. */
  readonly fromReference: number;
  readonly limitSteps: number;
  /** By target; null where no number of steps reaches it, or none can be set. */
  readonly reached: Readonly<Record<number, (FoundSteps & { ms: number }) | null>>;
  /** Of its only picture, where its step can't be set. */
  readonly fixedMs: number | null;
  /** Its limit, as a picture: a data: URL. */
  readonly picture: string;
}

export interface PeersRow {
  readonly volume: string;
  readonly transferFunction: string;
  readonly size: number;
  /** Lit: each renderer is judged against its own limit alone, as models of light differ. */
  readonly isLit: boolean;
  /** By renderer, ours first. */
  readonly results: Readonly<Record<string, PeerResult>>;
}

export interface PeersOptions extends QualityOptions {
  /** Addresses of bundled modules by name. */
  readonly modules: Readonly<Record<string, string>>;
  /** Each volume's first function is drawn lit, too, or lit alone, or not. */
  readonly lit: 'too' | 'only' | 'no';
}

/** Peers that light by gradients as we do; the same light and material go to each. */
const litPeers: readonly string[] = ['vtk'];

/**
 * Steps of a renderer's own limit: of these the largest number whose picture is about as near to the reference as any, as
 * some lose digits in very many steps. Pictures with up to half of them are compared with it.
 */
const limitSteps: readonly number[] = [1024, 2048, 4096, 8192];

/** Lit, a peer tends to another picture than the reference, which does not tell where digits are lost: it takes no more than these. */
const maxLitSteps = 4096;

/** Distances from the reference that differ by less are the same: RMSE, 1/255. */
const asNear = 0.25;

/** Rays along each side of the picture on which a limit is held against the reference. */
const referenceSide = 12;

/** Of a picture that takes longer, one is drawn, ms. */
const slow = 1000;

/** @param notify - what is being done */
export async function comparePeers(options: PeersOptions, notify: (what: string) => void): Promise<PeersRow[]> {
  const rows: PeersRow[] = [];
  for await (const { name, volume: loaded, functions } of eachVolume(options.scenes, new AbortController().signal)) {
    const volume = alignVolume(loaded);
    const looks = [
      ...(options.lit === 'only' ? [] : functions.map((one) => ({ ...one, isLit: false }))),
      ...(options.lit === 'no' ? [] : [{ ...functions[0], isLit: true }]),
    ];
    for (const { name: functionName, transferFunction, isLit } of looks) {
      const title = isLit ? `${functionName}, lit` : functionName;
      const results = await compareScene({ volume, transferFunction, isLit }, options, (what) =>
        notify(`${name}, ${title}, ${what}`),
      );
      for (const [size, bySize] of results)
        rows.push({ volume: name, transferFunction: title, size, isLit, results: bySize });
    }
  }
  return rows;
}

/** What all renderers are to show. */
interface Shown {
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly isLit: boolean;
}

async function compareScene(
  shown: Shown,
  options: PeersOptions,
  notify: (what: string) => void,
): Promise<Map<number, Record<string, PeerResult>>> {
  const camera = findCamera(shown.volume);
  const scene = {
    ...describeScene(shown.volume, shown.transferFunction, camera),
    ...(shown.isLit && { light: fogMaterial }),
  };
  const references = new Map<boolean, number[]>();
  const results = new Map<number, Record<string, PeerResult>>(options.sizes.map((size) => [size, {}]));
  const peers = Object.keys(options.modules).filter((name) => !shown.isLit || litPeers.includes(name));
  for (const name of ['ours', ...peers]) {
    notify(name);
    const host = document.createElement('div');
    document.body.append(host);
    const peer =
      name === 'ours'
        ? await startOurs(host, { ...shown, camera })
        : await startPeer(host, options.modules[name], scene);
    const isParallel = peer.parallel !== undefined;
    if (!references.has(isParallel))
      references.set(
        isParallel,
        castReference(shown, viewRays(shown.volume, camera, peer.parallel), options.errorSize),
      );
    const measured = await measurePeer(
      peer,
      {
        volume: shown.volume,
        reference: references.get(isParallel)!,
        maxSteps: shown.isLit && name !== 'ours' ? maxLitSteps : Infinity,
      },
      options,
    );
    for (const [size, result] of measured) results.get(size)![name] = result;
    peer.dispose();
    host.remove();
  }
  return results;
}

async function startPeer(host: HTMLElement, module: string, scene: PeerScene): Promise<Peer> {
  const { start } = (await import(/* @vite-ignore */ module)) as {
    start: (host: HTMLElement, scene: PeerScene) => Promise<Peer>;
  };
  return start(host, scene);
}

/** The scene of `<volume-view>`, x3dom and all. */
async function startOurs(
  host: HTMLElement,
  { volume, transferFunction, isLit, camera }: Shown & { camera: PeerCamera },
): Promise<Peer> {
  const scene = await VolumeScene.create(host, host, () => {});
  await scene.prepare(volume);
  scene.setVolume(volume);
  await scene.setAppearance({
    optics: {
      transferFunction,
      referenceLength: defaultReferenceLength(volume),
      opacityFactor: 1,
      lightFactor: 1,
    },
  });
  if (isLit) await scene.setAppearance({ style: { lit: true } });
  await scene.finished();
  return {
    gl: scene.canvas.getContext('webgl2')!,
    setSize(pixels) {
      changePlan(scene, { picture: { width: pixels, height: pixels } });
      changePlan(scene, { camera });
    },
    draw: (stepLength) => drawAt(scene, stepLength),
    dispose: () => scene.dispose(),
    levels: listLevels(autoSteps(volume.grid)),
    cut: (level) => changePlan(scene, { substeps: cutSteps(level, autoSteps(volume.grid), 1) }),
  };
}

async function measurePeer(
  peer: Peer,
  { volume, reference, maxSteps }: { volume: Volume; reference: readonly number[]; maxSteps: number },
  { sizes, targets, repeats, errorSize }: PeersOptions,
): Promise<Map<number, PeerResult>> {
  const compare = (picture: Uint8Array): number =>
    rms(
      referencePixels(errorSize).flatMap((at) => [...picture.subarray(at * 4, at * 4 + 4)]),
      reference,
    );
  const drawLevel = (
    { steps, substeps = maxSubsteps }: Pick<FoundSteps, 'steps' | 'substeps'>,
    size: number,
  ): Uint8Array => {
    peer.cut?.({ steps, substeps });
    return drawPicture(peer, stepLengthOf(volume.grid, steps), size);
  };
  peer.setSize(errorSize);
  const { limit, ofSteps, fromReference } = findLimit(
    (steps) => drawLevel({ steps }, errorSize),
    peer.isFixed ? [1] : limitSteps.filter((n) => n <= maxSteps),
    compare,
  );
  const errorOf = remember(
    async (level: Pick<FoundSteps, 'steps' | 'substeps'>) => compareCovered(drawLevel(level, errorSize), limit, 1, 3).e,
  );
  const counts = listCounts(ofSteps / 2);
  const found = new Map<number, FoundSteps | null>();
  for (const target of targets) {
    if (peer.isFixed) found.set(target, null);
    else if (peer.levels) found.set(target, await findLevel(peer.levels, target, errorOf));
    else found.set(target, await findFewest(counts, target, (steps) => errorOf({ steps })));
  }
  const picture = toDataUrl(limit, errorSize);
  return new Map(
    sizes.map((size) => {
      peer.setSize(size);
      const time = (level: Pick<FoundSteps, 'steps' | 'substeps'>): number =>
        timePicture(() => drawLevel(level, 1), repeats);
      return [
        size,
        {
          fromReference,
          limitSteps: ofSteps,
          picture,
          fixedMs: peer.isFixed ? time({ steps: autoSteps(volume.grid) }) : null,
          reached: Object.fromEntries([...found].map(([target, one]) => [target, one && { ...one, ms: time(one) }])),
        },
      ];
    }),
  );
}

function findLimit(
  drawSteps: (steps: number) => Uint8Array,
  candidates: readonly number[],
  compare: (picture: Uint8Array) => number,
): { limit: Uint8Array; ofSteps: number; fromReference: number } {
  const pictures = candidates.map((ofSteps) => {
    const limit = drawSteps(ofSteps);
    return { limit, ofSteps, fromReference: compare(limit) };
  });
  const min = Math.min(...pictures.map(({ fromReference }) => fromReference));
  const near = pictures.filter(({ fromReference }) => fromReference <= min + asNear);
  return near[near.length - 1];
}

/** RGBA over black, bottom row first. The context's own buffer is read in the task that drew it. */
function drawPicture({ gl, draw }: Peer, stepLength: number, size: number): Uint8Array {
  draw(stepLength);
  const pixels = new Uint8Array(size * size * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** Median time until the GPU has drawn a picture, ms: from the call to a pixel having been read. */
function timePicture(draw: () => void, repeats: number): number {
  const time = (): number => {
    const began = performance.now();
    draw();
    return performance.now() - began;
  };
  time(); // The first picture of a step or a size makes tables and buffers.
  const first = time();
  if (first > slow) return first;
  return median([first, ...Array.from({ length: repeats - 1 }, time)]);
}

/** Root mean square difference of the colours, 1/255. */
function rms(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) if (i % 4 < 3) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / ((a.length * 3) / 4));
}

/** The rays of a perspective picture, or of the parallel one that a peer draws from the same side. */
function viewRays(volume: Volume, camera: PeerCamera, parallel: Peer['parallel']): RaySetup {
  const { theta, phi, distance, fieldOfView } = camera;
  const from = parallel ? orbitCamera({ theta, phi, radius: distance }, parallel.target, fieldOfView) : camera;
  const projection = parallel ? parallelProjection(parallel.halfHeight) : projectionMatrix(fieldOfView, 1, 1, 2);
  const rays = setUpRays(volume.grid, viewMatrix(from), projection);
  if (!rays) throw new Error('the volume is flat');
  return rays;
}

function parallelProjection(halfHeight: number): Matrix4 {
  return [1 / halfHeight, 0, 0, 0, 0, 1 / halfHeight, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1];
}

/** Pixels that are compared with the reference: their indices in a picture. */
function referencePixels(errorSize: number): number[] {
  const places = Array.from({ length: referenceSide }, (_, i) => Math.floor(((i + 0.5) / referenceSide) * errorSize));
  return places.flatMap((row) => places.map((column) => row * errorSize + column));
}

/** These pixels in float64, RGBA, 0..255: no tables, no early ray termination, one step per voxel, with substeps. */
function castReference({ volume, transferFunction, isLit }: Shown, rays: RaySetup, errorSize: number): number[] {
  const { samples, slope, intercept } = volume;
  const looks = { transferFunction, referenceLength: defaultReferenceLength(volume), opacityFactor: 1, lightFactor: 1 };
  const scene = {
    grid: volume.grid,
    samples,
    slope,
    intercept,
    ...looks,
    stepLength: stepLengthOf(volume.grid, autoSteps(volume.grid)),
    ...(isLit && litStages(volume, transferFunction)),
  };
  const optics = opticsOf(scene);
  const toDevice = (n: number): number => ((n + 0.5) / errorSize) * 2 - 1;
  return referencePixels(errorSize).flatMap((at) => {
    const ray = rayThrough(rays, toDevice(at % errorSize), toDevice(Math.floor(at / errorSize)));
    return castSceneRay(scene, rays, ray, optics).map((channel) => channel * 255);
  });
}

function toDataUrl(pixels: Uint8Array, size: number): string {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const image = new ImageData(size, size);
  for (let row = 0; row < size; row++)
    image.data.set(pixels.subarray((size - 1 - row) * size * 4, (size - row) * size * 4), row * size * 4);
  for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
  canvas.getContext('2d')!.putImageData(image, 0, 0);
  return canvas.toDataURL();
}
