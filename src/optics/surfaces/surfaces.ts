import type { JumpDepth } from '../transfer/jump-depth.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { brighten } from '../transfer/brighten.ts';
import { dataEnds } from '../rays/cast-ray.ts';
import type { Contribution } from '../cells/empty-space-distance.ts';
import { labelShade } from '../attachments/labels.ts';
import type { LightStage } from '../rays/lit.ts';
import type { IsoSurface } from '../rays/ray-style.ts';
import type { Styled } from '../transfer/volume-styles.ts';
import type { GatherStage, Sample, Seen, Segment } from '../rays/ray-stages.ts';
import type { Ray } from '../rays/rays.ts';
import { composite } from '../rays/segment.ts';
import { maxSubsteps } from '../transfer/substep-limits.ts';
import { between, crossSurfaces, findTurn, kinkedSubsteps, mayGraze, surfaceRefinements } from './surface-crossings.ts';
import type { Leg, Looking, Turn } from './surface-crossings.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/** The share of a flat change (see `flatChange`) that counts as flat for surfaces. A surface has a direction wherever it is. */
export const surfaceFlat = 0.1;

/** Colours multiplied by the light factor, as in `brighten`. */
export function brightenSurfaces(surfaces: readonly IsoSurface[], lightFactor: number): readonly IsoSurface[] {
  return surfaces.map((surface) => brighten([surface], lightFactor)[0]);
}

/** Which ranges of values contain a surface. */
export function contributionOfSurfaces(surfaces: readonly IsoSurface[]): Contribution {
  return (low, high) => surfaces.some(({ value, opacity }) => opacity > 0 && low <= value && high >= value);
}

/** Larger opacities count as this: an 8-bit picture cannot distinguish them. */
const maxSeen = 0.9999;

/** Optical depth of surfaces that a ray may pass, in and out again. */
export function depthOfSurfaces(surfaces: readonly IsoSurface[]): JumpDepth {
  const depths = surfaces.map(({ opacity }) => -2 * Math.log1p(-Math.min(maxSeen, opacity)));
  return (low, high) =>
    surfaces.reduce((sum, { value }, i) => (low <= value && high >= value ? sum + depths[i] : sum), 0);
}

/** The surfaces in a volume. */
export interface SurfaceScene {
  /** Ascending; colours already brightened. */
  readonly surfaces: readonly IsoSurface[];
  /** Whether only surfaces are drawn. */
  readonly isClear: boolean;
  /** The light at a place; null for surfaces in their own colours. */
  readonly light: LightStage | null;
  readonly toEye: (ray: Ray) => Vector3;
  /** The effect of X3D's rendering styles at places; absent if there are none. */
  readonly stylesOf?: (ray: Ray) => (known: Sample) => Styled;
  /** See `surfaceRefinements`. */
  readonly refinements?: number;
}

/**
 * Emission and absorption with surfaces, front to back. Between two samples the value is assumed to change linearly, and the piece is cut
 * where it passes a surface's value. Samples must know their `point`. Twin: shaders/chunks/gather/surfaces.glsl
 */
export function surfaceGather(scene: SurfaceScene): GatherStage {
  const { surfaces, isClear } = scene;
  const values = surfaces.map(({ value }) => value);
  return (seen) => {
    const gathered: Premultiplied = [0, 0, 0, 0];
    let before: Segment | null = null;
    const gather = (piece: Segment, color: Premultiplied): void => {
      seen.report?.(piece, color[3]);
      composite(gathered, color);
    };
    const walk = (leg: Leg): void => {
      let [share, front] = [0, leg.front];
      const gatherTo = (to: number, back: Sample): void => {
        const piece = { front, back, begin: leg.begin + share * leg.span, span: (to - share) * leg.span };
        if (leg.isNew) gather(piece, isClear ? clear : seen.seeSegment(piece));
        [share, front] = [to, back];
      };
      for (const { surface, share: at, hit } of crossSurfaces(
        values,
        leg,
        appearanceOf(seen),
        scene.refinements ?? surfaceRefinements,
      )) {
        gatherTo(at, hit);
        gather(
          { front: hit, back: hit, begin: leg.begin + at * leg.span, span: 0 },
          seeSurface(scene, surface, hit, seen.ray),
        );
      }
      gatherTo(1, leg.back);
    };
    return {
      add: (segment) => {
        const legs = listLegs(values, segment, before, seen);
        if (legs) legs.forEach(walk);
        else gather(segment, isClear ? clear : seen.seeSegment(segment));
        before = segment;
      },
      chooseSubsteps: (front, back) => {
        const min =
          runs(seen, front, back) && mayGraze(values, [front.value, back.value], changeBefore(before, seen))
            ? seen.field.kinksBetween
              ? kinkedSubsteps
              : maxSubsteps
            : 1;
        return isClear
          ? min
          : Math.max(min, seen.classify.countSubsteps(dataEnds(front, back), 1 - gathered[3], [front, back]));
      },
      finish: () => gathered,
    };
  };
}

