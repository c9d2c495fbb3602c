// The way without WebCodecs, on the page alone: its own player shows the frame, and a canvas gives its pixels.
import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import { combineChannels } from '../base/channels.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FrameAccess } from './decode-frame.ts';
import type { VideoTable } from './video-table.ts';

/** Rows that are read back at once. */
const rowsAtOnce = 256;

const patienceMs = 30_000;

/** The longest time from `seeked` to the frame itself: a player may count times in another way. */
const mostWaitMs = 3000;

/**
 * Shows one frame in a `<video>` that is not in the page, and reads it back. The browser makes colours of the brightness. Of a video that says
 * its full range and its colour space Chromium changes no number; of others by up to 20 of 255, and those below 16 and above 235 become one.
 * @throws {VolumeViewError} `format/unsupported` where it can not be played, `format/corrupt`, `format/too-large`
 */
export async function playFrame(video: VideoTable, frame: number, { budget }: FrameAccess): Promise<GrayImage> {
  const { width, height } = video;
  budget.addFile(video.bytes);
  const player = document.createElement('video');
  Object.assign(player, { muted: true, playsInline: true, preload: 'auto' });
  const url = URL.createObjectURL(video.data);
  try {
    await happens(player, 'loadeddata', () => (player.src = url));
    if (player.videoWidth !== width || player.videoHeight !== height)
      throw corruptFile(
        'the video',
        `got ${player.videoWidth} x ${player.videoHeight} pixels; expected ${width} x ${height} as the file says`,
      );
    const middle = middleOf(video, frame);
    const shown = untilShown(player, video.times[frame] - video.times[0], middle);
    await happens(player, 'seeked', () => (player.currentTime = middle));
    await Promise.race([shown, new Promise((resolve) => setTimeout(resolve, mostWaitMs))]);
    budget.take(width * height + 4 * width * Math.min(height, rowsAtOnce), 'the video');
    return { width, height, data: readBack(player, video), left: [video.isFullRange ? noted : changed] };
  } finally {
    player.removeAttribute('src');
    player.load();
    URL.revokeObjectURL(url);
  }
}

const noted =
  'details: the frame was read from the player of this browser, as there is no WebCodecs here (it needs https); its colours may have changed numbers by a little';

const changed =
  'numbers of the video were changed by up to 20 of 255: there is no WebCodecs here (it needs https), and the file does not say that its numbers have the full range';

/** A time at which the frame is shown, and not the one before. */
function middleOf({ times }: VideoTable, frame: number): number {
  const next = times[frame + 1] ?? times[frame] + (frame > 0 ? times[frame] - times[frame - 1] : 0.04);
  return Math.max(0, (times[frame] + next) / 2 - times[0]);
}

/**
 * On a busy machine `seeked` comes while the player still shows the frame before. Resolves when it shows the one that was asked for; at once where a browser does not say
 * what it shows, as in a page in the background.
 * @param start, middle - of the frame, in seconds from the first one
 */
async function untilShown(player: HTMLVideoElement, start: number, middle: number): Promise<void> {
  if (!('requestVideoFrameCallback' in player) || document.hidden) return;
  const next = (): Promise<number> =>
    new Promise((resolve) => player.requestVideoFrameCallback((_, { mediaTime }) => resolve(mediaTime)));
  while (Math.abs((await next()) - start) > middle - start);
}

async function happens(player: HTMLVideoElement, event: string, begin: () => void): Promise<void> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  try {
    await new Promise<void>((resolve, reject) => {
      const refuse = (): void =>
        reject(
          unsupportedFile(
            'the video',
            'can not be played: it is damaged, this browser has neither WebCodecs nor its codec, or the policy of the page forbids it (media-src blob:)',
          ),
        );
      player.addEventListener(event, () => resolve(), { once: true });
      player.addEventListener('error', refuse, { once: true });
      timer = setTimeout(refuse, patienceMs);
      begin();
    });
  } finally {
    clearTimeout(timer);
  }
}

function readBack(player: HTMLVideoElement, { width, height }: VideoTable): Uint8Array<ArrayBuffer> {
  const canvas = Object.assign(document.createElement('canvas'), { width, height: Math.min(height, rowsAtOnce) });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new VolumeViewError('format/unsupported', 'the video needs a canvas, which this browser lacks');
  const data = new Uint8Array(width * height);
  for (let top = 0; top < height; top += rowsAtOnce) {
    const rows = Math.min(rowsAtOnce, height - top);
    context.drawImage(player, 0, top, width, rows, 0, 0, width, rows);
    const pixels = context.getImageData(0, 0, width, rows).data;
    data.set(combineChannels(pixels, 4, 'gray'), top * width);
  }
  return data;
}
