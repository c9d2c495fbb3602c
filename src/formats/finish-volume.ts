import { cartesianGrid } from '../volume/grid.ts';
import { largestWindow } from '../optics/transfer/transfer-function.ts';
import { summarize } from '../volume/histogram.ts';
import { buildMacrocells } from '../volume/macrocells.ts';
import { multiply, scaleAndTranslate } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Block, DeviceLimits } from '../volume/reduce.ts';
import { allocateLike } from '../volume/samples.ts';
import type { Volume } from '../volume/volume.ts';
import type { DecodedCartesianVolume, DecodedPolarVolume, DecodedVolume } from './base/decoded-volume.ts';
import { loadReader } from './base/load-reader.ts';
import type { Cleaning } from './base/clean-volume.ts';
import type { CoarseVolume } from './base/load-request.ts';
import { suggestAppearance } from './appearance/suggest-appearance.ts';

/** Volumes of more bytes than this get a coarse one that stands in for them. */
export const minForCoarse = 2 ** 22;

/** For volumes of more bytes than this, the coarse one is averaged. */
export const minForMeans = 2 ** 25;

/** Maximum bytes of a coarse volume: 128 x 128 x 128 voxels of 16 bits. */
export const maxCoarse = 2 ** 22;

type CoarseListener = (coarse: CoarseVolume) => void;

/**
 * Make a decoded volume fit the device, and count its values.
 * @param onCoarse - gets a stand-in for a large volume as soon as its values are counted, and of a radar what there is before its macrocells
 * @param clean - hide what touches nothing
 * @throws {VolumeViewError} `format/corrupt` where its values are beyond numbers, `attribute/invalid` where it can't be cleaned
 * @throws {NeedsMainThread} in a worker that can not load what makes it smaller
 */
export async function finishVolume(
  decoded: DecodedVolume,
  limits: DeviceLimits,
  onCoarse?: CoarseListener,
  clean?: Cleaning,
): Promise<Volume> {
  if (!isPolarVolume(decoded)) return finishCartesian(decoded, limits, onCoarse, clean);
  if (clean !== undefined) throw (await loadRare()).refuseRadar(clean);
  const { outlinePolar, predictPolar } = await loadReader(() => import('#rare/formats/radar/finish-polar.ts'));
  const outline = outlinePolar(decoded);
  await checkRange(outline);
  const preview = onCoarse && predictPolar(outline);
  if (preview) onCoarse(preview);
  return { ...outline, macrocells: decoded.makeMacrocells() };
}

/** Samples of float32 times a slope of float64 may be larger than float64 holds. */
async function checkRange(volume: Pick<Volume, 'range' | 'format'>): Promise<void> {
  if (!Number.isFinite(volume.range[1] - volume.range[0])) (await loadRare()).refuseRange(volume);
}

function isPolarVolume(decoded: DecodedVolume): decoded is DecodedPolarVolume {
  return decoded.grid.kind === 'polar';
}

