import type { emptyQuad, interpolateQuad, Pixels } from '../optics/rays/between-pixels.ts';
import type { keptError } from './error-estimate.ts';
import type { ErrorEstimate } from './error-estimate.ts';
import { allRays } from './sampling-outcome.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';

/** Curvature limits to try, in 1/255. */
const triedCurvatures: readonly number[] = [3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];

/** Distances of the pixels that are known, then of those between them, as adaptive ray sampling casts them. */
const strides = [4, 2] as const;

/** At the edge of a tile pixels lack neighbours that they have in the picture, so these do not count. */
export const tileMargin = 4;

/** Tiles are a sample of the picture, so what they lose may be this share of what is allowed. */
const certain = 0.95;

/** Half of the pixels that may be off by more: they lie together, as a small thing covers several, so tiles may have few of them by chance. */
const fewPixels = 0.0005;

/** If more rays than this share are left, testing pixels takes as long as those that are left out. */
const worthSparing = 0.8;

/** Functions that whoever calls has loaded: see viewer/frames/measuring-tools.ts. */
export interface SparingTools {
  readonly emptyQuad: typeof emptyQuad;
  readonly interpolateQuad: typeof interpolateQuad;
  readonly keptError: typeof keptError;
}

/** A tile with adaptive ray sampling. */
export interface SparedPixels {
  readonly data: Uint8Array<ArrayBuffer>;
  /** One byte per pixel: 1 if it got a ray of its own. */
  readonly cast: Uint8Array<ArrayBuffer>;
  /** Rays, with those of the coarser lattices, which are cast twice where finer ones are needed too. */
  readonly rays: number;
}

/**
 * The picture that adaptive ray sampling makes: rays at every fourth pixel, then four for each quad that curves by more than a limit.
 * @param full - bytes, all of its rays; sides that are multiples of 4
 * @param maxCurvature - 1/255
 */
export function spareRays(
  { data: truth, width, height }: Pixels,
  maxCurvature: number,
  { emptyQuad, interpolateQuad }: SparingTools,
): SparedPixels {
  const quad = emptyQuad();
  const data = Uint8Array.from(truth);
  const cast = new Uint8Array(width * height);
  let rays = (width / strides[0]) * (height / strides[0]);
  for (const stride of strides) {
    const source = { data: data.slice(), width, height };
    const half = stride / 2;
    for (let y = 0; y < height; y += stride) {
      for (let x = 0; x < width; x += stride) {
        interpolateQuad(source, stride, [x / stride, y / stride], quad);
        const needsRays = quad.curvature > maxCurvature;
        if (needsRays) rays += 4;
        for (let i = 0; i < 4; i++) {
          const pixel = (y + half * (i >> 1)) * width + x + half * (i & 1);
          cast[pixel] = Number(needsRays);
          for (let c = 0; c < 4; c++) {
            const between = Math.min(255, Math.max(0, Math.round(quad.colors[4 * i + c])));
            data[4 * pixel + c] = needsRays ? truth[4 * pixel + c] : between;
          }
        }
      }
    }
  }
  return { data, cast, rays };
}

/** What interpolated pixels lose, over the pixels that show something. */
export interface SparedLoss extends Pick<ErrorEstimate, 'rms' | 'p99' | 'p999' | 'max'> {
  readonly sampling: SamplingOutcome;
}

const nothingSpared: SparedLoss = { rms: 0, p99: 0, p999: 0, max: 0, sampling: allRays };

/** The errors of steps and of interpolated pixels together, from their own: squares add up, the largest ones may meet. */
export function addLoss<T extends Pick<ErrorEstimate, 'rms' | 'p99' | 'p999' | 'max'>>(steps: T, loss: SparedLoss): T {
  return {
    ...steps,
    rms: Math.hypot(steps.rms, loss.rms),
    p99: steps.p99 + loss.p99,
    p999: steps.p999 + loss.p999,
    max: steps.max + loss.max,
  };
}

/**
 * Chooses which pixels of a picture are interpolated: as many as the error allows, by parts of the picture that were drawn with all rays.
 * @param tiles - bytes, sides that are multiples of 4
 * @param steps - the error of the picture's steps
 * @param maxError - the limit of `keptError`, 1/255
 */
export function chooseSparing(
  tiles: readonly Pixels[],
  steps: Pick<ErrorEstimate, 'rms' | 'p99' | 'p999' | 'max'>,
  maxError: number,
  tools: SparingTools,
): SparedLoss {
  let chosen = nothingSpared;
  if (tiles.length === 0) return chosen;
  // Errors grow with the limit, so half of the limits that are left can be ruled out each time.
  for (let [from, to] = [0, triedCurvatures.length]; from < to;) {
    const middle = (from + to) >> 1;
    const loss = measureLoss(tiles, triedCurvatures[middle], tools);
    if (tools.keptError(addLoss(steps, loss)) <= certain * maxError) {
      chosen = loss;
      from = middle + 1;
    } else to = middle;
  }
  return chosen.sampling.share <= worthSparing ? chosen : nothingSpared;
}

function measureLoss(tiles: readonly Pixels[], maxCurvature: number, tools: SparingTools): SparedLoss {
  const worst: number[] = [];
  let [squares, rays, pixels] = [0, 0, 0];
  for (const tile of tiles) {
    const { data: truth, width, height } = tile;
    const spared = spareRays(tile, maxCurvature, tools);
    rays += spared.rays;
    pixels += width * height;
    for (let y = tileMargin; y < height - tileMargin; y++) {
      for (let x = tileMargin; x < width - tileMargin; x++) {
        const at = 4 * (y * width + x);
        if (truth[at + 3] === 0 && spared.data[at + 3] === 0) continue;
        let max = 0;
        for (let c = at; c < at + 4; c++) {
          const off = Math.abs(spared.data[c] - truth[c]);
          squares += off ** 2;
          max = Math.max(max, off);
        }
        worst.push(max);
      }
    }
  }
  worst.sort((a, b) => a - b);
  const shareOf = (share: number): number => worst[Math.min(worst.length - 1, Math.floor(worst.length * share))] ?? 0;
  const error = Math.sqrt(squares / Math.max(1, 4 * worst.length));
  return {
    rms: error,
    p99: shareOf(0.99),
    p999: shareOf(1 - fewPixels),
    max: worst.at(-1) ?? 0,
    sampling: { maxCurvature, share: rays / Math.max(1, pixels), error },
  };
}
