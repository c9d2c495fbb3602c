// Orders of convergence of the picture, measured on analytic fields.
// Method: Etiene, Jönsson, Ropinski, Scheidegger, Comba, Nonato, Kirby, Ynnerman, Silva: Verifying Volume Rendering
// Using Discretization Error Analysis, 2013. They refine one of step length, grid spacing and pixel size at a time and
// compare the slope of the error in a log-log plot with theory.
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { emission } from '../../src/optics/transfer/emission.ts';
import { interpolate } from '../../src/optics/rays/interpolate.ts';
import { intersectUnitCube, rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import { attenuate, composite, maxSubsteps } from '../../src/optics/rays/segment.ts';
import type { Premultiplied, TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { add, scale } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { remember } from '../helpers/remember.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

/**
 * The theory is about steps without substeps. With substeps, as shipped, the error is much smaller; finer steps get fewer
 * substeps, because less can happen between two samples, so the order is a little lower.
 */
export type Study = 'step length' | 'step length, with substeps' | 'grid spacing' | 'pixel size';

/** One refinement: the errors, and the slope of their logarithms. */
export interface OrderRow {
  readonly study: Study;
  /** Who drew the pictures. */
  readonly by: string;
  readonly transferFunction: 'smooth' | 'jumps';
  /** Steps along the diagonal, voxels along an edge, or pixels across. */
  readonly counts: readonly number[];
  /** Root mean square over all rays and channels; 1 is the full range. */
  readonly errors: readonly number[];
  /** Error ~ count^-order, least squares. */
  readonly order: number;
}

/** What is drawn. All lengths are world lengths; the volume is a cube with edges of 1. */
export interface StudyPicture {
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly referenceLength: number;
  readonly camera: Camera;
  readonly stepLength: number;
  /** Maximum number of substeps. */
  readonly maxSubsteps: number;
  readonly width: number;
  readonly height: number;
}

/** @returns width * height * 4 numbers, premultiplied, 0..1, top row first */
export type DrawPicture = (picture: StudyPicture) => ArrayLike<number>;

/** Smooth, symmetric in nothing, and flat across each face: interpolation holds it constant in the outer half voxels. */
function field(x: number, y: number, z: number): number {
  const [a, b, c] = [x, y, z].map((u) => Math.cos(Math.PI * u));
  return 0.5 + 0.2 * a * b + 0.15 * (2 * b * b - 1) * c - 0.1 * a * (2 * c * c - 1) + 0.04 * c;
}

/** A hump, in so many straight lines that no kink of theirs shows: kinks make silhouettes, and these a lower order. */
const hump: TransferFunction = Array.from({ length: 129 }, (_, i) => {
  const value = i / 128;
  const t = value * value * (3 - 2 * value);
  return {
    value,
    color: [t, 0.3 + 0.4 * t, 1 - 0.8 * t],
    opacity: 0.003 + 0.08 * Math.exp(-(((value - 0.6) / 0.22) ** 2)),
  };
});

const transferFunctions: Record<OrderRow['transferFunction'], TransferFunction> = {
  smooth: hump,
  jumps: [
    { value: 0.1, color: [0.2, 0.4, 0.8], opacity: 0.005 },
    { value: 0.45, color: [0.2, 0.4, 0.8], opacity: 0.005 },
    { value: 0.45, color: [1, 0.3, 0.2], opacity: 0.03 },
    { value: 0.6, color: [1, 0.3, 0.2], opacity: 0.03 },
    { value: 0.6, color: [1, 1, 0.6], opacity: 0.1 },
  ],
};

const referenceLength = 0.03;
const diagonal = Math.sqrt(3);

/** Each ray comes in through one face and leaves through another: a picture without the edges of the cube. */
const camera = orbitCamera({ theta: 0.15, phi: 1.45, radius: 2 }, [0, 0, 0], 0.25);
const aspect = 4 / 3;

/** So many across and down are cast where pixels are not what is refined. */
const [width, height] = [16, 12];

/** Of the errors in what is not refined, next to nothing must be left: where values jump, points leave an error of first order, elsewhere of second. */
const fine = { steps: 1024, voxels: 24, samples: { smooth: 4096, jumps: 16384 } };

const refined: Record<Study, readonly number[]> = {
  'step length': [16, 24, 36, 54, 81, 122],
  // None a multiple of another or of the voxels, lest steps and voxels fall in step.
  'step length, with substeps': [5, 7, 11, 17, 26, 41],
  'grid spacing': [6, 9, 14, 21, 32],
  'pixel size': [16, 24, 36, 56, 84],
};

/** The orders of all studies, with smooth transfer functions and with jumps. */
export function measureOrders(draw: DrawPicture = drawReference, by = 'reference'): OrderRow[] {
  const studies: Record<
    Study,
    (draw: DrawPicture, transferFunction: TransferFunction, counts: readonly number[]) => number[]
  > = {
    'step length': (...study) => measureSteps(...study, 1),
    'step length, with substeps': measureSteps,
    'grid spacing': measureGrid,
    'pixel size': measurePixels,
  };
  return (Object.keys(studies) as Study[]).flatMap((study) =>
    (['smooth', 'jumps'] as const).map((name) => {
      const counts = refined[study];
      const errors = studies[study](draw, transferFunctions[name], counts);
      return { study, by, transferFunction: name, counts, errors, order: fitOrder(counts, errors) };
    }),
  );
}

/** The minimum order of a study: that of theory, less a little. */
export function minOrder({ study, transferFunction }: Pick<OrderRow, 'study' | 'transferFunction'>): number {
  if (transferFunction === 'jumps') return 0.9;
  return study === 'step length, with substeps' ? 1.75 : 1.9;
}

/** A row in words: the errors in 1/255, and the order between each and the next. */
export function describeOrder({ study, by, transferFunction, counts, errors, order }: OrderRow): string {
  const cells = counts.map((count, i) => {
    const local = i > 0 ? ` (${fitOrder(counts.slice(i - 1, i + 1), errors.slice(i - 1, i + 1)).toFixed(2)})` : '';
    return `${count}: ${(errors[i] * 255).toPrecision(3)}${local}`;
  });
  return `${study}, ${transferFunction}, ${by}: order ${order.toFixed(2)}; ${cells.join(', ')}`;
}

/** Slope of log(error) over log(count), least squares, turned positive. */
export function fitOrder(counts: readonly number[], errors: readonly number[]): number {
  const [x, y] = [counts.map(Math.log), errors.map(Math.log)];
  const mean = (v: number[]): number => v.reduce((a, b) => a + b, 0) / v.length;
  const [mx, my] = [mean(x), mean(y)];
  const covariance = x.reduce((sum, xi, i) => sum + (xi - mx) * (y[i] - my), 0);
  return -covariance / x.reduce((sum, xi) => sum + (xi - mx) ** 2, 0);
}

function pictureOf(transferFunction: TransferFunction, options: Partial<StudyPicture> = {}): StudyPicture {
  const volume = options.volume ?? volumeOf(fine.voxels);
  return {
    volume,
    transferFunction,
    referenceLength,
    camera,
    stepLength: diagonal / fine.steps,
    maxSubsteps,
    width,
    height,
    ...options,
  };
}

const volumeOf = remember((voxels: number): Volume =>
  syntheticVolume({
    dimensions: [voxels, voxels, voxels],
    spacing: [1 / voxels, 1 / voxels, 1 / voxels],
    kind: 'float32',
    field,
  }),
);

/** Against the integral over the interpolated voxels. */
function measureSteps(
  draw: DrawPicture,
  transferFunction: TransferFunction,
  counts: readonly number[],
  max = maxSubsteps,
): number[] {
  const picture = pictureOf(transferFunction, { maxSubsteps: max });
  return counts.map((steps) =>
    rmsOf(draw({ ...picture, stepLength: diagonal / steps }), integrateVoxels(transferFunction)),
  );
}

/** Against the integral over the field itself. */
function measureGrid(draw: DrawPicture, transferFunction: TransferFunction, counts: readonly number[]): number[] {
  return counts.map((voxels) =>
    rmsOf(draw(pictureOf(transferFunction, { volume: volumeOf(voxels) })), integrateField(transferFunction)),
  );
}

/** Pictures interpolated between the centres of their pixels, against rays cast right there. */
function measurePixels(draw: DrawPicture, transferFunction: TransferFunction, counts: readonly number[]): number[] {
  return counts.map((across) => {
    const picture = { ...smoothPicture(transferFunction), width: across, height: (across * 3) / 4 };
    const drawn = draw(picture);
    return rmsOf(
      innerPlaces.flatMap(([x, y]) => interpolatePicture(drawn, picture, x, y)),
      castInside(transferFunction),
    );
  });
}

/**
 * In so many voxels that their own kinks do not show: rays along a plane of voxels make a kink of the picture. Its steps
 * need not be fine, as those of what it is held against are the same.
 */
const smoothPicture = (transferFunction: TransferFunction): StudyPicture =>
  pictureOf(transferFunction, { volume: volumeOf(64), stepLength: diagonal / 128 });

/** Device coordinates between those of the outermost pixels of the coarsest picture. */
const innerPlaces = pixelsOf({ width: 61, height: 47 }).map(([x, y]) => [x * 0.8, y * 0.8] as const);

// What is drawn is held against these, whoever drew it.
const castInside = remember((transferFunction: TransferFunction) =>
  castPixels(smoothPicture(transferFunction), innerPlaces),
);
const integrateField = remember((transferFunction: TransferFunction) =>
  integratePicture(pictureOf(transferFunction), (p) => field(...p)),
);
const integrateVoxels = remember((transferFunction: TransferFunction) => {
  const picture = pictureOf(transferFunction);
  const {
    samples,
    grid: { dimensions },
  } = picture.volume;
  return integratePicture(picture, (p) => interpolate(samples, dimensions, p));
});

function rmsOf(got: ArrayLike<number>, expected: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < got.length; i++) sum += (got[i] - expected[i]) ** 2;
  return Math.sqrt(sum / got.length);
}

/** Device coordinates of the centres of pixels, top row first. */
function pixelsOf({ width: across, height: down }: { width: number; height: number }): [number, number][] {
  return Array.from({ length: across * down }, (_, i): [number, number] => [
    (((i % across) + 0.5) / across) * 2 - 1,
    1 - ((Math.floor(i / across) + 0.5) / down) * 2,
  ]);
}

function interpolatePicture(
  drawn: ArrayLike<number>,
  { width: across, height: down }: StudyPicture,
  x: number,
  y: number,
): number[] {
  const column = ((x + 1) / 2) * across - 0.5;
  const row = ((1 - y) / 2) * down - 0.5;
  const [left, top] = [Math.floor(column), Math.floor(row)];
  const [u, v] = [column - left, row - top];
  const at = (i: number, j: number, c: number): number => drawn[((top + j) * across + left + i) * 4 + c];
  return [0, 1, 2, 3].map(
    (c) => (at(0, 0, c) * (1 - u) + at(1, 0, c) * u) * (1 - v) + (at(0, 1, c) * (1 - u) + at(1, 1, c) * u) * v,
  );
}

function raysOf({ volume, camera: from }: StudyPicture): RaySetup {
  return setUpRays(volume.grid, viewMatrix(from), projectionMatrix(from.fieldOfView, aspect, 1, 2))!;
}

const drawReference: DrawPicture = (picture) => castPixels(picture, pixelsOf(picture));

/** The reference at given device coordinates. */
function castPixels(picture: StudyPicture, pixels: readonly (readonly [number, number])[]): number[] {
  const rays = raysOf(picture);
  const scene = { ...picture.volume, ...picture, opacityFactor: 1, lightFactor: 1 };
  const optics = opticsOf(scene);
  return pixels.flatMap(([x, y]) => castSceneRay(scene, rays, rayThrough(rays, x, y), optics));
}

/**
 * The volume rendering integral of each pixel, by very many samples at points: it shares neither the segments nor the
 * means of what it judges.
 */
function integratePicture(picture: StudyPicture, valueAt: (p: Vector3) => number): number[] {
  const rays = raysOf(picture);
  return pixelsOf(picture).flatMap(([x, y]) => integrateRay(picture, rays, rayThrough(rays, x, y), valueAt));
}

function integrateRay(picture: StudyPicture, rays: RaySetup, ray: Ray, valueAt: (p: Vector3) => number): Premultiplied {
  const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
  const samples = fine.samples[picture.transferFunction === hump ? 'smooth' : 'jumps'];
  const ratio = ((exit - entry) * ray.lengthPerT * rays.diameter) / picture.referenceLength / samples;
  const accumulated: Premultiplied = [0, 0, 0, 0];
  for (let i = 0; i < samples; i++) {
    const t = entry + ((i + 0.5) / samples) * (exit - entry);
    const value = valueAt(add(ray.point, scale(ray.direction, t)));
    composite(accumulated, attenuate(emission(picture.transferFunction, value), ratio));
  }
  return accumulated;
}
