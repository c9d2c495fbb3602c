// Scans in time in several forms of files: their bytes, and how far their values and their picture are from those of the scans.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { bytesOfFrame, decodeVideo, encodeVideo, readFrames } from '../../../packages/prepare/src/ffmpeg.ts';
import type { Codec } from '../../../packages/prepare/src/ffmpeg.ts';
import { storeOfFile } from '../../../packages/prepare/src/folder-store.ts';
import { comparePictures } from '../../../src/prepare/compare-pictures.ts';
import { encodeValues, LossySum, ValueRange } from '../../../src/prepare/video-codes.ts';
import { readVideoScans } from '../../../src/prepare/video-scans.ts';
import type { VideoScan } from '../../../src/prepare/video-scans.ts';

export interface FormResult {
  readonly form: string;
  /** Of all scans. */
  readonly bytes: number;
  /** In data values. */
  readonly error: { readonly rms: number; readonly p99: number; readonly max: number };
  /** Of one scan in the middle, root mean square, 1/255. */
  readonly picture: number;
}

/** Pixels across of the picture that is compared. */
const pictureSize = 64;

function ffmpeg(...options: string[]): void {
  const { status, stderr } = spawnSync('ffmpeg', ['-loglevel', 'error', '-nostdin', '-y', ...options], {
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(`ffmpeg failed: ${stderr}`);
}

/** What a form makes of the frames: its bytes, and the frames that come back. */
type Form = (frames: readonly Uint8Array[]) => { readonly bytes: number; readonly decoded: readonly Uint8Array[] };

/** A form with a file for each frame. @param ending - of the files @param options - of the encoder @param back - from its pixels to gray ones */
function imagesAs(
  ending: string,
  { options, back = [] }: { readonly options: readonly string[]; readonly back?: readonly string[] },
  { work, width, height }: { readonly work: string; readonly width: number; readonly height: number },
): Form {
  return (frames) => {
    let bytes = 0;
    const [raw, image, again] = ['in.gray', `image.${ending}`, 'out.gray'].map((name) => join(work, name));
    const decoded = frames.map((frame) => {
      writeFileSync(raw, frame);
      ffmpeg(
        ...['-f', 'rawvideo', '-pix_fmt', 'gray', '-color_range', 'pc', '-s', `${width}x${height}`, '-i', raw],
        ...options,
        image,
      );
      bytes += statSync(image).size;
      ffmpeg('-i', image, ...back, '-f', 'rawvideo', '-pix_fmt', 'gray', again);
      return new Uint8Array(readFileSync(again));
    });
    return { bytes, decoded };
  };
}

function videoAs(
  codec: Codec,
  quality: number,
  size: { readonly work: string; readonly width: number; readonly height: number },
): Form {
  return (frames) => {
    const { work, width, height } = size;
    const raw = { path: join(work, 'raw.yuv'), width, height, frames: frames.length };
    const chroma = new Uint8Array(bytesOfFrame(raw) - width * height).fill(128);
    writeFileSync(raw.path, Buffer.concat(frames.flatMap((frame) => [frame, chroma])));
    const [video, decoded] = [join(work, 'video.webm'), join(work, 'decoded.yuv')];
    encodeVideo(raw, video, { codec, quality, rate: 5 });
    decodeVideo(video, decoded);
    return { bytes: statSync(video).size, decoded: [...readFrames({ ...raw, path: decoded })] };
  };
}

/** WebP has colours: of equal ones, one is the brightness. */
const fromColors = ['-vf', 'format=gbrp,extractplanes=g'];

/** @param paths - of scans in the order of time, or of one file of several volumes */
export async function compareForms(paths: readonly string[], moment?: string): Promise<readonly FormResult[]> {
  const scans: VideoScan[] = [];
  for (const path of paths) {
    const { store, url } = storeOfFile(resolve(path));
    for await (const scan of readVideoScans(store, { first: url, phase: 1 }, { moment, deviceBytes: 2 ** 30 }))
      scans.push(scan);
  }
  const work = mkdtempSync(join(tmpdir(), 'volume-view-bench-video-'));
  try {
    const size = { work, width: scans[0].width, height: scans[0].height };
    const forms: readonly (readonly [name: string, isLossy: boolean, form: Form])[] = [
      ['PNG', false, imagesAs('png', { options: ['-compression_level', '9', '-pred', 'mixed'] }, size)],
      [
        'WebP, lossless',
        false,
        imagesAs('webp', { options: ['-lossless', '1', '-compression_level', '6'], back: fromColors }, size),
      ],
      ['VP9, lossless', false, videoAs('vp9', 0, size)],
      ['AV1, lossless', false, videoAs('av1', 0, size)],
      ...[90, 60].map(
        (quality) =>
          [
            `WebP, quality ${quality}`,
            true,
            imagesAs('webp', { options: ['-quality', `${quality}`], back: fromColors }, size),
          ] as const,
      ),
      ...(['vp9', 'av1'] as const).flatMap((codec) =>
        [12, 24, 36].map(
          (quality) => [`${codec.toUpperCase()}, crf ${quality}`, true, videoAs(codec, quality, size)] as const,
        ),
      ),
    ];
    const results: FormResult[] = [];
    for (const [form, isLossy, make] of forms) results.push({ form, ...(await measure(scans, isLossy, make)) });
    return results;
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

async function measure(scans: readonly VideoScan[], isLossy: boolean, make: Form): Promise<Omit<FormResult, 'form'>> {
  const range = new ValueRange();
  for (const { values, step } of scans) range.add(values, step);
  const scale = range.scale(isLossy);
  const { bytes, decoded } = make(scans.map(({ values }) => encodeValues(values, scale)));
  const sum = new LossySum(scale);
  scans.forEach(({ values }, i) => sum.add(values, decoded[i]));
  const middle = scans.length >> 1;
  const { volume, isRadar, manifest, width, height } = scans[middle];
  const { slope, intercept, noDataBelow } = scale;
  const data = decoded[middle].map((code) => (code < noDataBelow ? 0 : code));
  const own = { ...manifest, slope, intercept, ...(noDataBelow > 0 && !isRadar ? { noData: 0 } : {}) };
  const { rms } = await comparePictures(volume, { width, height, data }, own, pictureSize);
  return { bytes, error: sum.error, picture: rms };
}
