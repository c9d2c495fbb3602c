// The numbers of all slices, in one array.
import type { Budget } from '../base/budget.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { ProgressListener } from '../base/decoded-volume.ts';
import { loadReader } from '../base/load-reader.ts';
import { numberTypes } from '../base/number-types.ts';
import type { UnpackJ2k } from '../codecs/openjpeg.ts';
import { arrayOf, checkFrames, decodeFrame, isJ2k } from './decode-frame.ts';
import type { FrameNumbers } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import type { StoredType } from './picture.ts';
import type { Stack } from './stack-frames.ts';

export interface Gathered {
  readonly type: StoredType;
  readonly numbers: FrameNumbers;
  /** Value = slope * number + intercept. */
  readonly slope: number;
  readonly intercept: number;
}

const what = 'the DICOM series';

/**
 * Decodes slice after slice. Where all have the same scale, the numbers stay as they are stored; else they are brought to
 * one. Missing slices and padding are NaN.
 * @throws {VolumeViewError} `format/too-large`, `format/corrupt`, `format/unsupported`, before memory is taken
 */
export async function gatherSamples(
  { slices, resample }: Stack,
  budget: Budget,
  onProgress: ProgressListener,
): Promise<Gathered> {
  const frames = slices.filter((slice) => slice !== null);
  new Set(frames.map(({ picture }) => picture)).forEach(checkFrames);
  const library = frames.some(({ picture }) => isJ2k(picture)) ? await loadLibrary() : null;
  const [{ columns, rows, ...first }] = frames;
  const isOneScale = frames.every(
    ({ slope, intercept, picture }) =>
      slope === first.slope && intercept === first.intercept && picture.type === first.picture.type,
  );
  const voxels = columns * rows * slices.length;
  let type: StoredType = isOneScale ? first.picture.type : chooseType(frames);
  if (frames.length < slices.length || resample) type = floatOf(type);
  let all = allocate(type, voxels, [columns, rows, slices.length], budget);
  let last: { readonly frame: Frame; readonly numbers: FrameNumbers } | null = null;
  slices.forEach((frame, k) => {
    onProgress(k, slices.length);
    const start = k * columns * rows;
    if (!frame) return void all.fill(NaN, start, start + columns * rows);
    // Tiles of a mosaic share their picture.
    if (last?.frame.picture !== frame.picture || last.frame.index !== frame.index)
      last = { frame, numbers: decodeFrame(frame.picture, frame.index, budget, library) };
    const numbers = cutTile(last.numbers, frame);
    const {
      slope,
      intercept,
      picture: { padding },
    } = frame;
    if (isOneScale) all.set(numbers, start);
    else for (let i = 0; i < numbers.length; i++) all[start + i] = slope * numbers[i] + intercept;
    if (!padding) return;
    const [low, high] = padding;
    for (let i = 0; i < numbers.length; i++) {
      if (!(numbers[i] >= low && numbers[i] <= high)) continue;
      if (floatOf(type) !== type) {
        // Only floats have a number for no data.
        const before = all;
        type = floatOf(type);
        all = allocate(type, voxels, [columns, rows, slices.length], budget);
        all.set(before);
        budget.giveBack(before.byteLength);
      }
      all[start + i] = NaN;
    }
  });
  if (resample) {
    const made = allocate(type, columns * rows * resample.length, [columns, rows, resample.length], budget);
    resampleSlices(all, made, columns * rows, resample);
    budget.giveBack(all.byteLength);
    all = made;
  }
  return {
    type,
    numbers: all,
    ...(isOneScale ? { slope: first.slope, intercept: first.intercept } : { slope: 1, intercept: 0 }),
  };
}

async function loadLibrary(): Promise<UnpackJ2k> {
  return (await loadReader(() => import('../codecs/openjpeg.ts'))).loadOpenJpeg();
}

function allocate(type: StoredType, voxels: number, lengths: readonly number[], budget: Budget): FrameNumbers {
  budget.take(countSampleBytes(what, lengths, numberTypes[type]), what);
  return new arrayOf[type](voxels);
}

/** A type that holds the values of all frames: whole numbers if they are. */
function chooseType(frames: readonly Frame[]): StoredType {
  const areWhole = frames.every(
    ({ slope, intercept, picture: { type, bitsStored } }) =>
      !type.startsWith('float') &&
      Number.isInteger(slope) &&
      Number.isInteger(intercept) &&
      Math.abs(slope) * 2 ** bitsStored + Math.abs(intercept) < 2 ** 31,
  );
  if (areWhole) return 'int32';
  return frames.some(({ picture: { type } }) => floatOf(type) === 'float64') ? 'float64' : 'float32';
}

/** The floats that hold all numbers of a type. */
function floatOf(type: StoredType): 'float32' | 'float64' {
  return /32|64/.test(type) && type !== 'float32' ? 'float64' : 'float32';
}

/** The part of a picture's numbers that a frame is. */
export function cutTile(numbers: FrameNumbers, { columns, rows, corner: [i, j], picture }: Frame): FrameNumbers {
  if (columns === picture.columns && rows === picture.rows) return numbers;
  const tile = new arrayOf[picture.type](columns * rows);
  for (let row = 0; row < rows; row++) {
    const start = (j + row) * picture.columns + i;
    tile.set(numbers.subarray(start, start + columns), row * columns);
  }
  return tile;
}

/** Where one of two slices has no data, the value between them is that of the nearer one. */
function resampleSlices(from: FrameNumbers, to: FrameNumbers, pixels: number, places: readonly number[]): void {
  for (const [k, place] of places.entries()) {
    const below = Math.floor(place);
    const share = place - below;
    for (let i = 0; i < pixels; i++) {
      const low = from[below * pixels + i];
      const high = share === 0 ? low : from[(below + 1) * pixels + i];
      const isWhole = low === low && high === high;
      to[k * pixels + i] = isWhole ? low + share * (high - low) : share < 0.5 ? low : high;
    }
  }
}
