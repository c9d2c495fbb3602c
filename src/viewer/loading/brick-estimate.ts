// What the bricks of a view bring to its picture.
import type { Brick } from '../../bricks/pyramid.ts';
import { BrickGains, probeBricks } from '../../bricks/rank-bricks.ts';
import { seekDetail } from '../../bricks/estimate-detail.ts';
import type { ResidentBricks } from '../../bricks/resident-bricks.ts';
import type { ResidentDetail } from '../../bricks/resident-detail.ts';
import { levelOfPixels } from '../../bricks/pixel-levels.ts';
import { sumSpans } from '../../bricks/span-sums.ts';
import type { Waiting } from '../../core/waiting.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { ErrorPart } from '../../quality/error-estimate.ts';
import { voxelsAlong } from '../../quality/steps.ts';
import { finestSpacing, unitToWorld } from '../../volume/grid.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { isKept } from '../../volume/world-cut.ts';
import { extremeOf, lightOf, paintedOf, seenValues } from './brick-looks.ts';
import type { BrickPicture } from './brick-picture.ts';
import { steepOf } from './brick-steep.ts';
import type { SteepCode } from './brick-steep.ts';

/** What was found. */
export interface BrickEstimate {
  /** Bricks that have to be looked at before `error` can be relied on; those that follow them are not listed yet. */
  readonly probes: readonly Brick[];
  readonly gains: BrickGains;
  /** The finest level that the pixels of the picture need anywhere; 0 where it shows nothing. */
  readonly finest: number;
  /** The error that is left in the picture, over the rays that show something. No bound of the largest one is known. */
  readonly error: ErrorPart;
  /** The same in the unit of the gains. */
  readonly energy: number;
}

/** Rays across and down. */
const across = 36;

/** Steps along the longest ray. */
const [leastSteps, mostSteps] = [128, 320];

/** Which estimate of a picture it is, and what it needs. */
export interface EstimateTurn {
  /**
   * From 0. Each turn has rays at other places of their pixels: bricks are chosen for those of the turn before, so these rays alone would say too little of what is
   * missing.
   */
  readonly turn: number;
  /** Where `isSteep`. */
  readonly steepCode?: SteepCode;
}

/** Shares of a pixel from one turn to the next, across and down: they fill it evenly. Source: Roberts 2018, powers of the plastic number. */
const nextShift = [0.7548776662, 0.569840291] as const;

/** Estimates what the bricks bring, with pauses. @returns null where no ray can be cast */
export function* estimateBricks(
  {
    volume,
    bricks,
    detail,
  }: { readonly volume: Volume; readonly bricks: ResidentBricks; readonly detail: ResidentDetail },
  { view, optics, away, planes, ...picture }: BrickPicture,
  { turn, steepCode }: EstimateTurn,
): Waiting<BrickEstimate | null> {
  const rays = setUpRays(volume.grid, view.view, view.projection);
  if (!rays) return null;
  detail.update();
  const steps = Math.min(mostSteps, Math.max(leastSteps, 2 * voxelsAlong(volume.grid)));
  const length = rays.diameter / steps;
  const toWorld = unitToWorld(volume.grid);
  const [transferFunction, referenceLength] = seenValues(volume, optics, rays.diameter);
  // The largest value of a ray is not that of averages, however small it appears.
  const extreme = extremeOf(optics, volume);
  const pixels = extreme ? undefined : picture.pixels;
  const finestAt = pixels && levelOfPixels(rays, pixels, detail.voxels);
  const gains = new BrickGains(bricks);
  const scale = {
    slope: volume.slope,
    intercept: volume.intercept,
    stepRatio: (length / referenceLength) * optics.opacityFactor,
  };
  const steep = steepCode && steepOf(steepCode, optics, { volume, finest: bricks.finest, stored: detail.range }, scale);
  const scene = {
    field: detail,
    rays,
    sums: sumSpans(transferFunction, detail.range, scale),
    step: 1 / steps,
    voxels: length / finestSpacing(bricks.finest),
    hidden: detail,
    across,
    shift: nextShift.map((share) => (0.5 + turn * share) % 1) as unknown as readonly [number, number],
    finestAt,
    extreme,
    steep,
    // Styles have their light with them.
    light: steep?.styleOf ? undefined : lightOf(optics, bricks.finest),
    planes: planes?.map((plane) => paintedOf(plane, optics, detail.range, volume)),
    isAway: away && ((x: number, y: number, z: number) => !isKept(away, transformPoint(toWorld, [x, y, z]))),
  };
  const probes = probeBricks(bricks.layout, rays, (brick) => detail.isMeasured(brick), finestAt);
  const { rms, p99, finest, energy } = yield* seekDetail(scene, gains);
  return { gains, probes, finest, energy, error: { rms, p99, max: null } };
}
