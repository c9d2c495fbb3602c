import { flatChange } from '../optics/rays/gradient.ts';
import { projectionMatrix, viewMatrix } from '../optics/rays/camera.ts';
import type { Camera } from '../optics/rays/camera.ts';
import { litShade, pointField } from '../optics/rays/lit.ts';
import { setUpRays } from '../optics/rays/rays.ts';
import { stagesOf } from '../optics/reference.ts';
import { cartesianSlopes } from '../optics/shading-twins.ts';
import { domainOf } from '../optics/transfer/emission.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import { autoSteps, stepLengthOf } from '../quality/steps.ts';
import { polarField } from '../radar/twins.ts';
import { resolveAppearance } from '../viewer/appearance/resolve-appearance.ts';
import { withDefaultLook } from '../viewer/appearance/default-look.ts';
import { CameraRig } from '../viewer/camera/camera-rig.ts';
import { createFraming } from '../viewer/camera/framing.ts';
import { plainAppearance } from '../viewer/model/plain-appearance.ts';
import { boundingSphere } from '../volume/grid.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { castSeen, findSeenCells } from './cast-seen.ts';

/** A square picture. */
export interface Poster {
  readonly size: number;
  /** Red, green, blue and opacity, 0..1, multiplied by the opacity; row by row from the top. */
  readonly pixels: Float64Array;
}

/**
 * Draws a volume as a view shows it whose page says nothing: the same camera, colours and light, in float64, without a browser. What
 * is not visible is skipped, by macrocells, and rays end where they are opaque; both change nothing that can be seen.
 * @param size - pixels across and down
 * @param framed - the volume that the camera shows in full: another one on the same grid, where two pictures are compared
 * @param said - what a page says of the look; only what the float64 reference draws without more parts: no projection, no surfaces
 */
export async function drawPoster(
  volume: Volume,
  size: number,
  framed = volume,
  said = plainAppearance,
): Promise<Poster> {
  const optics = await resolveAppearance(withDefaultLook(said, volume), volume);
  const { grid, range } = volume;
  const camera = frameVolume(framed, optics.transferFunction);
  const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, 1, 1, 2));
  const pixels = new Float64Array(4 * size * size);
  if (!rays) return { size, pixels };
  const isLit = optics.shading === 'lit' && !isPolar(volume);
  const { gradient } = isLit ? cartesianSlopes(volume) : { gradient: null };
  const stages = stagesOf(
    {
      ...volume,
      transferFunction: optics.transferFunction,
      referenceLength: optics.referenceLength,
      opacityFactor: optics.opacityFactor,
      lightFactor: optics.lightFactor,
      stepLength: stepLengthOf(grid, autoSteps(grid)),
      ...(isPolar(volume) && { field: polarField(volume) }),
      ...(gradient && {
        moreFields: [pointField],
        shades: [litShade({ grid, gradient, flat: flatChange(domainOf(optics.transferFunction), range) })],
      }),
    },
    rays,
  );
  const cast = castSeen(stages, rays, findSeenCells(volume, optics.transferFunction));
  for (let row = 0; row < size; row++)
    for (let column = 0; column < size; column++)
      pixels.set(cast((2 * column + 1) / size - 1, 1 - (2 * row + 1) / size), 4 * (row * size + column));
  return { size, pixels };
}

/** The camera of a square view, as a page has it before anybody moves it. */
function frameVolume(volume: Volume, transferFunction: TransferFunction): Camera {
  const rig = new CameraRig();
  rig.setSubject({
    ...boundingSphere(volume.grid),
    isWeather: isPolar(volume),
    findFraming: () => createFraming(volume, transferFunction, volume.grid),
  });
  return rig.camera;
}
