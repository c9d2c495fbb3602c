// In the browser: a renderer's picture with very many steps, and how far it is from the float64 reference.
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import type { Matrix4 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { litStages } from '../helpers/lit.ts';
import { drawPicture } from './peer.ts';
import type { Peer, Shown } from './peer.ts';
import type { PeerCamera } from './peer-scene.ts';

/** A renderer's picture with very many steps. */
export interface Limit {
  readonly steps: number;
  /** The picture of the size at which the errors of peers are measured. */
  readonly picture: Uint8Array;
  /** RMSE, 1/255. */
  readonly fromReference: number;
}

/**
 * Steps of a renderer's own limit: of these the largest number whose picture is about as near to the reference as any, as
 * some lose digits in very many steps. Pictures with up to half of them are compared with it.
 */
const limitSteps: readonly number[] = [1024, 2048, 4096, 8192];

/** Distances from the reference that differ by less are the same: RMSE, 1/255. */
const asNear = 0.25;

/** Rays along each side of the picture on which a limit is held against the reference. */
const referenceSide = 12;

export function findLimit(
  peer: Peer,
  { shown, reference, maxSteps }: { shown: Shown; reference: readonly number[]; maxSteps: number },
  errorSize: number,
): Limit {
  peer.setSize(errorSize);
  const pictures = (peer.isFixed ? [1] : limitSteps.filter((n) => n <= maxSteps)).map((steps): Limit => {
    const picture = drawPicture(peer, stepLengthOf(shown.volume.grid, steps), errorSize);
    const seen = referencePixels(errorSize).flatMap((at) => [...picture.subarray(at * 4, at * 4 + 4)]);
    return { steps, picture, fromReference: rms(seen, reference) };
  });
  const min = Math.min(...pictures.map(({ fromReference }) => fromReference));
  const near = pictures.filter(({ fromReference }) => fromReference <= min + asNear);
  return near[near.length - 1];
}

/** Root mean square difference of the colours, 1/255. */
function rms(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) if (i % 4 < 3) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / ((a.length * 3) / 4));
}

/** The rays of a perspective picture, or of the parallel one that a peer draws from the same side. */
export function viewRays(volume: Volume, camera: PeerCamera, parallel: Peer['parallel']): RaySetup {
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

/** Steps per voxel of the reference: with one, small things are off by more than a renderer may be. */
const referenceSteps = 4;

/** These pixels in float64, RGBA, 0..255: no tables, no early ray termination, four steps per voxel, with substeps. */
export function castReference({ volume, transferFunction, isLit }: Shown, rays: RaySetup, errorSize: number): number[] {
  const { samples, slope, intercept } = volume;
  const looks = { transferFunction, referenceLength: defaultReferenceLength(volume), opacityFactor: 1, lightFactor: 1 };
  const scene = {
    grid: volume.grid,
    samples,
    slope,
    intercept,
    ...looks,
    stepLength: stepLengthOf(volume.grid, referenceSteps * autoSteps(volume.grid)),
    ...(isLit && litStages(volume, transferFunction)),
  };
  const optics = opticsOf(scene);
  const toDevice = (n: number): number => ((n + 0.5) / errorSize) * 2 - 1;
  return referencePixels(errorSize).flatMap((at) => {
    const ray = rayThrough(rays, toDevice(at % errorSize), toDevice(Math.floor(at / errorSize)));
    return castSceneRay(scene, rays, ray, optics).map((channel) => channel * 255);
  });
}
