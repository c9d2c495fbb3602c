// What a page gets of the series in files of DICOM, to choose one.
import type { Vector3 } from '../../volume/matrix.ts';
import type { SeriesInfo } from '../../volume/volume.ts';
import type { ReadContext } from '../base/format.ts';
import { checkFrames, decodeFrame } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import { cutTile } from './gather-samples.ts';
import { placeAlong } from './group-frames.ts';
import type { ChosenSeries } from './group-frames.ts';
import { isJ2k } from './load-libraries.ts';
import { PixelLoader } from './load-pixels.ts';
import { modalityOf } from './modality.ts';
import { lookUp } from './value-table.ts';

/** Pixels of the larger side of a picture. */
const pictureSize = 64;

/** Only so many series have a picture: each takes the time of a slice. */
const maxPictures = 32;

/** Cosine of 20 degrees. */
const nearAxis = 0.94;

/** Lists the series by numbers, kinds and sizes, with a small picture of each. */
export async function describeSeries(
  { series, frames: chosen }: ChosenSeries,
  context: Pick<ReadContext, 'folder' | 'budget'>,
): Promise<readonly SeriesInfo[]> {
  const infos: SeriesInfo[] = [];
  for (const [i, frames] of series.entries()) {
    const middle = frames[frames.length >> 1];
    const { columns, rows, picture, seriesNumber } = middle;
    infos.push({
      number: i + 1,
      shown: frames === chosen,
      modality: modalityOf(picture.set),
      ...(seriesNumber === undefined ? {} : { seriesNumber }),
      dimensions: [columns, rows, frames.length],
      ...describePlace(frames),
      ...(i < maxPictures ? { picture: await drawSmall(middle, context) } : {}),
    });
  }
  return infos;
}

/** How the slices of a series lie, and how far their voxels are from each other; nothing of what its files do not say. */
function describePlace(frames: readonly Frame[]): Pick<SeriesInfo, 'plane' | 'spacing'> {
  const [{ plane, spacing, step }] = frames;
  const along = plane ? frames.map((frame) => placeAlong(frame, frames[0])) : [];
  const steps = along.slice(1).map((place, i) => Math.abs(place! - along[i]!));
  steps.sort((a, b) => a - b);
  const middle = (steps[steps.length >> 1] as number | undefined) || step;
  return {
    ...(plane && { plane: nameOfPlane(plane.normal) }),
    ...(spacing && middle && { spacing: [...spacing, middle] }),
  };
}

const planes = ['sagittal', 'coronal', 'axial'] as const;

/** By the axis of the patient that is nearest to the normal; oblique from 20 degrees on. */
function nameOfPlane(normal: Vector3): NonNullable<SeriesInfo['plane']> {
  const shares = normal.map(Math.abs);
  const largest = Math.max(...shares);
  return largest < nearAxis ? 'oblique' : planes[shares.indexOf(largest)];
}

/** The nearest pixels of a slice, within its window or the range of its values; undefined where it can not be decoded. */
async function drawSmall(
  frame: Frame,
  context: Pick<ReadContext, 'folder' | 'budget'>,
): Promise<SeriesInfo['picture']> {
  const { columns, rows, table, slope, intercept, windows } = frame;
  if (isJ2k(frame.picture)) return undefined; // Its library is loaded with the series itself.
  let numbers;
  try {
    const loaded = await new PixelLoader([frame], 0, context).load(frame);
    checkFrames(loaded.picture);
    numbers = cutTile(decodeFrame(loaded.picture, loaded.index, context.budget), loaded);
  } catch {
    return undefined; // The series itself says what is wrong with it, where it is chosen.
  }
  const scale = Math.min(1, pictureSize / Math.max(columns, rows));
  const [width, height] = [columns, rows].map((n) => Math.max(1, Math.round(n * scale)));
  const values = Float64Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)].map((at) => Math.floor((at + 0.5) / scale));
    return slope * lookUp(table, numbers[Math.min(rows - 1, y) * columns + Math.min(columns - 1, x)]) + intercept;
  });
  const [window] = windows().windows;
  const [low, high] = window ? [window.from, window.to] : rangeOf(values);
  const pixels = Uint8ClampedArray.from(values, (value) => (255 * (value - low)) / (high - low || 1));
  const [dx, dy] = frame.spacing ?? [1, frame.aspect];
  const aspect = (columns * dx) / (rows * dy);
  return { width, height, aspect: aspect > 0 && Number.isFinite(aspect) ? aspect : width / height, pixels };
}

/** Without the few brightest pixels. */
function rangeOf(values: Float64Array): readonly [number, number] {
  const sorted = values.filter(Number.isFinite);
  sorted.sort();
  return [sorted[0] ?? 0, sorted[Math.floor(0.99 * (sorted.length - 1))] ?? 1];
}
