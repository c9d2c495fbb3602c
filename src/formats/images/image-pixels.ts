import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import { combineChannels, describeLoss } from '../base/channels.ts';
import type { ChannelUse } from '../base/channels.ts';
import type { ImageSettings } from '../base/format.ts';
import { readImageSize } from './image-size.ts';
import type { ImageSize, ImageType } from './image-size.ts';
import { NeedsMainThread } from '../base/needs-main-thread.ts';
import { refusePixels } from './max-pixels.ts';

/** Rows that are read back at once: a 16,384-pixel mosaic then needs 16 MiB at a time, not 1 GiB. */
const rowsAtOnce = 256;

/**
 * Reads a JPEG or WebP as one channel of 8 bits, with the browser's decoder and without colour management. A 2D canvas
 * premultiplies, so a transparent WebP loses precision; mosaics do not use transparency. The size in the file's header
 * is checked before the browser allocates it, and the decoded image is checked against it.
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 * @throws {NeedsMainThread} in a worker of a browser that has no canvas there
 */
export async function readImagePixels(
  bytes: Uint8Array<ArrayBuffer>,
  type: ImageType,
  { channels: use = 'gray', budget }: ImageSettings,
): Promise<GrayImage> {
  if (use === 'high-low' && type === 'image/jpeg') {
    throw new VolumeViewError(
      'format/unsupported',
      'channels "high-low" got a JPEG, which changes the low byte of every value; save the mosaic as PNG or lossless WebP',
    );
  }
  const size = readImageSize(bytes, type);
  const pixels = size.width * size.height;
  refusePixels(`the ${type}`, size);
  // The browser's bitmap of four bytes a pixel, the rows that are read back, and one number per pixel, which stays.
  const passing = 4 * (pixels + size.width * Math.min(size.height, rowsAtOnce));
  budget.take(passing + pixels * (use === 'gray' ? 1 : 2), `the ${type}`);
  if (typeof OffscreenCanvas === 'undefined' && typeof document === 'undefined') throw new NeedsMainThread();
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(new Blob([bytes], { type }), {
      colorSpaceConversion: 'none',
      premultiplyAlpha: 'none',
    });
  } catch (cause) {
    throw new VolumeViewError(
      'format/corrupt',
      `the browser can not decode this ${type} of ${bytes.length} bytes: it is damaged, cut short or too large; save or fetch it again`,
      { cause },
    );
  }
  try {
    checkSize(bitmap, size, type);
    return readBitmap(bitmap, use);
  } finally {
    bitmap.close();
    budget.giveBack(passing);
  }
}

/** The browser rotates a JPEG whose header says that it lies on its side. */
function checkSize({ width, height }: ImageBitmap, said: ImageSize, type: ImageType): void {
  if ((width === said.width && height === said.height) || (width === said.height && height === said.width)) return;
  throw new VolumeViewError(
    'format/corrupt',
    `this ${type} got ${width} x ${height} pixels; expected ${said.width} x ${said.height} as its header says; save it again`,
  );
}

function readBitmap(bitmap: ImageBitmap, use: ChannelUse): GrayImage {
  const { width, height } = bitmap;
  const context = createContext(width, Math.min(height, rowsAtOnce));
  const data = use === 'gray' ? new Uint8Array(width * height) : new Uint16Array(width * height);
  const left = new Set<string>();
  for (let top = 0; top < height; top += rowsAtOnce) {
    const rows = Math.min(rowsAtOnce, height - top);
    context.clearRect(0, 0, width, rows);
    context.drawImage(bitmap, 0, top, width, rows, 0, 0, width, rows);
    const pixels = context.getImageData(0, 0, width, rows).data;
    if (use === 'gray') describeLoss(pixels, 4).forEach((loss) => left.add(loss));
    data.set(combineChannels(pixels, 4, use), top * width);
  }
  return { width, height, data, ...(left.size > 0 ? { left: [...left] } : {}) };
}

function createContext(width: number, height: number): CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D {
  const settings = { willReadFrequently: true };
  const canvas: HTMLCanvasElement | OffscreenCanvas =
    typeof OffscreenCanvas === 'undefined'
      ? Object.assign(document.createElement('canvas'), { width, height })
      : new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', settings) as
    | CanvasRenderingContext2D
    | OffscreenCanvasRenderingContext2D
    | null;
  // Safari 16.4 to 16.6 has OffscreenCanvas in workers but gives no 2D context for some.
  if (!context) throw new NeedsMainThread();
  return context;
}
