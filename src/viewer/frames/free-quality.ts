// What `detail="free"` leaves out of a picture at rest: steps, and rays. Only such pages load it.
import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { PixelLattice } from '../../optics/rays/rays.ts';
import { cutNowhere, findFirst, listCoarseLevels, uncut } from '../../quality/coarse-levels.ts';
import type { ErrorEstimate } from '../../quality/error-estimate.ts';
import type { Level, LevelCuts } from '../../quality/levels.ts';
import type { PixelRectangle } from '../../quality/place-probes.ts';
import { addLoss, chooseSparing, tileMargin } from '../../quality/spare-rays.ts';
import { autoSteps } from '../../quality/steps.ts';
import type { Waiting } from '../../core/waiting.ts';
import type { ErrorProbe } from './measure-quality.ts';
import type { MeasuringTools } from './measuring-tools.ts';
import type { ChosenLevel } from './chosen-level.ts';
import type { DrawnView } from '../model/drawn-view.ts';

/** Side in pixels of the tiles of a picture that are drawn with all rays, to see which pixels could be interpolated. */
const side = 48;

/** Tiles have about this share of the pixels in which something may be visible. */
const share = 0.12;

/** Smallest and largest number of tiles along each side: with few, one pixel in a thousand is not met. */
const along: readonly [number, number] = [2, 6];

/**
 * Parts of a picture: squares in an even grid, each in the middle of its part; or all of a small rectangle, with its edges, which may not be
 * among the pixels that don't count. Every fourth pixel, from the first one on, is one that gets a ray in the picture too.
 * @param rectangle - in which something may be visible
 */
function placeTiles({ left, bottom, width, height }: PixelRectangle): PixelLattice[] {
  const known = (pixel: number): number => 4 * Math.floor(pixel / 4);
  const count = Math.min(along[1], Math.max(along[0], Math.round(Math.sqrt(share * width * height) / side)));
  const places = (begin: number, pixels: number): { size: number; firsts: number[] } => {
    if (pixels <= count * side) {
      const first = known(begin - tileMargin);
      return { size: known(begin + pixels + tileMargin + 3) - first, firsts: [first] };
    }
    const each = pixels / count;
    const firsts = Array.from({ length: count }, (_, i) => known(begin + (i + 0.5) * each - side / 2));
    return { size: side, firsts };
  };
  const [across, up] = [places(left, width), places(bottom, height)];
  return up.firsts.flatMap((y) =>
    across.firsts.map((x): PixelLattice => ({ stride: 1, first: [x, y], width: across.size, height: up.size })),
  );
}

/** Tiles that are drawn before the page waits for them. */
const tilesAtOnce = 4;

/** Parts of a level's picture with all rays, as bytes; none where the device can't draw them. */
function* drawTiles(probe: ErrorProbe, level: Level): Waiting<Pixels[]> {
  const tiles: Pixels[] = [];
  const lattices = probe.rectangle ? placeTiles(probe.rectangle) : [];
  for (let from = 0; from < lattices.length; from += tilesAtOnce) {
    const some = lattices.slice(from, from + tilesAtOnce);
    const parts = yield* probe.drawParts(some, level);
    if (!parts) return [];
    for (const [i, { width, height }] of some.entries()) {
      const data = Uint8Array.from(parts[i], (x) => Math.round(255 * Math.min(1, Math.max(0, x))));
      tiles.push({ data, width, height });
    }
  }
  return tiles;
}

/** Steps alone may leave this share of `max-error`: the rest is for pixels without rays. */
const shareOfSteps = 0.75;

/**
 * Coarse levels are compared with one and two uncut steps per voxel, where these differ by no more than this share of `max-error`: what
 * finer pictures would add is little of it.
 */
const shareOfReference = 1 / 3;

/** A view, and how its levels are chosen where nothing small may be lost. */
interface UsualQuality {
  readonly view: DrawnView;
  readonly asked: { readonly maxError: number };
  readonly cuts: LevelCuts;
  chooseUsual(): Promise<ChosenLevel | null>;
  /** The error of the level that it chose; null where the device can't measure it. */
  estimate(level: Level): ErrorEstimate | null;
  /** With this level pictures in motion are compared. */
  remember(level: Level): void;
}

/** A level with its error, and the probe that measured it or can draw parts of it. */
interface Measured {
  readonly level: Level;
  readonly estimate: ErrorEstimate;
  readonly probe: ErrorProbe;
}

/** The level with the fewest steps that keeps the error, no more than one per voxel; null where none does, or the view is no longer needed. */
async function chooseCoarse(
  { view, asked: { maxError } }: UsualQuality,
  { ErrorProbe, keptError }: MeasuringTools,
): Promise<Measured | null> {
  const { scene, grid, size, goesOn } = view;
  if (scene.walksVoxels) return null;
  const probe = new ErrorProbe(scene, { grid, size, cuts: cutNowhere, losesSmall: true });
  const estimate = async (level: Level, finer?: readonly number[]): Promise<ErrorEstimate | null> => {
    const compared = finer && {
      isEven: false,
      pictures: [level.steps, ...finer].map((steps) => [steps, uncut] as const),
    };
    return (await probe.prepare(level, goesOn, compared)) ? probe.estimate(level, compared) : null;
  };
  const one = autoSteps(grid);
  const reference = await estimate({ steps: one, substeps: 1 }, [2 * one, 2 * one]);
  // Rounding to 8 bits is no error of a reference.
  const differs = reference && keptError({ ...reference, rms: reference.discretization });
  if (differs === null || differs > shareOfReference * maxError) return null;
  const found = await findFirst(
    listCoarseLevels(one),
    (level) => estimate(level, level.steps < one ? [one, 2 * one] : undefined),
    (measured) => keptError(measured) <= shareOfSteps * maxError,
  );
  return found && { level: found.level, estimate: found.measured, probe };
}

/**
 * Choose as few steps and rays as keep the error. What lies between samples, and between rays, has no bound.
 * @returns null where the view is no longer needed
 */
export async function chooseFree(quality: UsualQuality, tools: MeasuringTools): Promise<ChosenLevel | null> {
  const { aside, ErrorProbe, stateError } = tools;
  const {
    view: { scene, grid, size, goesOn },
    asked: { maxError },
    cuts,
  } = quality;
  const coarse = await chooseCoarse(quality, tools);
  const usual = coarse ? null : await quality.chooseUsual();
  const estimate = coarse?.estimate ?? (usual && quality.estimate(usual.level));
  if (!estimate) return usual;
  const { level, probe } = coarse ?? { ...usual!, probe: new ErrorProbe(scene, { grid, size, cuts }) };
  // The edges of surfaces get more rays, not fewer.
  const canSpare = scene.adaptive && !scene.whatIsSeen()?.hasSurfaces;
  const tiles = canSpare ? await aside(drawTiles(probe, level), scene, goesOn) : { value: [] };
  if (!tiles) return null;
  const loss = chooseSparing(tiles.value, estimate, maxError, tools);
  if (usual && loss.sampling.maxCurvature === 0) return usual;
  // Pictures in motion are compared with one step a voxel, and finer ones.
  if (coarse) quality.remember({ steps: autoSteps(grid), substeps: 1 });
  const bound = probe.rectangle && scene.whatIsSeen() ? 1 : 0;
  return {
    level: { ...level, free: { substeps: probe.view.cuts.own(level), sampling: loss.sampling } },
    ...stateError(addLoss(estimate, loss), bound, maxError),
  };
}
