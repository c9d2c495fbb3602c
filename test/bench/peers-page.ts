// In the browser: time to a picture of a given error, ours and other renderers'.
import { fogMaterial } from '../../src/optics/transfer/lights.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { measureThing } from '../accuracy/compare-shown.ts';
import { findPixel } from '../accuracy/full-rays.ts';
import { eachVolume } from './bench-scenes.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { findFewest, listCounts } from './find-steps.ts';
import type { FoundSteps } from './find-steps.ts';
import { startOurs } from './own-peer.ts';
import { castReference, findLimit, viewRays } from './peer-limit.ts';
import type { Limit } from './peer-limit.ts';
import { drawPicture } from './peer.ts';
import type { Peer, Shown } from './peer.ts';
import { alignPlace, alignVolume, describeScene, findCamera } from './peer-scene.ts';
import type { PeerCamera, PeerScene } from './peer-scene.ts';
import type { QualityOptions } from './quality-page.ts';
import { median } from './table.mjs';
import '../helpers/provide-substeps.ts';

/** What keeps an error, and its time. */
export interface Reached extends FoundSteps {
  readonly ms: number;
  /** Ours: share of the pixels that get rays, and the `max-error` with which the picture has this error. */
  readonly rays?: number;
  readonly maxError?: number;
}

