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

/** A volume that is shown by value and gradient. */
export interface PatchScene {
  /** See `lightPatches`. */
  readonly patches: readonly Patch[];
  readonly grid: GridFrame & { readonly kind?: string };
  readonly gradient: GradientStage;
  readonly field: Pick<FieldStage, 'isFolded'>;
  /** Reference lengths per bounding diameter, times the opacity factor. */
  readonly opticalScale: number;
}

/** A gradient as `GradientStage` tells it times this is one in data units per world unit. */
export function perWorldUnit(grid: GridFrame & { readonly kind?: string }): number {
  return grid.kind === 'polar' ? 1 : 1 / finestSpacing(grid);
}

/** Patches whose colours are multiplied by the light factor; each channel saturates at white. */
export function lightPatches(patches: readonly Patch[], lightFactor: number): readonly Patch[] {
  return patches.map((patch) => ({ ...patch, color: patch.color.map((x) => Math.min(1, x * lightFactor)) as unknown as Vector3 }));
}

/**
 * What values and gradients look like: pre-integration in closed form, value and gradient running straight between samples that know where they are.
 * All else is as by the transfer function that `usual` is of.
 * Twin: shaders/chunks/classify/patches.glsl
 */
export function patchClassify(usual: ClassifyStage, { patches, grid, gradient, field, opticalScale }: PatchScene): ClassifyStage {
  const toWorld = perWorldUnit(grid);
  const placeOf = (known: Sample): ValueAndGradient => [known.value, toWorld * length(gradient(known.point as Vector3, known).world)];
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
