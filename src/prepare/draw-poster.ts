import { flatChange } from '../optics/rays/gradient.ts';
import { orbitCamera, framingDistance, projectionMatrix, viewMatrix } from '../optics/rays/camera.ts';
import type { Camera } from '../optics/rays/camera.ts';
import { castRay } from '../optics/rays/cast-ray.ts';
import { framePlaces } from '../optics/rays/frame-places.ts';
import { litShade, pointField } from '../optics/rays/lit.ts';
import { rayThrough, setUpRays } from '../optics/rays/rays.ts';
import type { RaySetup } from '../optics/rays/rays.ts';
import type { IntervalStage, RayStages } from '../optics/rays/ray-stages.ts';
import { composite } from '../optics/rays/segment.ts';
import { stagesOf } from '../optics/reference.ts';
import { cartesianSlopes } from '../optics/shading-twins.ts';
import { domainOf } from '../optics/transfer/emission.ts';
import { findSeenPlaces } from '../optics/transfer/seen-places.ts';
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { autoSteps, stepLengthOf } from '../quality/steps.ts';
import { polarField } from '../radar/twins.ts';
import { resolveAppearance } from '../viewer/appearance/resolve-appearance.ts';
import { withDefaultLook } from '../viewer/appearance/default-look.ts';
import { cellSize } from '../volume/cell-size.ts';
import { boundingSphere } from '../volume/grid.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';

/** Settings of a page that says nothing. */
const nothingSaid: Parameters<typeof resolveAppearance>[0] = {
  named: null,
  transferFunction: null,
  window: null,
  referenceLength: null,
  opacityFactor: null,
  lightFactor: 1,
  projection: null,
  shading: null,
  surfaces: null,
  gradientOpacity: null,
  transferFunction2d: null,
};

/** The camera of a view whose page says nothing, see src/viewer/camera/camera-rig.ts. */
const usualView = { theta: Math.PI / 6, phi: (75 * Math.PI) / 180, fieldOfView: Math.PI / 6, aspect: 1 };
const weatherView = { ...usualView, theta: Math.PI + Math.PI / 9, phi: (62 * Math.PI) / 180 };

/** Share of the bounding sphere in a picture of a volume of which nothing is seen. */
const framedShare = 0.68;

/** Steps that are cast at once: their places are less than a macrocell from the middle one. */
const stepsAtOnce = cellSize / 2;

/** A ray whose opacity is above this shows nothing that comes behind. */
const opaque = 0.9995;

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
 */
export async function drawPoster(volume: Volume, size: number): Promise<Poster> {
  const optics = await resolveAppearance(withDefaultLook(nothingSaid, volume), volume);
  const { grid, range } = volume;
  const camera = frameVolume(volume, optics.transferFunction);
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

function frameVolume(volume: Volume, transferFunction: TransferFunction): Camera {
  const view = isPolar(volume) ? weatherView : usualView;
  const places = findSeenPlaces(volume, transferFunction, volume.grid);
  const sphere = boundingSphere(volume.grid);
  const { target, radius } =
    places.length > 0
      ? framePlaces(places, view)
      : { target: sphere.center, radius: framingDistance(sphere.radius * framedShare, view.fieldOfView, 1) };
  return orbitCamera({ ...view, radius }, target, view.fieldOfView);
}

/** Whether something may be seen at a place of the unit cube, or less than half a macrocell from it. */
type SeenCells = (x: number, y: number, z: number) => boolean;

function findSeenCells({ macrocells, grid, slope, intercept }: Volume, transferFunction: TransferFunction): SeenCells {
  const { dimensions, low, high } = macrocells;
  const [cx, cy, cz] = dimensions;
  const shows = (a: number, b: number): boolean =>
    evaluate(transferFunction, a)[3] > 0 ||
    evaluate(transferFunction, b)[3] > 0 ||
    transferFunction.some(({ value, opacity }) => opacity > 0 && value >= a && value <= b);
  const near = new Uint8Array(cx * cy * cz);
  for (let k = 0; k < cz; k++)
    for (let j = 0; j < cy; j++)
      for (let i = 0; i < cx; i++) {
        const at = i + cx * (j + cy * k);
        if (!(low[at] <= high[at])) continue;
        const ends = [slope * low[at] + intercept, slope * high[at] + intercept];
        if (!shows(Math.min(...ends), Math.max(...ends))) continue;
        for (let z = Math.max(0, k - 1); z <= Math.min(cz - 1, k + 1); z++)
          for (let y = Math.max(0, j - 1); y <= Math.min(cy - 1, j + 1); y++)
            near.fill(1, Math.max(0, i - 1) + cx * (y + cy * z), Math.min(cx - 1, i + 1) + 1 + cx * (y + cy * z));
      }
  const [nx, ny, nz] = grid.dimensions.map((n) => n / cellSize);
  const cellOf = (share: number, n: number, cells: number): number =>
    Math.min(cells - 1, Math.max(0, Math.floor(share * n)));
  return (x, y, z) => near[cellOf(x, nx, cx) + cx * (cellOf(y, ny, cy) + cy * cellOf(z, nz, cz))] === 1;
}

/** Casts a ray by pieces of whole steps, of which those are left out that show nothing. */
function castSeen(stages: RayStages, rays: RaySetup, isSeen: SeenCells): (x: number, y: number) => Premultiplied {
  const piece = { entry: 0, exit: 0 };
  const one: IntervalStage = () => ({ ...piece, behind: null });
  const cut: RayStages = { ...stages, intervals: [one] };
  return (x, y) => {
    const ray = rayThrough(rays, x, y);
    const { entry, exit } = stages.intervals.reduce((interval, stage) => stage(ray, interval), {
      entry: stages.eyeT,
      exit: Infinity,
      behind: null,
    } as ReturnType<IntervalStage>);
    const color: Premultiplied = [0, 0, 0, 0];
    const length = (stepsAtOnce * stages.step) / ray.lengthPerT;
    for (let from = entry; from < exit && color[3] < opaque; from += length) {
      // A rest that is shorter than a step belongs to the piece before it.
      const isLast = from + length * (1 + 1e-3 / stepsAtOnce) >= exit;
      const to = isLast ? exit : from + length;
      const middle = (from + to) / 2;
      const [px, py, pz] = ray.point.map((p, axis) => p + middle * ray.direction[axis]);
      if (isSeen(px, py, pz)) {
        Object.assign(piece, { entry: from, exit: to });
        composite(color, castRay(cut, ray));
      }
      if (isLast) break;
    }
    return color;
  };
}
