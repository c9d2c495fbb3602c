// How far full rays on the GPU are from the reference in float64.
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import type { FullRays } from './full-rays.ts';

/** Covered pixels that are looked at. */
const looks = 48;

/**
 * Some covered pixels of a picture, cast in float64 with the same steps: no tables, no end before the end of a ray.
 * @param full - of `castFullRays` @returns the worst channel of each, 1/255
 */
export function compareWithExact(
  { volume, camera, optics, size, stepsPerVoxel }: FullRays,
  full: Float32Array,
): number[] {
  const { samples, slope, intercept, grid } = volume;
  const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, 1, 1, 2))!;
  const { transferFunction, referenceLength } = optics;
  const stepLength = finestSpacing(grid) / stepsPerVoxel;
  const scene = {
    grid,
    samples,
    slope,
    intercept,
    transferFunction,
    referenceLength,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength,
  };
  const known = opticsOf(scene);
  const covered = Array.from({ length: size * size }, (_, pixel) => pixel).filter(
    (pixel) => full[4 * pixel + 3] > 0.5 / 255,
  );
  const random = randomNumbers(size);
  return Array.from({ length: Math.min(looks, covered.length) }, () => {
    const pixel = covered[Math.floor(random() * covered.length)];
    const toDevice = (n: number): number => ((n + 0.5) / size) * 2 - 1;
    const exact = castSceneRay(
      scene,
      rays,
      rayThrough(rays, toDevice(pixel % size), toDevice(Math.floor(pixel / size))),
      known,
    );
    return Math.max(...exact.map((x, c) => 255 * Math.abs(x - full[4 * pixel + c])));
  });
}