async function finishCartesian(
  file: DecodedCartesianVolume,
  limits: DeviceLimits,
  onCoarse?: CoarseListener,
  clean?: Cleaning,
): Promise<Volume> {
  const decoded = file.colors ? (await loadRare()).fitColors(file, limits) : file;
  const block = { ...decoded.grid, samples: decoded.samples };
  const { dimensions, samples, indexToWorld } = await fitBlock(block, limits);
  const isReduced = samples !== block.samples;
  const { samples: _all, isLabels: _said, intent: _code, counts, ...rest } = decoded;
  let summary = summarize(samples, decoded.slope, decoded.intercept, isReduced ? {} : { known: counts });
  const appearance = await suggestAppearance(decoded, summary.histogram);
  // Of what is left there may be fewer values; the look stays that of the whole.
  const hidden =
    clean === undefined
      ? null
      : await (await loadRare()).cleanVolume(clean, { ...decoded, ...summary, ...appearance }, { samples, dimensions });
  if (hidden) summary = summarize(samples, decoded.slope, decoded.intercept);
  const outline: CoarseVolume['of'] = {
    ...rest,
    grid: cartesianGrid(dimensions, indexToWorld),
    ...summary,
    ...(decoded.indexed && {
      range: [decoded.indexed.ids[0], decoded.indexed.ids[decoded.indexed.ids.length - 1]] as const,
    }),
    ...appearance,
    left:
      decoded.rounded || decoded.unkept || hidden || Math.max(...summary.range.map(Math.abs)) > largestWindow
        ? [
            ...(decoded.left ?? []),
            ...(await loadRare()).reportNumbers(decoded, summary.range),
            ...(hidden ? [hidden] : []),
          ]
        : decoded.left,
    ...(isReduced ? { reduced: { from: block.dimensions, to: dimensions } } : {}),
  };
  await checkRange(outline);
  if (appearance.isDiscrete && (isReduced || decoded.indexed || !appearance.transferFunction)) {
    const { finishLabels } = await loadReader(() => import('#rare/formats/finish-labels.ts'));
    return finishLabels({ decoded, outline, fit: (whole) => fitBlock(whole, limits) });
  }
  if (onCoarse && !outline.isDiscrete && !outline.channels && samples.byteLength > minForCoarse)
    onCoarse(await makeCoarse(outline, samples, limits));
  // Of those that are made smaller, or cleaned, voxels are not the file's.
  return {
    ...outline,
    ...((isReduced || hidden) && { indexed: undefined }),
    samples,
    macrocells: buildMacrocells(samples, dimensions),
  };
}

const loadRare = () => loadReader(() => import('#rare/formats/finish-rare.ts'));

/** Few volumes have to be made smaller: what does that is loaded with the first of them. */
async function fitBlock(block: Block, limits: DeviceLimits): Promise<Block> {
  const isSmall =
    Math.max(...block.dimensions) <= limits.maxVoxelsPerAxis && block.samples.byteLength <= limits.maxBytes;
  if (isSmall && limits.maxAtlasSize === null) return block;
  const { fitVolume } = await loadReader(() => import('../volume/reduce.ts'));
  return fitVolume(block, limits);
}

/**
 * Makes the coarse volume. It has the place, the range and the histogram of the large one: so it gets the same camera
 * and the same colours. For a volume that is ready in a moment, every other voxel along each axis is enough; one that
 * takes longer is averaged.
 */
async function makeCoarse(of: CoarseVolume['of'], all: Volume['samples'], limits: DeviceLimits): Promise<CoarseVolume> {
  const block = { ...of.grid, samples: all };
  const { dimensions, samples, indexToWorld } =
    all.byteLength > minForMeans ? await fitBlock(block, { ...limits, maxBytes: maxCoarse }) : halve(block);
  const volume: Volume = {
    ...of,
    grid: cartesianGrid(dimensions, indexToWorld),
    samples,
    macrocells: buildMacrocells(samples, dimensions),
    coarse: true,
  };
  return { volume, of };
}

/** Takes every other voxel along each axis. The outer faces of the volume stay where they are in the world. */
function halve({ dimensions, samples: all, indexToWorld }: Block): Block {
  const [nx, ny] = dimensions;
  const to = dimensions.map((n) => Math.ceil(n / 2)) as unknown as Vector3;
  const samples = allocateLike(all, to[0] * to[1] * to[2]);
  let out = 0;
  for (let k = 0; k < to[2]; k++) {
    for (let j = 0; j < to[1]; j++) {
      const row = (2 * k * ny + 2 * j) * nx;
      for (let i = 0; i < to[0]; i++) samples[out++] = all[row + 2 * i];
    }
  }
  const scale = dimensions.map((n, axis) => n / to[axis]) as unknown as Vector3;
  return {
    dimensions: to,
    samples,
    indexToWorld: multiply(indexToWorld, scaleAndTranslate(scale, scale.map((s) => (s - 1) / 2) as unknown as Vector3)),
  };
}
