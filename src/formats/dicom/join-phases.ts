// The volumes of several times, of which only the one that is shown is decoded, where the files of the others can be read later.
import { VolumeViewError } from '../../core/errors.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { chooseScan } from '../base/choose-scan.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import type { ScanFiles, SeriesInfo } from '../base/scan-data.ts';
import { areBytes, chooseLookedAt, joinValues, suggestByValues } from '../series/suggest-for-all.ts';
import { describeFiles } from './describe-files.ts';
import type { Phases } from './find-phases.ts';
import type { Frame } from './frame.ts';
import { areInColors, gatherSamples } from './gather-samples.ts';
import { cutFrames } from './cut-frames.ts';
import { countSlices, joinFrames } from './join-frames.ts';
import { listFrames } from './list-frames.ts';
import { countAtOnce } from './load-pixels.ts';
import type { Picture } from './picture.ts';
import { stackFrames } from './stack-frames.ts';
import type { Stack } from './stack-frames.ts';

/** So many slices of some times are decoded to choose one window for all. */
const sampled = 3;

/** Black and white of colours of 8 bits. */
const screen = [0, 255] as const;

/**
 * Reports the times, and decodes the one that is wanted.
 * @returns null where they have different grids, or a file can't be read again
 * @throws {VolumeViewError} as joinFrames says
 */
