import { finestSpacing } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { length } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { GradientStage } from './gradient.ts';
import { meanOverWay } from '../transfer/patches.ts';
import type { Patch, ValueAndGradient } from '../transfer/patches.ts';
import type { ClassifyStage, FieldStage, Sample } from './ray-stages.ts';
import { attenuate } from './segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/** A volume that is classified by value and gradient. */
export interface PatchScene {
  /** See `lightPatches`. */
  readonly patches: readonly Patch[];
  readonly grid: GridFrame & { readonly kind?: string };
  readonly gradient: GradientStage;
  readonly field: Pick<FieldStage, 'isFolded'>;
  /** Reference lengths per bounding diameter, times the opacity factor. */
  readonly opticalScale: number;
}

/** Converts a gradient of `GradientStage` to data units per world unit: its factor. */
export function perWorldUnit(grid: GridFrame & { readonly kind?: string }): number {
  return grid.kind === 'polar' ? 1 : 1 / finestSpacing(grid);
}

/** Patches whose colours are multiplied by the light factor; each channel saturates at white. */
export function lightPatches(patches: readonly Patch[], lightFactor: number): readonly Patch[] {
  return patches.map((patch) => ({
    ...patch,
    color: patch.color.map((x) => Math.min(1, x * lightFactor)) as unknown as Vector3,
  }));
}

/**
 * Classification by values and gradients: pre-integration in closed form. Value and gradient change linearly between samples that know
 * their place.
 * Everything else is as in `usual`, the classification by a transfer function.
 * Twin: shaders/chunks/classify/patches.glsl
 */
export function patchClassify(
  usual: ClassifyStage,
  { patches, grid, gradient, field, opticalScale }: PatchScene,
): ClassifyStage {
  const toWorld = perWorldUnit(grid);
  const placeOf = (known: Sample): ValueAndGradient => [
    known.value,
    toWorld * length(gradient(known.point as Vector3, known).world),
  ];
  return {
    ...usual,
    classifySegment: ({ front, back, span }) => {
      if (!front.valid && !back.valid) return [0, 0, 0, 0];
      const [from, to] = [front.valid ? front : back, back.valid ? back : front].map(placeOf);
      const ratio = span * opticalScale * (front.valid && back.valid ? 1 : 0.5);
      if (!field.isFolded(from[0], to[0])) return attenuate(meanOverWay(patches, from, to), ratio);
      const [near, far] = [meanOverWay(patches, from, from), meanOverWay(patches, to, to)];
      return attenuate(near.map((x, c) => (x + far[c]) / 2) as Premultiplied, ratio);
    },
  };
}
