import { finestSpacing } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Samples } from '../volume/volume.ts';
import { brighten } from './transfer/brighten.ts';
import { labelShade } from './attachments/labels.ts';
import { groupClassify, groupShade } from './label-groups.ts';
import { castRay } from './rays/cast-ray.ts';
import { composeStages } from './rays/compose-stages.ts';
import type { StageGiver, StageName } from './rays/compose-stages.ts';
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
  readonly minSubsteps?: RayStages['minSubsteps'];
  /** The field that rays sample; if absent, the samples on the grid. */
  readonly field?: FieldStage;
  /** More fields at each place, and how they change what is visible. */
  readonly moreFields?: readonly SecondFieldStage[];
  readonly shades?: readonly ShadeStage[];
  /** What ends rays in addition to the bounds of the volume and of the region. */
  readonly ends?: readonly IntervalStage[];
  /** Transfer functions of groups of labels, by group from 1. */
  readonly functions?: readonly TransferFunction[];
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
  const { grid, stepLength, referenceLength, opacityFactor, moreFields = [], shades = [], functions = [] } = scene;
  const classifyBy = (one: RayOptics, field: FieldStage): ClassifyStage =>
    transferFunctionClassify(one, field, (setup.diameter * opacityFactor) / referenceLength);
  return composeStages(
    [
      giver('field', () => ({ field: scene.field ?? cartesianField({ ...scene, dimensions: grid.dimensions }) })),
      { ...giver('field', () => ({ moreFields })), isSecond: true },
      giver('interval', () => ({ intervals: [boxInterval(setup), ...(scene.ends ?? [])] })),
      giver('classify', ({ field }) => {
        const usual = (scene.classifyBy ?? asItIs)(classifyBy(optics, field));
        const others = functions.map((transferFunction) => classifyBy(opticsOf({ ...scene, transferFunction }), field));
        return { classify: others.length > 0 ? groupClassify([usual, ...others]) : usual };
      }),
      giver('shade', ({ classify, field }) => ({
        shades: shades.map((shade) =>
          functions.length > 0 && shade === labelShade ? groupShade(classify, field) : shade,
        ),
      })),
      giver('gather', ({ field }) => ({ gather: scene.gather ?? gatherOf(scene, setup, { field, optics }) })),
    ],
    {
      eyeT: setup.eyeT,
      step: stepLength / setup.diameter,
      maxSubsteps: scene.maxSubsteps ?? maxSubsteps,
      minSubsteps: scene.minSubsteps,
    },
  );
}

const giver = (stage: StageName, parts: StageGiver['parts']): StageGiver => ({ name: 'a reference', stage, parts });

/** Emission and absorption. Where steps are cut, as they are at rest, it finds what is opaque at once. */
function gatherOf(
  scene: ReferenceScene,
  { diameter }: RaySetup,
  { field, optics }: { readonly field: FieldStage; readonly optics: RayOptics },
): GatherStage {
  const isCut = (scene.maxSubsteps ?? maxSubsteps) > 1 || scene.minSubsteps !== undefined;
  // Only cartesian grids know where values kink.
  const jumps = field.kinksBetween && isCut ? findOpaqueJumps(optics.transferFunction, voxelRatioOf(scene)) : [];
  return jumps.length > 0 ? jumpGather(jumps, finestSpacing(scene.grid) / diameter) : compositeGather;
}

/** What a scene's rays need of its transfer function. Keep it to cast many rays. */
export function opticsOf(scene: ReferenceScene): RayOptics {
  return prepareOptics(brighten(scene.transferFunction, scene.lightFactor), voxelRatioOf(scene));
}

function voxelRatioOf({ grid, opacityFactor, referenceLength }: ReferenceScene): number {
  return (finestSpacing(grid) / referenceLength) * opacityFactor;
}
