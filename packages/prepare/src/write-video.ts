// Writes scans in time as a video, each frame of which is a mosaic, and its manifest.
import { mkdtempSync, openSync, writeSync, closeSync, rmSync, statSync, writeFileSync, copyFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { readScanTime } from '../../../src/core/scan-time.ts';
import type { Source } from '../../../src/prepare/find-sources.ts';
import { comparePictures } from '../../../src/prepare/compare-pictures.ts';
import { encodeValues, LossySum, unused, ValueRange } from '../../../src/prepare/video-codes.ts';
import type { CodeScale, Lossy, LossyError } from '../../../src/prepare/video-codes.ts';
import { readVideoScans } from '../../../src/prepare/video-scans.ts';
import type { VideoScan } from '../../../src/prepare/video-scans.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { bytesOfFrame, checkFfmpeg, decodeVideo, encodeVideo, readFrames, worstQuality } from './ffmpeg.ts';
import type { Codec, RawVideo } from './ffmpeg.ts';
import { storeOfFile } from './folder-store.ts';
import { formatManifest } from './format-manifest.ts';
import { Misuse } from './misuse.ts';
import { nameFiles } from './name-files.ts';

export interface VideoOptions {
  readonly codec: Codec;
  /** Root mean square that may be left, in data values; 0 is lossless except the 8 bits. */
  readonly error: number;
}

export interface VideoRequest extends VideoOptions {
  /** In the order of time: each one scan, or one source of several. */
  readonly sources: readonly { readonly store: ByteStore; readonly source: Source }[];
  readonly moment?: string;
  readonly deviceBytes: number;
  /** Scans that would have to be made smaller make no video. */
  readonly isWhole?: boolean;
}

/** The error for scans that do not make one video. */
export class NoVideo extends Misuse {}

/** What was made. */
export interface MadeVideo {
  /** Path of the WebM. */
  readonly video: string;
  readonly bytes: number;
  /** Without the name of the video. */
  readonly manifest: object;
  readonly scans: readonly VideoScan['report'][];
  readonly unit: string;
  readonly lossy: Lossy;
  /** The share of places that have data before or after alone. */
  readonly changed: number;
  /** crf of the codec; 0 is lossless. */
  readonly quality: number;
}

/** The pictures that are compared: so many frames, pixels across. */
const comparedFrames = 3;
const comparedSize = 64;

/**
 * Writes NAME.webm and NAME.json.
 * @param paths - files of scans in the order of time, or one file of several volumes
 * @param out - path of the files without their endings; named after the first file if undefined
 * @throws {Misuse} where there is no ffmpeg, or the scans do not make one video
 * @throws {VolumeViewError} where a file can't be read
 */
export async function writeVideo(
  paths: readonly string[],
  options: Omit<VideoRequest, 'sources'>,
  out = nameFiles(paths[0]),
): Promise<MadeVideo & { readonly name: string }> {
  checkFfmpeg(options.codec);
  const work = mkdtempSync(join(tmpdir(), 'volume-view-video-'));
  try {
    const sources = paths.map((path) => {
      const { store, url } = storeOfFile(resolve(path));
      return { store, source: { first: url, phase: 1 } as const };
    });
    const made = await makeVideo({ ...options, sources }, work);
    copyFileSync(made.video, `${out}.webm`);
    writeFileSync(`${out}.json`, formatManifest({ video: `${basename(out)}.webm`, ...made.manifest }));
    return { ...made, name: out };
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

/**
 * Makes a video of scans.
 * @param work - a folder for what is large, which the caller removes
 * @throws {NoVideo} where the scans do not make one
 * @throws {VolumeViewError} where a source can't be read, or can be no video
 */
export async function makeVideo(request: VideoRequest, work: string): Promise<MadeVideo> {
  const { codec } = request;
  const { scans, manifests, scale, raw, times, rounding, isUnused } = await writeRaw(request, join(work, 'raw.yuv'));
  // What 8 bits change adds to what the codec changes, as the two have nothing to do with each other.
  const target = Math.sqrt(Math.max(0, request.error ** 2 - rounding ** 2));
  const rate = rateOf(times);
  const made = await chooseQuality(target, { raw, scale, isUnused }, (quality) => {
    const video = join(work, 'video.webm');
    encodeVideo(raw, video, { codec, quality, rate });
    const decoded = { ...raw, path: join(work, 'decoded.yuv') };
    decodeVideo(video, decoded.path);
    if (statSync(decoded.path).size !== raw.frames * bytesOfFrame(raw)) throw new Error('ffmpeg left out frames');
    return { video, decoded };
  });
  const { lossy, changed } = await measure(request, made.decoded, scale, manifests);
  return {
    video: made.video,
    bytes: statSync(made.video).size,
    manifest: { ...joinManifests(manifests, scale, times), lossy },
    scans,
    unit: typeof manifests[0].unit === 'string' ? manifests[0].unit : '',
    lossy,
    changed,
    quality: made.quality,
  };
}

/** All scans of the sources, one after another. */
async function* readScans({ sources, moment, deviceBytes }: VideoRequest): AsyncGenerator<VideoScan> {
  for (const { store, source } of sources) yield* readVideoScans(store, source, { moment, deviceBytes });
}

/** Writes all frames as the encoder takes them. */
async function writeRaw(
  request: VideoRequest,
  path: string,
): Promise<{
  readonly scans: readonly VideoScan['report'][];
  readonly manifests: readonly VideoScan['manifest'][];
  readonly times: readonly (string | null)[];
  readonly scale: CodeScale;
  readonly raw: RawVideo;
  /** Root mean square of what 8 bits change. */
  readonly rounding: number;
  /** For each pixel whether it is no place of the volume. */
  readonly isUnused: Uint8Array;
}> {
  const range = new ValueRange();
  const scans: VideoScan['report'][] = [];
  const manifests: VideoScan['manifest'][] = [];
  const times: (string | null)[] = [];
  let size: { readonly width: number; readonly height: number } | null = null;
  for await (const { width, height, values, step, manifest, time, report } of readScans(request)) {
    size ??= { width, height };
    if (request.isWhole && report.from)
      throw new NoVideo(`got ${report.from.join(' x ')} voxels, which are too many for the picture of a video`);
    if (width !== size.width || height !== size.height || manifest.mosaic !== (manifests[0] ?? manifest).mosaic)
      throw new NoVideo(
        `scan ${manifests.length + 1} makes a picture of ${width} x ${height} pixels, and those before ${size.width} x ${size.height}; expected scans of one size`,
      );
    range.add(values, step);
    scans.push(report);
    manifests.push(manifest);
    times.push(time);
  }
  if (!size || manifests.length < 2)
    throw new NoVideo('got one scan; expected several in time: a file of several volumes, or several files');
  checkOrder(times);
  const scale = range.scale(request.error > 0);
  const sum = new LossySum(scale);
  let isUnused = new Uint8Array();
  const file = openSync(path, 'w');
  try {
    const gray = new Uint8Array(bytesOfFrame(size) - size.width * size.height).fill(128);
    for await (const { values } of readScans(request)) {
      if (isUnused.length === 0) isUnused = Uint8Array.from(values, (value) => (value === unused ? 1 : 0));
      const codes = encodeValues(values, scale);
      sum.add(values, codes);
      writeWhole(file, codes);
      writeWhole(file, gray);
    }
  } finally {
    closeSync(file);
  }
  return {
    scans,
    manifests,
    times,
    scale,
    raw: { path, ...size, frames: manifests.length },
    rounding: sum.error.rms,
    isUnused,
  };
}

/** A disk may take less at once. */
function writeWhole(file: number, bytes: Uint8Array): void {
  for (let at = 0; at < bytes.length;) at += writeSync(file, bytes, at);
}

function checkOrder(times: readonly (string | null)[]): void {
  const known = times.flatMap((time) => (time === null ? [] : [readScanTime(time)?.value ?? 0]));
  if (known.some((time, i) => i > 0 && time < known[i - 1]))
    throw new NoVideo('got scans that are not in the order of time; expected the files in that order');
}

/** Frames a second: those of the scans where they count seconds, else 5. It only matters for other players. */
function rateOf([first, second]: readonly (string | null)[]): number {
  const [from, to] = [first, second].map((time) => (time ? readScanTime(time) : null));
  const step = from && to && from.unit === 's' ? to.value - from.value : 0;
  return step > 0.001 && step < 100 ? 1 / step : 5;
}

interface Encoded {
  readonly video: string;
  readonly decoded: RawVideo;
}

/** Frames before they are encoded. */
interface Uncoded {
  readonly raw: RawVideo;
  readonly scale: CodeScale;
  readonly isUnused: Uint8Array;
}

/** The worst quality whose error is small enough, by encoding and measuring. */
async function chooseQuality(
  error: number,
  frames: Uncoded,
  encode: (quality: number) => Encoded,
): Promise<Encoded & { readonly quality: number }> {
  if (error === 0) return { ...encode(0), quality: 0 };
  let [good, bad] = [0, worstQuality + 1];
  while (bad - good > 1) {
    const quality = (good + bad) >> 1;
    if (codecError(frames, encode(quality).decoded) <= error) good = quality;
    else bad = quality;
  }
  return { ...encode(good), quality: good };
}

/** Root mean square of what the codec alone changes, in data values. */
function codecError({ raw, scale, isUnused }: Uncoded, decoded: RawVideo): number {
  const { slope, intercept, noDataBelow } = scale;
  const sum = new LossySum(scale);
  const after = readFrames(decoded);
  for (const codes of readFrames(raw)) {
    const before = Float64Array.from(codes, (code, i) =>
      isUnused[i] ? unused : code < noDataBelow ? NaN : slope * code + intercept,
    );
    sum.add(before, after.next().value as Uint8Array);
  }
  return sum.error.rms;
}

/** The difference from the values of the files, and of a few pictures. */
async function measure(
  request: VideoRequest,
  decoded: RawVideo,
  scale: CodeScale,
  manifests: readonly VideoScan['manifest'][],
): Promise<{ readonly lossy: Lossy; readonly changed: number }> {
  const sum = new LossySum(scale);
  const shown = new Set(
    Array.from({ length: comparedFrames }, (_, i) => Math.round((i * (decoded.frames - 1)) / (comparedFrames - 1))),
  );
  const pictures: LossyError[] = [];
  const frames = readFrames(decoded);
  let [frame, count] = [0, 0];
  for await (const { values, volume, isRadar, manifest, width, height } of readScans(request)) {
    const codes = frames.next().value as Uint8Array<ArrayBuffer>;
    sum.add(values, codes);
    count += values.reduce((sum, value) => sum + (value === unused ? 0 : 1), 0);
    if (shown.has(frame++)) {
      const image = { width, height, data: codes.map((code) => (code < scale.noDataBelow ? 0 : code)) };
      const own = { ...manifests[0], ...manifest, ...scaleFields(scale, isRadar) };
      pictures.push(await comparePictures(volume, image, own, comparedSize));
    }
  }
  const largest = (name: keyof LossyError): number => Math.max(...pictures.map((one) => one[name]));
  const short = (value: number): number => Number(value.toPrecision(4));
  const { rms, p99, max } = sum.error;
  return {
    lossy: {
      ...{ rms: short(rms), p99: short(p99), max: short(max) },
      picture: { rms: short(largest('rms')), p99: short(largest('p99')), max: short(largest('max')) },
    },
    changed: sum.changed / count,
  };
}

/** How the codes are data values. */
function scaleFields({ slope, intercept, noDataBelow }: CodeScale, isRadar: boolean): object {
  return { slope, intercept, ...(noDataBelow > 0 && !isRadar ? { noData: 0 } : {}) };
}

/** What all frames have in common, and what each has for itself. */
function joinManifests(
  manifests: readonly VideoScan['manifest'][],
  { slope, intercept, noDataBelow }: CodeScale,
  times: readonly (string | null)[],
): object {
  const [first] = manifests;
  const names = [...new Set(manifests.flatMap((one) => Object.keys(one)))];
  // One window for all times.
  const isCommon = (name: string): boolean =>
    name === 'window' || manifests.every((one) => JSON.stringify(one[name]) === JSON.stringify(first[name]));
  const common = Object.fromEntries(names.filter(isCommon).map((name) => [name, first[name]]));
  const scans = manifests.map((one, i) => ({
    ...(times[i] === null ? {} : { time: times[i] }),
    ...Object.fromEntries(
      names.filter((name) => !isCommon(name) && one[name] !== undefined).map((name) => [name, one[name]]),
    ),
  }));
  return {
    ...common,
    slope,
    intercept,
    ...(noDataBelow > 0 ? { noDataBelow } : {}),
    scans,
  };
}
