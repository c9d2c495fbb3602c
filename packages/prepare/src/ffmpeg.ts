// The program ffmpeg of this machine, which encodes and decodes videos.
import { spawnSync } from 'node:child_process';
import { closeSync, openSync, readSync } from 'node:fs';
import { Misuse } from './misuse.ts';

export const codecs = ['vp9', 'av1'] as const;

export type Codec = (typeof codecs)[number];

/** From lossless to the worst that the codecs have. */
export const worstQuality = 63;

/** A key frame for so many frames: a view decodes from the last one before the frame that it shows. */
const framesAKey = 12;

/**
 * Without a colour space, players take the range for limited: then they change numbers where a page has no WebCodecs.
 */
const fullRange = ['pc', 'bt709', 'bt709', 'bt709'].flatMap((value, i) => [
  ['-color_range', '-colorspace', '-color_primaries', '-color_trc'][i],
  value,
]);

const encoders: Readonly<Record<Codec, string>> = { vp9: 'libvpx-vp9', av1: 'libaom-av1' };

/** @throws {Misuse} where there is no ffmpeg, or it lacks the encoder */
export function checkFfmpeg(codec: Codec): void {
  const { error, stdout } = spawnSync('ffmpeg', ['-hide_banner', '-encoders'], { encoding: 'utf8' });
  if (error)
    throw new Misuse(
      '--as video needs the program ffmpeg, which is not on the PATH; install it (apt install ffmpeg, brew install ffmpeg, winget install ffmpeg), or write mosaics',
    );
  if (!stdout.includes(encoders[codec]))
    throw new Misuse(`the ffmpeg on the PATH lacks the encoder ${encoders[codec]}; expected one that has it`);
}

/** Pictures in a file, one after another: brightness, then two planes of colour. */
export interface RawVideo {
  readonly path: string;
  readonly width: number;
  readonly height: number;
  readonly frames: number;
}

/** Bytes of a frame. */
export const bytesOfFrame = ({ width, height }: Pick<RawVideo, 'width' | 'height'>): number =>
  width * height + 2 * Math.ceil(width / 2) * Math.ceil(height / 2);

const inputOf = ({ path, width, height }: RawVideo, rate: number): string[] => [
  ...['-f', 'rawvideo', '-pix_fmt', 'yuv420p', '-s', `${width}x${height}`, '-r', `${rate}`, '-i', path],
];

/** How a video is encoded. */
export interface Encoding {
  readonly codec: Codec;
  /** The codec's crf, 1 to 63; 0 is lossless. */
  readonly quality: number;
  /** Frames a second. */
  readonly rate: number;
}

/** Writes a WebM file. Numbers are encoded as they are: nothing is converted before the encoder. */
export function encodeVideo(raw: RawVideo, out: string, { codec, quality, rate }: Encoding): void {
  const lossless = codec === 'vp9' ? ['-lossless', '1'] : ['-crf', '0', '-aom-params', 'lossless=1'];
  run([
    ...inputOf(raw, rate),
    ...['-c:v', encoders[codec], '-b:v', '0', '-g', `${framesAKey}`, '-cpu-used', '4', '-row-mt', '1'],
    ...(quality === 0 ? lossless : ['-crf', `${quality}`]),
    ...fullRange,
    ...['-fflags', '+bitexact', '-flags', '+bitexact', '-map_metadata', '-1', '-f', 'webm', out],
  ]);
}

/** Decodes a video to a file as `RawVideo` has it. */
export function decodeVideo(video: string, out: string): void {
  run(['-i', video, '-fps_mode', 'passthrough', '-f', 'rawvideo', '-pix_fmt', 'yuv420p', out]);
}

function run(options: readonly string[]): void {
  const { status, stderr } = spawnSync('ffmpeg', ['-hide_banner', '-loglevel', 'error', '-nostdin', '-y', ...options], {
    encoding: 'utf8',
  });
  if (status === 0) return;
  const why = stderr.trim().split('\n').at(-1)?.slice(0, 300);
  const error = new Error(`ffmpeg failed: ${why}`);
  throw /No space left/.test(stderr) ? Object.assign(error, { code: 'ENOSPC' }) : error;
}

/** The brightness of all frames, one after another. */
export function* readFrames(raw: RawVideo): Generator<Uint8Array> {
  const file = openSync(raw.path, 'r');
  const size = raw.width * raw.height;
  try {
    for (let frame = 0; frame < raw.frames; frame++) {
      const codes = new Uint8Array(size);
      if (readSync(file, codes, 0, size, frame * bytesOfFrame(raw)) !== size)
        throw new Error(`ffmpeg gave ${frame} of ${raw.frames} frames`);
      yield codes;
    }
  } finally {
    closeSync(file);
  }
}