export interface PeerResult {
  /** Of its limit from the float64 reference: RMSE, 1/255; and the limit's steps. */
  readonly fromReference: number;
  readonly limitSteps: number;
  /** By the name of a target, see `targetsOf`; null where no number of steps reaches it, or none can be set. */
  readonly reached: Readonly<Record<string, Reached | null>>;
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

/** What a picture has to keep. */
interface Target {
  readonly name: string;
  /** E, see helpers/covered-error.ts. */
  readonly e: number;
  /** Whether each small thing that is there keeps three quarters of its contrast, too. */
  readonly keepsSmall?: boolean;
}

/** The name of the target that nothing small is dimmed. */
export const keepsSmall = 'small';

/** Of a small thing this much has to be left, where nothing small may be dimmed. */
const leastKept = 0.75;

/** Things count that stand out by this much, 1/255. */
const leastContrast = 8;

/** A thing is looked for this far from its place, in voxels. */
const reachOfThing = 1;

/** Our picture may need a smaller `max-error` than the error that it has to keep, as a share of that. */
const sharesOfError: readonly number[] = [1, 0.5, 0.25];

export interface PeersOptions extends QualityOptions {
  /** Addresses of bundled modules by name. */
  readonly modules: Readonly<Record<string, string>>;
  /** Each volume's first function is drawn lit, too, or lit alone, or not. */
  readonly lit: 'too' | 'only' | 'no';
}

/** The element, with `detail` as it is by default and with `free`: whether it is free. */
const ours: readonly (readonly [string, boolean])[] = [
  ['ours', false],
  ['ours, free', true],
];

/** Peers that light by gradients as we do; the same light and material go to each. */
const litPeers: readonly string[] = ['vtk'];

/** Lit, a peer tends to another picture than the reference, which does not tell where digits are lost: it takes no more than these. */
const maxLitSteps = 4096;

/** Of ours: a step is one linear piece of the transfer function's integral, so these are many. */
const maxOwnSteps = 2048;

/** Of a picture that takes longer, one is drawn, ms. */
const slow = 1000;

/** @param notify - what is being done */
export async function comparePeers(options: PeersOptions, notify: (what: string) => void): Promise<PeersRow[]> {
  const rows: PeersRow[] = [];
  for await (const { name, volume: loaded, functions, small } of eachVolume(
    options.scenes,
    new AbortController().signal,
  )) {
    const volume = alignVolume(loaded);
    const things = small && {
      bare: alignVolume(small.bare),
      places: small.places.map((place) => alignPlace(loaded, place)),
    };
    const looks = [
      ...(options.lit === 'only' ? [] : functions.map((one) => ({ ...one, isLit: false }))),
      ...(options.lit === 'no' ? [] : [{ ...functions[0], isLit: true }]),
    ];
    for (const { name: functionName, transferFunction, isLit } of looks) {
      const title = isLit ? `${functionName}, lit` : functionName;
      const results = await compareScene({ volume, transferFunction, isLit, things }, options, (what) =>
        notify(`${name}, ${title}, ${what}`),
      );
      for (const [size, bySize] of results)
        rows.push({ volume: name, transferFunction: title, size, isLit, results: bySize });
    }
  }
  return rows;
}

async function compareScene(
  shown: Shown,
  options: PeersOptions,
  notify: (what: string) => void,
): Promise<Map<number, Record<string, PeerResult>>> {
  const camera = findCamera(shown.volume);
  const references = new Map<boolean, number[]>();
  const results = new Map<number, Record<string, PeerResult>>(options.sizes.map((size) => [size, {}]));
  const peers = Object.keys(options.modules).filter((name) => !shown.isLit || litPeers.includes(name));
  for (const name of [null, ...peers]) {
    notify(name ?? 'ours');
    const host = document.createElement('div');
    document.body.append(host);
    const start = (volume: Volume): Promise<Peer> =>
      name === null
        ? startOurs(host, { ...shown, volume, camera })
        : startPeer(host, options.modules[name], {
            ...describeScene(volume, shown.transferFunction, camera),
            ...(shown.isLit && { light: fogMaterial }),
          });
    const peer = await start(shown.volume);
    const isParallel = peer.parallel !== undefined;
    if (!references.has(isParallel))
      references.set(
        isParallel,
        castReference(shown, viewRays(shown.volume, camera, peer.parallel), options.errorSize),
      );
    const maxSteps = name === null ? maxOwnSteps : shown.isLit ? maxLitSteps : Infinity;
    const limit = findLimit(peer, { shown, reference: references.get(isParallel)!, maxSteps }, options.errorSize);
    const measuring = { shown, camera, limit, start };
    for (const size of options.sizes) {
      const found =
        name === null
          ? await measureOurs(peer, measuring, { ...options, size })
          : { [name]: await measurePeer(peer, measuring, { ...options, size }) };
      Object.assign(results.get(size)!, found);
    }
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

interface Measuring {
  readonly shown: Shown;
  readonly camera: PeerCamera;
  readonly limit: Limit;
  /** The same renderer with another volume. */
  readonly start: (volume: Volume) => Promise<Peer>;
}

type SizedOptions = PeersOptions & { readonly size: number };

/** The error of a picture of this size for a target, against the renderer's own limit; Infinity where a small thing is dimmed. */
async function compareAt(
  peer: Peer,
  { shown: { volume, things }, camera, limit, start }: Measuring,
  size: number,
): Promise<(picture: Uint8Array, target: Target) => number> {
  const stepLength = stepLengthOf(volume.grid, limit.steps);
  peer.setSize(size);
  const full = drawPicture(peer, stepLength, size);
  const bare = things && (await drawBare(start, { bare: things.bare, stepLength }, size));
  return (picture, target) => {
    const { e } = compareCovered(picture, full, 1, 3);
    if (!target.keepsSmall || e > target.e) return e;
    const kept = leastOf(things!.places, { picture, full, bare: bare!, size }, { camera, grid: volume.grid });
    return kept < leastKept ? Infinity : e;
  };
}

/** Our pictures at rest. Their errors are those of the pictures that are timed. */
async function measureOurs(
  peer: Peer,
  measuring: Measuring,
  { size, targets, repeats, errorSize }: SizedOptions,
): Promise<Record<string, PeerResult>> {
  const { shown, limit } = measuring;
  const errorOf = await compareAt(peer, measuring, size);
  const results: Record<string, PeerResult> = {};
  for (const [name, isFree] of ours) {
    const reached: Record<string, Reached | null> = {};
    for (const target of targetsOf(targets, shown)) {
      reached[target.name] = null;
      for (const share of sharesOfError) {
        peer.setSize(size);
        const maxError = share * target.e;
        const chosen = await peer.choose!(maxError, isFree);
        const error = errorOf(drawPicture(peer, 1, size), target);
        if (error > target.e) continue;
        const ms = timePicture(() => drawPicture(peer, 1, 1), repeats);
        reached[target.name] = { ...chosen, error, ms, maxError };
        break;
      }
    }
    results[name] = describeResult(limit, errorSize, { fixedMs: null, reached });
  }
  return results;
}

/** The fewest steps of a peer. Errors are measured in small pictures of the same view. */
async function measurePeer(
  peer: Peer,
  measuring: Measuring,
  { size, targets, repeats, errorSize }: SizedOptions,
): Promise<PeerResult> {
  const {
    shown,
    shown: {
      volume: { grid },
    },
    limit,
  } = measuring;
  const time = (steps: number): number => timePicture(() => drawPicture(peer, stepLengthOf(grid, steps), 1), repeats);
  if (peer.isFixed) {
    peer.setSize(size);
    return describeResult(limit, errorSize, { fixedMs: time(autoSteps(grid)), reached: {} });
  }
  const errorOf = await compareAt(peer, measuring, errorSize);
  const counts = listCounts(limit.steps / 2);
  const drawn = new Map<number, Uint8Array>();
  const draw = (steps: number): Uint8Array => {
    if (!drawn.has(steps)) drawn.set(steps, drawPicture(peer, stepLengthOf(grid, steps), errorSize));
    return drawn.get(steps)!;
  };
  const found = new Map<string, FoundSteps | null>();
  for (const target of targetsOf(targets, shown))
    found.set(target.name, await findFewest(counts, target.e, (steps) => errorOf(draw(steps), target)));
  peer.setSize(size);
  const reached = Object.fromEntries([...found].map(([name, one]) => [name, one && { ...one, ms: time(one.steps) }]));
  return describeResult(limit, errorSize, { fixedMs: null, reached });
}

function describeResult(
  { steps, picture, fromReference }: Limit,
  errorSize: number,
  measured: Pick<PeerResult, 'fixedMs' | 'reached'>,
): PeerResult {
  return { fromReference, limitSteps: steps, picture: toDataUrl(picture, errorSize), ...measured };
}

function targetsOf(errors: readonly number[], { things }: Shown): Target[] {
  return [
    ...errors.map((e) => ({ name: String(e), e })),
    ...(things ? [{ name: keepsSmall, e: 1, keepsSmall: true }] : []),
  ];
}

/** A renderer's picture of a volume without its small things. */
async function drawBare(
  start: Measuring['start'],
  { bare, stepLength }: { bare: Volume; stepLength: number },
  size: number,
): Promise<Uint8Array> {
  const peer = await start(bare);
  peer.setSize(size);
  const picture = drawPicture(peer, stepLength, size);
  peer.dispose();
  return picture;
}

/** What is left of the thing that has lost most. */
function leastOf(
  places: readonly Vector3[],
  { picture, full, bare, size }: Record<'picture' | 'full' | 'bare', Uint8Array> & { size: number },
  { camera, grid }: { camera: PeerCamera; grid: Volume['grid'] },
): number {
  const toShares = (bytes: Uint8Array): Float32Array => Float32Array.from(bytes, (x) => x / 255);
  const pictures = { shown: picture, full: toShares(full), bare: toShares(bare), size };
  const { distance, fieldOfView } = camera;
  const pixelsPerVoxel = (size * finestSpacing(grid)) / (2 * distance * Math.tan(fieldOfView / 2));
  let least = 1;
  for (const place of places) {
    const thing = measureThing(pictures, findPixel(camera, place, size), Math.max(1, reachOfThing * pixelsPerVoxel));
    if (thing && thing.contrast >= leastContrast) least = Math.min(least, thing.kept);
  }
  return least;
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
