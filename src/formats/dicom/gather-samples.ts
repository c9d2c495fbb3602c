// The numbers of all slices, in one array.
import type { Budget } from '../base/budget.ts';
import { bytesOfColors } from '../base/channels.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { ReadContext } from '../base/format.ts';
import { numberTypes } from '../base/number-types.ts';
import { readAhead } from '../base/read-ahead.ts';
import { orderSlices } from './coarse-part.ts';
import { checkDamage, describeDamage, findDamage } from './damage.ts';
import type { Damage } from './damage.ts';
import { arrayOf, checkFrames, decodeFrame } from './decode-frame.ts';
import type { FrameNumbers } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import { loadLibraries } from './load-libraries.ts';
import { PixelLoader } from './load-pixels.ts';
import { NumberCounts } from './number-counts.ts';
import type { StoredType } from './picture.ts';
import { lookUp } from './value-table.ts';
import type { Stack } from './stack-frames.ts';

export interface Gathered {
  readonly type: StoredType;
  readonly numbers: FrameNumbers;
  /** Value = slope * number + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** Where the pictures are in colours: red, green and blue of each pixel, 0 where a slice is not there. */
  readonly rgb?: Uint8Array<ArrayBuffer>;
  /** Where the numbers have 16 bits, and are all that they were in the files. */
  readonly counts?: NumberCounts;
  /** What of the slices is not there, in words. */
  readonly left: readonly string[];
}

export interface GatherOptions {
  /** Slices that come first, by their numbers. */
  readonly first: readonly number[];
  /** Called when these are there, and the others are not. */
  readonly onFirst: (gathered: Omit<Gathered, 'left' | 'counts'>) => Promise<void>;
}

const what = 'the DICOM series';

/**
 * Decodes slice after slice. Where all have the same scale, the numbers stay as they are stored; else they are brought to
 * one. Missing slices, those of damaged files, and padding are NaN.
 * @throws {VolumeViewError} `format/too-large`, `format/corrupt`, `format/unsupported`, before memory is taken
 */
export async function gatherSamples(
  { slices, resample }: Stack,
  context: Pick<ReadContext, 'budget' | 'folder' | 'onProgress'>,
  { first, onFirst }: GatherOptions,
): Promise<Gathered> {
  const { budget, folder, onProgress } = context;
  const frames = slices.filter((slice) => slice !== null);
  const damage = new DamagedFrames(frames);
  const pictures = frames.map(({ picture }) => picture);
  let libraries = await loadLibraries(pictures);
  const scale = findScale(frames);
  const [{ columns, rows }] = frames;
  const pixels = columns * rows;
  let type: StoredType = scale ? frames[0].picture.type : chooseType(frames);
  if (frames.length < slices.length || damage.found.size > 0 || resample) type = floatOf(type);
  const kept = scale ?? { slope: 1, intercept: 0 };
  const order = folder ? orderSlices(slices.length, first) : Array.from(slices, (_, k) => k);
  const isThere = (frame: Frame | null): frame is Frame => frame !== null && !damage.found.has(frame);
  const early = order.slice(0, first.length).filter((k) => isThere(slices[k])).length;
  const pixelsOf = new PixelLoader(order.map((k) => slices[k]).filter(isThere), early, context);
  const load = async (k: number): Promise<Frame | null> => {
    const frame = slices[k];
    return isThere(frame) ? pixelsOf.load(frame) : null;
  };
  const coming = readAhead(order, load, pixelsOf.ahead);
  // Files on a server count for the budget when they come.
  let next = await coming.next();
  let all = allocate(type, [columns, rows, slices.length], budget);
  const rgb = areInColors(frames) ? allocateColors(all.length, budget) : undefined;
  const counts = new NumberCounts();
  /** Only floats have a number for no data. */
  const needFloats = (): void => {
    if (floatOf(type) === type) return;
    const before = all;
    type = floatOf(type);
    all = allocate(type, [columns, rows, slices.length], budget);
    all.set(before);
    budget.giveBack(before.byteLength);
  };
  const leaveEmpty = (k: number): void => {
    needFloats();
    all.fill(NaN, k * pixels, (k + 1) * pixels);
  };
  let last: { readonly frame: Frame; readonly numbers: FrameNumbers } | null = null;
  const place = (k: number, frame: Frame): void => {
    const start = k * pixels;
    // Tiles of a mosaic share their picture.
    if (last?.frame.picture !== frame.picture || last.frame.index !== frame.index)
      last = {
        frame,
        numbers: decodeFrame(frame.picture, frame.index, budget, {
          libraries,
          rgb: rgb?.subarray(3 * start, 3 * (start + pixels)),
        }),
      };
    const numbers = cutTile(last.numbers, frame);
    const { table, slope, intercept } = frame;
    if (scale) {
      all.set(numbers, start);
      if (numbers instanceof Int16Array || numbers instanceof Uint16Array) counts.add(numbers);
    } else for (let i = 0; i < numbers.length; i++) all[start + i] = slope * lookUp(table, numbers[i]) + intercept;
    if (!frame.picture.padding) return;
    const [low, high] = frame.picture.padding;
    for (let i = 0; i < numbers.length; i++) {
      if (!(numbers[i] >= low && numbers[i] <= high)) continue;
      needFloats();
      all[start + i] = NaN;
    }
  };
  let done = 0;
  /** A server may say with the pixels how they are packed. */
  const packings = new Set(pictures.map(({ syntax }) => syntax.packing));
  const prepare = async ({ picture }: Frame): Promise<void> => {
    const { packing } = picture.syntax;
    if (packings.has(packing)) return;
    packings.add(packing);
    pictures.push(picture);
    libraries = await loadLibraries(pictures);
  };
  for (; !next.done; next = await coming.next()) {
    const loaded = next.value;
    const k = order[done];
    if (!folder) onProgress(done, slices.length);
    done++;
    try {
      if (loaded.status === 'rejected') throw loaded.reason;
      if (loaded.value) {
        await prepare(loaded.value);
        place(k, loaded.value);
      } else leaveEmpty(k);
    } catch (error) {
      damage.add(slices[k]!, error);
      leaveEmpty(k);
      // A library that met damaged pixels may have ended itself: the other slices get a new one.
      libraries = await loadLibraries(pictures);
    }
    if (done === first.length && done < order.length) await onFirst({ type, numbers: all, ...kept });
  }
  if (resample) {
    const made = allocate(type, [columns, rows, resample.length], budget);
    resampleSlices(all, made, pixels, resample);
    budget.giveBack(all.byteLength);
    all = made;
  }
  let colors = rgb;
  if (rgb && resample) {
    colors = allocateColors(all.length, budget);
    resampleSlices(rgb, colors, 3 * pixels, resample);
    budget.giveBack(bytesOfColors * (rgb.length / 3));
  }
  const isCounted = scale && (type === 'int16' || type === 'uint16');
  return { type, numbers: all, ...kept, rgb: colors, counts: isCounted ? counts : undefined, left: damage.describe() };
}

