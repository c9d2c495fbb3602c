import { CameraRig } from '../../src/viewer/camera/camera-rig.ts';
import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { rayThrough, intersectUnitCube, setUpRays } from '../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../src/optics/rays/rays.ts';
import { boundingSphere, edgeLengths } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** The rays of a square picture in the default view of `<volume-view>`. */
export function defaultRays(volume: Volume): RaySetup {
  const rig = new CameraRig();
  rig.setSubject(boundingSphere(volume.grid));
  rig.setAspect(1);
  const { camera } = rig;
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, 1, 1, 2));
  if (!rays) throw new Error('the volume is flat');
  return rays;
}

/** World length over which a stop's opacity holds when nobody says otherwise. */
export function defaultReferenceLength(volume: Volume): number {
  return Math.max(...edgeLengths(volume.grid)) / 100;
}

/** Share of a picture's pixels whose rays meet the volume's box. */
export function coveredShare(rays: RaySetup, size: number): number {
  let met = 0;
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const { point, direction } = rayThrough(rays, ((column + 0.5) / size) * 2 - 1, ((row + 0.5) / size) * 2 - 1);
      const [entry, exit] = intersectUnitCube(point, direction);
      if (exit > entry) met++;
    }
  }
  return met / size ** 2;
}
