// Compares what the GPU draws with rays that the CPU casts: loaded with the first check.
import { loadPart } from '../../core/load-part.ts';
import { castRay } from '../../optics/rays/cast-ray.ts';
import { minSubsteps } from '../../optics/cells/min-substeps.ts';
import type { RayStages, Sample } from '../../optics/rays/ray-stages.ts';
import { rayThrough } from '../../optics/rays/rays.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { isCut } from '../../optics/cells/substeps.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import { chooseChecks, compareRay, placeChecks, sumUpChecks } from '../../quality/compare-rays.ts';
import type { PictureCheck, RayDifference } from '../../quality/compare-rays.ts';
import { stepLengthOf } from '../../quality/steps.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { inPieces } from '../../core/in-pieces.ts';
import type { Scene } from '../model/scene.ts';
import { raysOfView } from './view-rays.ts';
import type { Viewer } from '../view/viewer.ts';

/**
 * Compare some rays of the picture at rest with the same rays in float64: rays through the volume alone, which end at no shape.
 * The page can work meanwhile.
 * @returns null where the device can't do it, the picture shows nothing, or the picture has changed meanwhile
 * @throws {VolumeViewError} `format/unsupported` where a part of the package could not be loaded
 */
export async function checkPicture(viewer: Viewer): Promise<PictureCheck | null> {
  const { controller, loop, shown, frames } = viewer;
  const { seenPixels } = await loadPart(import('../frames/view-quality.ts'), 'measures errors');
  return controller.withScene(async (scene) => {
    // A view that was far away gets a new scene for this: it has drawn nothing yet.
    if (controller.isNew) await loop.drawNow(() => frames.drawNow(scene));
    const { steps, substeps } = frames.planAtRest;
    const rays = await raysOfView(viewer, { placesOnly: false, looks: isCut(substeps) });
    const goesOn = (): boolean => !loop.dirty && !loop.host.moving && controller.scene === scene;
    if (!rays || !goesOn()) return null;
    const size = frames.sizeIn(scene);
    const stepLength = stepLengthOf(shown.grid, steps);
    const rectangle = seenPixels(scene, size);
    if (!rectangle) return null;
    const lattice = placeChecks(rectangle, Math.random);
    // Read at once: others draw into the same buffer.
    const drawn = scene.startProbe({ stepLength, substeps }, lattice, size, true)?.();
    if (!drawn) return null;
    const stages = rays.stages({
      stepLength,
      maxSubsteps: substepsOf(scene, substeps),
      minSubsteps: minOf(scene, substeps),
    });
    const compare = (ray: number): RayDifference => {
      const pixel = [
        lattice.first[0] + lattice.stride * (ray % lattice.width),
        lattice.first[1] + lattice.stride * Math.floor(ray / lattice.width),
      ];
      const through = (shift: readonly [number, number]): number[] =>
        pixel.map((one, axis) => (2 * (one + 0.5 + shift[axis])) / (axis ? size.height : size.width) - 1);
      return compareRay(drawn.subarray(4 * ray, 4 * ray + 4), ({ shift, digits }) =>
        castRay(
          withDigits(stages, rays.volume, digits),
          rayThrough(rays.setup, ...(through(shift) as [number, number])),
        ),
      );
    };
    const differences = await inPieces(compareAll(chooseChecks(drawn, Math.random), compare), goesOn);
    return differences && sumUpChecks(differences);
  });
}

/** The relative error that float32 may give a value on its way through a shader. */
const digit = 2 ** -20;

/**
 * The same rays among values with changed last digits; the change varies from place to place.
 * @param digits - 0 for the unchanged values
 */
function withDigits(stages: RayStages, { range }: Volume, digits: number): RayStages {
  if (digits === 0) return stages;
  const max = digit * Math.max(...range.map(Math.abs));
  const { field } = stages;
  const sampleAt = (place: Vector3): Sample => {
    const known = field.sampleAt(place);
    return {
      ...known,
      value: known.value + max * Math.sin(digits * (1e4 * place[0] + 2e4 * place[1] + 3e4 * place[2])),
    };
  };
  return { ...stages, field: { ...field, sampleAt } };
}

/** The maximum number of substeps in a step. A projection is exact however its steps are cut. */
function substepsOf({ cutsSteps }: Scene, substeps: Substeps): number {
  return !cutsSteps && isCut(substeps) ? maxSubsteps : substeps.max;
}

/** The minimum substeps that cells require; cells require none where an author gives steps, and in projections. */
function minOf(scene: Scene, substeps: Substeps): RayStages['minSubsteps'] {
  const codes = scene.cutsSteps ? scene.detail(substeps) : null;
  const seen = scene.whatIsSeen();
  return codes && seen ? minSubsteps(seen.volume, codes, substeps.voxelsPerStep) : undefined;
}

function* compareAll(
  chosen: readonly number[],
  compare: (ray: number) => RayDifference,
): Generator<void, RayDifference[]> {
  const differences: RayDifference[] = [];
  for (const ray of chosen) {
    differences.push(compare(ray));
    yield;
  }
  return differences;
}
