// In the browser: how many pixels of a picture at rest need a ray, and what is lost where the others are interpolated.
import { countSamples } from './count-samples.ts';
import type { SamplesResult } from './count-samples.ts';
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { spareRays } from '../../src/quality/spare-rays.ts';
import { sparingTools } from '../helpers/sparing-tools.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import { buildDefaultPreset } from '../../src/optics/transfer/default-preset.ts';
import { readTransferFunction } from '../../src/optics/transfer/presets.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import { boundingSphere, edgeLengths, finestSpacing, longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { measureThing, measureTrueError } from './compare-shown.ts';
import type { KeptThing } from './compare-shown.ts';
import { countScenes } from './count-scenes.ts';
import type { CountScene } from './count-scenes.ts';
import { findPixel } from './full-rays.ts';

/** Pixels along each side. */
const size = 256;

/** The eye is so far away that voxels have almost the same size in all of the picture. */
const fieldOfView = 0.12;

/** Pixels are interpolated where the picture curves by at most this many times `max-error`. */
const curvaturePerError = 2;

/** Things count that stand out by this many times `max-error`. */
const lostPerError = 8;

export interface CountResult {
  readonly name: string;
  readonly pixelsPerVoxel: number;
  readonly maxError: number;
  /** Rays per pixel; above 1 where the coarser passes cost more than they spare. */
  readonly share: number;
  readonly e: number;
  readonly max: number;
  readonly things: readonly KeptThing[];
}

export function listCounted(): string[] {
  return countScenes.map(({ name }) => name);
}

/** Where a voxel has so many pixels. The eye stays outside of the volume. */
function cameraOf({ theta, phi }: CountScene, { grid }: Volume, pixelsPerVoxel: number): Camera {
  const half = (size * finestSpacing(grid)) / pixelsPerVoxel / 2;
  const radius = Math.max(half / Math.tan(fieldOfView / 2), longestDiagonal(grid));
  const radians = (degrees: number): number => (degrees * Math.PI) / 180;
  const orbit = { theta: radians(theta), phi: radians(phi), radius };
  return orbitCamera(orbit, boundingSphere(grid).center, 2 * Math.atan(half / radius));
}

/** Of scenes without light: how many samples of a picture of the whole volume are needed. */
export async function countTaken(name: string, errors: readonly number[]): Promise<SamplesResult[]> {
  const scene = countScenes.find((one) => one.name === name)!;
  if (scene.litFactor) return [];
  const { volume } = await scene.make();
  const camera = cameraOf(scene, volume, size / (1.2 * Math.max(...volume.grid.dimensions)));
  const view = { view: viewMatrix(camera), projection: projectionMatrix(camera.fieldOfView, 1, 1, 2) };
  return countSamples({ name, volume, ...(await appearanceOf(scene, volume)), ...view }, errors);
}

async function appearanceOf(
  { transferFunction: text, litFactor }: CountScene,
  volume: Volume,
): Promise<{ transferFunction: TransferFunction; referenceLength: number }> {
  const window = windowFromHistogram(volume.histogram);
  return {
    transferFunction: text === null ? buildDefaultPreset(window) : await readTransferFunction(text, window),
    referenceLength: (0.01 * Math.max(...edgeLengths(volume.grid))) / (litFactor ?? 1),
  };
}

export async function countRays(
  name: string,
  sizes: readonly number[],
  errors: readonly number[],
): Promise<CountResult[]> {
  const scene = countScenes.find((one) => one.name === name)!;
  const { volume, bare, places } = await scene.make();
  const gl = new StudyGl();
  const { litFactor } = scene;
  const appearance = await appearanceOf(scene, volume);
  await gl.prepare({ volume, ...appearance }, litFactor ? { lit: true } : null);
  const results: CountResult[] = [];
  for (const pixelsPerVoxel of sizes) {
    const camera = cameraOf(scene, volume, pixelsPerVoxel);
    const view = { view: viewMatrix(camera), projection: projectionMatrix(camera.fieldOfView, 1, 1, 2) };
    const draw = (shown: Volume): Promise<Float32Array> => {
      const rays = setUpRays(shown.grid, view.view, view.projection)!;
      const steps = Math.ceil((2 * longestDiagonal(shown.grid)) / finestSpacing(shown.grid));
      const picture = { volume: shown, rays, ...appearance, method: 'shipped', steps } as const;
      return gl.draw(picture, size, new AbortController().signal);
    };
    const full = await draw(volume);
    const without = bare && (await draw(bare));
    const truth = { data: Uint8Array.from(full, (x) => Math.round(255 * x)), width: size, height: size };
    for (const maxError of errors) {
      const { data, rays } = spareRays(truth, curvaturePerError * maxError, sparingTools);
      const share = rays / size ** 2;
      const { e, max } = measureTrueError(data, full);
      const reach = Math.max(1, scene.reach * pixelsPerVoxel);
      const things = without
        ? places.flatMap((place) => {
            const around = findPixel(camera, place, size);
            const thing = measureThing({ shown: data, full, bare: without, size }, around, reach);
            return thing && thing.contrast >= lostPerError * maxError ? [thing] : [];
          })
        : [];
      results.push({ name, pixelsPerVoxel, maxError, share, e, max, things });
    }
  }
  gl.dispose();
  return results;
}
