import type { GrayImage } from '../../volume/mosaic.ts';
import { NeedsMainThread } from '../base/needs-main-thread.ts';
import { decodeFrame } from './decode-frame.ts';
import type { FrameAccess } from './decode-frame.ts';
import { playFrame } from './play-frame.ts';
import type { VideoTable } from './video-table.ts';

/** Whether this thread has WebCodecs. Browsers have it on https and on this computer's own pages. */
export const hasWebCodecs = (): boolean => typeof VideoDecoder !== 'undefined';

/**
 * Call this before a video is opened.
 * @throws {NeedsMainThread} where neither WebCodecs nor a page's player is there
 */
export function checkPlayer(): void {
  if (!hasWebCodecs() && typeof document === 'undefined') throw new NeedsMainThread();
}

/**
 * The brightness of one frame.
 * @throws {VolumeViewError} `format/…`; {NeedsMainThread} in a worker that can't do it
 */
export async function readFrame(video: VideoTable, frame: number, access: FrameAccess): Promise<GrayImage> {
  if (!video.isFile && hasWebCodecs()) return decodeFrame(video, frame, access);
  if (typeof document === 'undefined') throw new NeedsMainThread();
  return playFrame(video, frame, access);
}

/** What people call the codec. */
export function codecName({ codec }: VideoTable): string {
  const names: Readonly<Record<string, string>> = {
    vp09: 'VP9',
    vp8: 'VP8',
    av01: 'AV1',
    avc1: 'H.264',
    avc3: 'H.264',
  };
  return names[codec.slice(0, 4).replace(/\.$/, '')] ?? 'video';
}
