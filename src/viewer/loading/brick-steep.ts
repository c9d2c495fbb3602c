// How the values of a volume in bricks look where that depends on how they change from place to place.
import { sumEmission } from '../../bricks/span-sums.ts';
import type { SpanSums, StepScale } from '../../bricks/span-sums.ts';
import type { SteepLooks } from '../../bricks/steep-looks.ts';
import { loadPart } from '../../core/load-part.ts';
import type * as shadingTwins from '../../optics/shading-twins.ts';
import { flatChange, normalsToWorld } from '../../optics/rays/gradient.ts';
import type { Gradient } from '../../optics/rays/gradient.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import { gaussianReach } from '../../optics/transfer/patches.ts';
import type { Patch } from '../../optics/transfer/patches.ts';
import { finestSpacing } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { length, transformDirection } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { VolumeOptics } from '../model/volume-info.ts';
import { lookUpStyles } from './brick-styles.ts';

/** The float64 code of styles and patches. */
export type SteepCode = typeof shadingTwins;

/** Whether colours or opacities depend on how values change, apart from light. */
export function isSteep({ projection, surfaces, styles, patches }: VolumeOptics): boolean {
  return !projection && !surfaces?.surfaces.length && (styles !== undefined || patches !== undefined);
}

export function loadSteepCode(): Promise<SteepCode> {
  return loadPart(import('../../optics/shading-twins.ts'), 'says what rendering styles show');
}

/**
 * @param range - of the stored values
 * @param finest - the voxels of the finest level
 * @param scale - of the stored values, and of the steps
 */
export function steepOf(
  { stylesAt, lightPatches, meanOverWay, withLight }: SteepCode,
  { transferFunction, lightFactor, referenceLength, shading, styles, patches }: VolumeOptics,
  {
    volume,
    finest,
    stored,
  }: { readonly volume: Pick<Volume, 'range'>; readonly finest: GridFrame; readonly stored: readonly [number, number] },
  scale: StepScale,
): SteepLooks {
  const toWorld = normalsToWorld(finest);
  const gradientOf = (change: Vector3): Gradient => {
    const perVoxel: Vector3 = [change[0] * scale.slope, change[1] * scale.slope, change[2] * scale.slope];
    return { perVoxel, world: transformDirection(toWorld, perVoxel) };
  };
  const sumsAt = patches && sumPatches(lightPatches(patches, lightFactor), meanOverWay, stored, scale);
  const perUnit = 1 / finestSpacing(finest);
  const flat = flatChange(domainOf(brighten(transferFunction, lightFactor)), volume.range);
  const chains = styles && (shading === 'unlit' ? styles : withLight(styles));
  const styleOf =
    chains &&
    lookUpStyles({ grid: finest, flat }, (gradient) =>
      stylesAt({ grid: finest, gradient, flat, chains, referenceLength }),
    );
  return {
    voxel: finest.dimensions.map((n) => 1 / n) as unknown as Vector3,
    ratio: scale.stepRatio,
    sumsOf: sumsAt && ((change) => sumsAt(perUnit * length(gradientOf(change).world))),
    styleOf: styleOf && ((ray, place, change) => styleOf(ray, place, gradientOf(change))),
  };
}

/** A Gaussian is divided into so many gradients. */
const partsOfGaussian = 12;

/** Sums over values by gradient, data units per world unit: between two edges of a box patches are the same. */
function sumPatches(
  patches: readonly Patch[],
  meanOverWay: SteepCode['meanOverWay'],
  stored: readonly [number, number],
  scale: StepScale,
): (gradient: number) => SpanSums {
  const edges = [...new Set([0, ...patches.flatMap(edgesOf)])].filter((edge) => edge >= 0);
  edges.sort((a, b) => a - b);
  const known: SpanSums[] = [];
  return (gradient) => {
    const next = edges.findIndex((edge) => edge > gradient);
    const at = next < 0 ? edges.length - 1 : next - 1;
    // Beyond the last edge there is nothing but that edge.
    const [from, to] = [edges[at], edges[at + 1] ?? edges[at] * (1 + 1e-9)];
    return (known[at] ??= sumEmission((value) => meanOverWay(patches, [value, from], [value, to]), stored, scale));
  };
}

function edgesOf(patch: Patch): readonly number[] {
  if (patch.kind === 'box') return patch.gradients;
  const reach = gaussianReach * patch.widths[1];
  return Array.from(
    { length: partsOfGaussian + 1 },
    (_, n) => patch.gradient + reach * ((2 * n) / partsOfGaussian - 1),
  );
}