const clear: Premultiplied = [0, 0, 0, 0];

/** Whether values change continuously from one sample to the next. */
function runs({ field }: Seen, a: Sample, b: Sample): boolean {
  return a.valid && b.valid && !field.isFolded(a.value, b.value);
}

function appearanceOf({ sampleAt, field: { kinksBetween } }: Seen): Looking {
  return { sampleAt, kinksBetween };
}

/** By how much values changed on the previous step, as far as is known. */
function changeBefore(before: Segment | null, seen: Seen): number {
  if (!before || !(before.span > 0) || !runs(seen, before.front, before.back)) return 0;
  return Math.abs(before.back.value - before.front.value) * (seen.step / before.span);
}

/** The colour of a surface where a ray passes it. */
function seeSurface(
  { surfaces, light, toEye, stylesOf }: SurfaceScene,
  surface: number,
  hit: Sample,
  ray: Ray,
): Premultiplied {
  const { color, opacity } = surfaces[surface];
  const own: Premultiplied = [color[0] * opacity, color[1] * opacity, color[2] * opacity, opacity];
  const known: Premultiplied =
    hit.style === undefined ? own : labelShade({ front: hit, back: hit, begin: 0, span: 0 }, own, ray);
  if (stylesOf) return styleSurface(known, stylesOf(ray)(hit));
  const [red, green, blue, alpha] = known;
  if (!light) return known;
  const { diffuse, specular } = light(hit, toEye(ray));
  const [r, g, b] = [red, green, blue].map((x, c) => Math.min(alpha, x * diffuse[c] + alpha * specular[c]));
  return [r, g, b, alpha];
}

function styleSurface([red, green, blue, alpha]: Premultiplied, { gain, more, opacity }: Styled): Premultiplied {
  if (!(alpha > 0)) return [0, 0, 0, 0];
  const styled = Math.min(1, alpha * opacity);
  const [r, g, b] = [red, green, blue].map(
    (x, c) => styled * Math.min(1, Math.max(0, (x / alpha) * gain[c] + more[c])),
  );
  return [r, g, b, styled];
}

/** The pieces of a segment on which values rise or fall; null if no part of it can have a surface. */
function listLegs(values: readonly number[], segment: Segment, before: Segment | null, seen: Seen): Leg[] | null {
  const { front, back, begin, span } = segment;
  if (!(span > 0) || !runs(seen, front, back)) return null;
  const whole: Leg = { ...segment, from: front.value, isNew: true };
  const isNext = before !== null && before.span > 0 && before.begin + before.span > begin - 1e-6 * span;
  const sample = isNext ? before.front : seen.sampleAt(between(front, back, -1));
  const spanBefore = isNext ? before.span : span;
  const turn: Turn | null = runs(seen, sample, front)
    ? findTurn(values, segment, { sample, span: spanBefore, isShown: isNext }, appearanceOf(seen))
    : null;
  if (!turn) return [whole];
  const { at, top } = turn;
  if (at > 0)
    return [
      { ...whole, back: top, span: at },
      { front: top, back, begin: begin + at, span: span - at, from: top.value, isNew: true },
    ];
  // The part before it was already gathered, except for the surfaces that were missed.
  const rise: Leg = {
    front: sample,
    back: top,
    begin: begin - spanBefore,
    span: spanBefore + at,
    from: front.value,
    isNew: false,
  };
  return [rise, { front: top, back: front, begin: begin + at, span: -at, from: top.value, isNew: false }, whole];
}
