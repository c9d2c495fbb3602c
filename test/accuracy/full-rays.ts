// In the browser: what an element's picture is held against.
import type { StudyGl } from '../../demos/accuracy/study-gl.ts';
import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import { longestDiagonal, finestSpacing } from '../../src/volume/grid.ts';
import { styleOf } from '../../src/viewer/model/volume-info.ts';
import type { VolumeOptics } from '../../src/viewer/model/volume-info.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A view in full rays. */
export interface FullRays {
  readonly volume: Volume;
  readonly camera: Camera;
  /** Without light, styles and factors. */
  readonly optics: VolumeOptics;
  /** Pixels along each side. */
  readonly size: number;
  readonly stepsPerVoxel: number;
  /** The most of a step; eight where absent. */
  readonly substeps?: number;
}

/**
 * A ray for every pixel, with so many steps a voxel, in floats.
 * @returns RGBA, premultiplied, 0..1, bottom row first
 */
export function castFullRays(
  gl: StudyGl,
  { volume, camera, optics, size, stepsPerVoxel, substeps }: FullRays,
): Promise<Float32Array> {
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, 1, 1, 2));
  if (!rays) throw new Error('the volume is flat');
  const steps = Math.ceil((stepsPerVoxel * longestDiagonal(volume.grid)) / finestSpacing(volume.grid));
  const { transferFunction, referenceLength, opacityFactor, lightFactor } = optics;
  if (styleOf(optics) || opacityFactor !== 1 || lightFactor !== 1)
    throw new Error(
      'full rays have no light, no style and no factors: the picture that they are compared with needs shading="unlit", for instance',
    );
  return gl.draw(
    { volume, rays, transferFunction, referenceLength, method: 'shipped', steps, maxSubsteps: substeps },
    size,
    new AbortController().signal,
  );
}

/** Where a place in the world is in such a picture: pixels from the left and from the bottom. */
export function findPixel(
  camera: Camera,
  [x, y, z]: readonly [number, number, number],
  size: number,
): readonly [number, number] {
  const m = viewMatrix(camera);
  const [right, up, back] = [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3]);
  const scale = 1 / Math.tan(camera.fieldOfView / 2) / -back;
  return [((right * scale + 1) / 2) * size, ((up * scale + 1) / 2) * size];
}