/** Frames whose files are damaged. */
class DamagedFrames {
  readonly found = new Map<Frame, Damage>();

  /** @throws {VolumeViewError} where most are damaged, or one is in a form that is not read */
  constructor(readonly all: readonly Frame[]) {
    const problems = new Map<unknown, unknown>();
    for (const frame of all) {
      const { picture } = frame;
      if (!problems.has(picture))
        problems.set(
          picture,
          findProblem(() => checkFrames(picture)),
        );
      const problem = problems.get(picture);
      if (problem) this.add(frame, problem);
    }
  }

  /** @throws the error itself where it is not that of one file, and where most are damaged */
  add(frame: Frame, error: unknown): void {
    const damage = this.all.length > 1 ? findDamage(error, frame.picture.what) : null;
    if (!damage) throw error;
    this.found.set(frame, damage);
    checkDamage([...this.found.values()], this.all.length);
  }

  describe(): string[] {
    // A file of several frames is named once.
    const files = new Map([...this.found.values()].map((damage) => [damage.what, damage]));
    return describeDamage([...files.values()], 'its place shown as no data');
  }
}

function findProblem(check: () => void): unknown {
  try {
    check();
    return null;
  } catch (error) {
    return error;
  }
}

function allocate(type: StoredType, lengths: readonly [number, number, number], budget: Budget): FrameNumbers {
  budget.take(countSampleBytes(what, lengths, numberTypes[type]), what);
  return new arrayOf[type](lengths[0] * lengths[1] * lengths[2]);
}

/** Whether the colours of all frames are known. Tiles, which share a picture, are not in colours. */
export const areInColors = (frames: readonly Frame[]): boolean =>
  frames.every(({ picture, columns, rows }) => picture.colors && columns === picture.columns && rows === picture.rows);

function allocateColors(voxels: number, budget: Budget): Uint8Array<ArrayBuffer> {
  budget.take(bytesOfColors * voxels, 'the colours of the DICOM series');
  return new Uint8Array(3 * voxels);
}

/** The scale that all frames have, with the same type of numbers; null where they differ, or have tables. */
function findScale(frames: readonly Frame[]): { readonly slope: number; readonly intercept: number } | null {
  const [first] = frames;
  const { slope, intercept } = first;
  const areAlike = frames.every(
    (frame) =>
      frame.table === null &&
      frame.slope === slope &&
      frame.intercept === intercept &&
      frame.picture.type === first.picture.type,
  );
  return areAlike ? { slope, intercept } : null;
}

/** A type that holds the values of all frames: whole numbers if they are. */
function chooseType(frames: readonly Frame[]): StoredType {
  const areWhole = frames.every(
    ({ table, slope, intercept, picture: { type, bitsStored } }) =>
      !type.startsWith('float') &&
      Number.isInteger(slope) &&
      Number.isInteger(intercept) &&
      Math.abs(slope) * (table?.largest ?? 2 ** bitsStored) + Math.abs(intercept) < 2 ** 31,
  );
  if (areWhole) return 'int32';
  return frames.some(({ picture: { type } }) => floatOf(type) === 'float64') ? 'float64' : 'float32';
}

/** The floats that hold all numbers of a type. */
export function floatOf(type: StoredType): 'float32' | 'float64' {
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

/** Where one of two slices has no data, the value between them is that of the nearer one; in a gap there is none. @param numbers - of a slice */
function resampleSlices(from: FrameNumbers, to: FrameNumbers, numbers: number, places: readonly number[]): void {
  for (const [k, place] of places.entries()) {
    if (Number.isNaN(place)) {
      to.fill(NaN, k * numbers, (k + 1) * numbers); // Colours are 0 there.
      continue;
    }
    const below = Math.floor(place);
    const share = place - below;
    for (let i = 0; i < numbers; i++) {
      const low = from[below * numbers + i];
      const high = share === 0 ? low : from[(below + 1) * numbers + i];
      const isWhole = low === low && high === high;
      to[k * numbers + i] = isWhole ? low + share * (high - low) : share < 0.5 ? low : high;
    }
  }
}