export async function joinPhases(
  { frames: phases, times, left }: Phases & { readonly left: readonly string[] },
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume | null> {
  const stacks = phases.map((frames) => stackFrames(frames));
  const [first] = stacks;
  if (!stacks.every((stack) => isAlike(stack, first))) return null;
  const [{ columns, rows }] = phases[0];
  const grid = cartesianGrid([columns, rows, countSlices(first)], first.indexToWorld);
  const describe = (lost: readonly string[]): SeriesInfo =>
    describeFiles({ frames: phases.flat(), left: [...left, ...first.left, ...lost] }, first.anatomical, grid);
  const files = listFiles(phases, context);
  if (!files) return null;
  // Colours look as they are, at all times.
  const isInColors = areInColors(phases.flat());
  const looks = isInColors ? [] : chooseLookedAt(phases.length).map((i) => chooseSome(stacks[i]));
  const values = await sampleValues(looks, context);
  const info = describe([]);
  const series = isInColors
    ? { ...info, window: screen }
    : values.length > 0
      ? await suggestByValues(info, values, phases.flat().every(isOfBytes))
      : info;
  const formatOf = (i: number): string => `${series.format}, volume ${i + 1} of ${phases.length}`;
  context.onScans?.(
    times,
    files.map((from, i) => {
      const [{ slope, intercept, picture }] = phases[i];
      return {
        from,
        type: picture.type,
        littleEndian: hostIsLittleEndian,
        slope,
        intercept,
        format: formatOf(i),
        series,
      };
    }),
  );
  const { index } = chooseScan(times, settings.scan!);
  const expected = [...phases[index], ...looks.flat()];
  context.folder?.expect(listUrls(expected), countBytes(expected));
  return joinFrames({ frames: phases[index], left: [] }, settings, context, { ...series, format: formatOf(index) });
}

const isOfBytes = ({ table, slope, intercept, picture: { type } }: Frame): boolean =>
  table === null && areBytes({ type, slope, intercept });

/** Whether two stacks have the same grid: times of one scan differ in nothing but their values. */
function isAlike(a: Stack, b: Stack): boolean {
  const isNear = (value: number, i: number): boolean => Math.abs(value - b.indexToWorld[i]) <= 1e-3;
  return countSlices(a) === countSlices(b) && a.indexToWorld.every(isNear);
}

/** The files of each time, or its frames in them. @returns null where a file can't be read again */
function listFiles(phases: readonly (readonly Frame[])[], { folder }: ReadContext): ScanFiles[] | null {
  const sources = new Map<Picture, (frames: readonly number[]) => ScanFile | null>();
  for (const { picture } of phases.flat()) if (!sources.has(picture)) sources.set(picture, findSource(picture, folder));
  const tiles = new Map<Picture, readonly Frame[]>();
  const all: ScanFiles[] = [];
  for (const frames of phases) {
    const parts = divideFrames(frames);
    const files: ScanFile[] = [];
    const fileOf = new Map<Frame, number>();
    for (const part of parts) {
      const file = sources.get(part[0].picture)!([...new Set(part.map(({ index }) => index))]);
      if (file === null) return null;
      for (const frame of part) fileOf.set(frame, files.length);
      files.push(file);
    }
    all.push({ files, slices: frames.map((frame) => [fileOf.get(frame)!, placeInFile(frame, tiles)]) });
  }
  return all;
}

type ScanFile = ScanFiles['files'][number];

/** What gives some frames of a picture, which are read again where they are shown; null where they can't be. */
function findSource(picture: Picture, folder: ReadContext['folder']): (frames: readonly number[]) => ScanFile | null {
  const { file, url, set, places } = picture;
  if (url !== null && (folder?.frames || places)) {
    const start = new Blob([set.bytes]);
    return (frames) =>
      places
        ? {
            file: start,
            parts: { url, ranges: frames.map((frame) => places.ranges[frame]), isPacked: places.isPacked },
            frames,
          }
        : { file: start, pixels: folder!.frames!.addressOf(url, frames), frames };
  }
  if (picture.frames > 1) return cutFrames(picture);
  const source = typeof file === 'string' ? (folder?.sourceOf(file) ?? null) : new Blob([file]);
  return () => source;
}

/** Frames of one picture that are read together: those that are had from a server by its frames are not too many. */
function divideFrames(frames: readonly Frame[]): Frame[][] {
  const open = new Map<Picture, Frame[]>();
  const parts: Frame[][] = [];
  for (const frame of frames) {
    const { picture } = frame;
    let part = open.get(picture);
    const isFull = picture.url !== null && picture.frames > 1 && part?.length === countAtOnce(picture);
    if (!part || isFull) {
      open.set(picture, (part = []));
      parts.push(part);
    }
    part.push(frame);
  }
  return parts;
}

/** Its place among the frames of its file. @param tiles - of pictures that were asked for before */
function placeInFile({ picture, index, corner }: Frame, tiles: Map<Picture, readonly Frame[]>): number {
  if (picture.frames > 1) return index;
  const mine = tiles.get(picture) ?? listFrames(picture);
  tiles.set(picture, mine);
  return mine.findIndex((tile) => tile.corner.every((at, axis) => at === corner[axis]));
}

/** Bytes that are read of files of which only some frames are. */
function countBytes(frames: readonly Frame[]): Map<string, number> {
  const bytes = new Map<string, number>();
  for (const { picture, index } of frames) {
    const { url, places, set } = picture;
    if (url === null || !places) continue;
    const { start, end } = places.ranges[index];
    bytes.set(url, (bytes.get(url) ?? set.bytes.length) + end - start);
  }
  return bytes;
}

export const listUrls = (frames: readonly Frame[]): string[] =>
  frames.map(({ picture }) => picture.url).filter((url) => url !== null);

/** Slices in equal steps over a stack. */
function chooseSome({ slices }: Stack): Frame[] {
  const there = slices.filter((slice) => slice !== null);
  const places = Array.from({ length: sampled }, (_, i) => Math.floor(((i + 0.5) * there.length) / sampled));
  return [...new Set(places)].map((k) => there[k]);
}

/** The values of some slices. What is wrong with one is said where its time is shown. */
async function sampleValues(
  looks: readonly (readonly Frame[])[],
  context: ReadContext,
): Promise<Float32Array<ArrayBuffer>> {
  const all: Float32Array[] = [];
  for (const slices of looks) {
    const some = { slices, indexToWorld: [] as never, anatomical: true, left: [] };
    try {
      const { numbers, slope, intercept } = await gatherSamples(
        some,
        { ...context, onProgress: () => {} },
        { first: [], onFirst: async () => {} },
      );
      all.push(Float32Array.from(numbers, (number) => slope * number + intercept));
      context.budget.giveBack(numbers.byteLength);
    } catch (error) {
      if (!(error instanceof VolumeViewError && error.code.startsWith('format/'))) throw error;
    }
  }
  return joinValues(all);
}
