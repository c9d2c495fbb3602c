import { finestSpacing } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/volume.ts';
import { brighten } from './transfer/brighten.ts';
import { castRay } from './rays/cast-ray.ts';
import { jumpGather } from './surfaces/jump-gather.ts';
import { findOpaqueJumps } from './transfer/opaque-jumps.ts';
import { prepareOptics, transferFunctionClassify } from './rays/ray-classify.ts';
import type { RayOptics } from './rays/ray-classify.ts';
import { cartesianField } from './rays/ray-field.ts';
import { compositeGather } from './rays/ray-gather.ts';
import { boxInterval } from './rays/ray-intervals.ts';
import type {
  ClassifyStage,
  FieldStage,
  GatherStage,
  IntervalStage,
  RayStages,
  SecondFieldStage,
  ShadeStage,
} from './rays/ray-stages.ts';
import { rayThrough } from './rays/rays.ts';
import type { Ray, RaySetup } from './rays/rays.ts';
import { maxSubsteps } from './transfer/substep-limits.ts';
import type { OpticalFactors, Premultiplied, TransferFunction } from './transfer/transfer-function.ts';

/** Everything that a picture depends on. The stages of its rays are built from this. */
export interface ReferenceScene extends OpticalFactors {
  readonly grid: GridFrame;
  readonly samples: Samples;
  readonly isDiscrete?: boolean;
  readonly slope: number;
  readonly intercept: number;
  readonly transferFunction: TransferFunction;
  /** World length to which a stop's opacity belongs. */
  readonly referenceLength: number;
  /** World length of a step. */
  readonly stepLength: number;
  /** A step is cut into at most this many substeps; if absent, the limit of the shader. */
  readonly maxSubsteps?: number;
  /** See `RayStages`. */
  readonly minSubsteps?: (place: Vector3) => number;
  /** The field that rays sample; if absent, the samples on the grid. */
  readonly field?: FieldStage;
  /** More fields at each place, and how they change what is visible. */
  readonly moreFields?: readonly SecondFieldStage[];
  readonly shades?: readonly ShadeStage[];
  /** What ends rays in addition to the bounds of the volume and of the region. */
  readonly ends?: readonly IntervalStage[];
  /** Replaces the classification by the transfer function. */
  readonly classifyBy?: (usual: ClassifyStage) => ClassifyStage;
  /**
   * How a ray adds up its segments. If absent: emission and absorption, with a search for places where the transfer function becomes
   * opaque at once.
   */
  readonly gather?: GatherStage;
}

/**
 * Renders the picture in plain float64. Every GPU result is compared with it.
 * @returns Float64Array of shape [height, width, 4], top row first, premultiplied, 0..1
 */
export function renderReference(scene: ReferenceScene, rays: RaySetup, width: number, height: number): Float64Array {
  return renderStages(stagesOf(scene, rays), rays, width, height);
}

/** The same for rays whose stages are already known. */
export function renderStages(stages: RayStages, rays: RaySetup, width: number, height: number): Float64Array {
  const picture = new Float64Array(width * height * 4);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const x = ((column + 0.5) / width) * 2 - 1;
      const y = 1 - ((row + 0.5) / height) * 2;
      picture.set(castRay(stages, rayThrough(rays, x, y)), (row * width + column) * 4);
    }
  }
  return picture;
}

/** Casts one ray of a scene. @param optics - prepared from the scene once, to share among many rays */
export function castSceneRay(scene: ReferenceScene, setup: RaySetup, ray: Ray, optics?: RayOptics): Premultiplied {
  return castRay(stagesOf(scene, setup, optics), ray);
}

const asItIs = (usual: ClassifyStage): ClassifyStage => usual;

/** The five stages of a scene's rays. */
export function stagesOf(scene: ReferenceScene, setup: RaySetup, optics: RayOptics = opticsOf(scene)): RayStages {
  const { grid, stepLength, referenceLength, opacityFactor } = scene;
  const field = scene.field ?? cartesianField({ ...scene, dimensions: grid.dimensions });
  // Only cartesian grids know where values kink. Pictures in motion do not cut their steps, so they do not look for jumps.
  const isCut = (scene.maxSubsteps ?? maxSubsteps) > 1 || scene.minSubsteps !== undefined;
  const jumps =
    scene.gather || !field.kinksBetween || !isCut ? [] : findOpaqueJumps(optics.transferFunction, voxelRatioOf(scene));
  return {
    intervals: [boxInterval(setup), ...(scene.ends ?? [])],
    field,
    moreFields: scene.moreFields ?? [],
    classify: (scene.classifyBy ?? asItIs)(
      transferFunctionClassify(optics, field, (setup.diameter * opacityFactor) / referenceLength),
    ),
    shades: scene.shades ?? [],
    gather:
      scene.gather ?? (jumps.length > 0 ? jumpGather(jumps, finestSpacing(grid) / setup.diameter) : compositeGather),
    eyeT: setup.eyeT,
    step: stepLength / setup.diameter,
    maxSubsteps: scene.maxSubsteps ?? maxSubsteps,
    minSubsteps: scene.minSubsteps,
  };
}

/** What a scene's rays need of its transfer function. Keep it to cast many rays. */
export function opticsOf(scene: ReferenceScene): RayOptics {
  return prepareOptics(brighten(scene.transferFunction, scene.lightFactor), voxelRatioOf(scene));
}

function voxelRatioOf({ grid, opacityFactor, referenceLength }: ReferenceScene): number {
  return (finestSpacing(grid) / referenceLength) * opacityFactor;
}
