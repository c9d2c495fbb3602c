import { VolumeViewError } from '../errors.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import { combineChannels } from './channels.ts';
import type { ChannelUse } from './channels.ts';
import { NeedsMainThread } from './needs-main-thread.ts';

/** Rows that are read back at once: a 16,384-pixel mosaic then needs 16 MiB at a time, not 1 GiB. */
const rowsAtOnce = 256;

/**
 * Read a JPEG or WebP as one channel of 8 bits, by the browser's decoder without colour management. A 2D canvas
 * premultiplies, so where a WebP is transparent its values lose precision; mosaics have no use for that.
 * @throws {VolumeViewError} `format/corrupt`
 * @throws {NeedsMainThread} in a worker of an engine that has no canvas there
 */
export async function readImagePixels(
  bytes: Uint8Array<ArrayBuffer>,
  type: 'image/jpeg' | 'image/webp',
  use: ChannelUse = 'gray',
): Promise<GrayImage> {
  if (use === 'high-low' && type === 'image/jpeg') {
    throw new VolumeViewError('format/unsupported', 'channels "high-low" got a JPEG, which changes the low byte of every value; save the mosaic as PNG or lossless WebP');
  }
  if (typeof OffscreenCanvas === 'undefined' && typeof document === 'undefined') throw new NeedsMainThread();
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(new Blob([bytes], { type }), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  } catch (cause) {
    throw new VolumeViewError(
      'format/corrupt',
      `the browser can not decode this ${type} of ${bytes.length} bytes: it is damaged, cut short or too large; save or fetch it again`,
      { cause },
    );
  }
  try {
    return readBitmap(bitmap, use);
  } finally {
    bitmap.close();
  }
}

function readBitmap(bitmap: ImageBitmap, use: ChannelUse): GrayImage {
  const { width, height } = bitmap;
  const context = createContext(width, Math.min(height, rowsAtOnce));
  const data = use === 'gray' ? new Uint8Array(width * height) : new Uint16Array(width * height);
  for (let top = 0; top < height; top += rowsAtOnce) {
    const rows = Math.min(rowsAtOnce, height - top);
    context.clearRect(0, 0, width, rows);
    context.drawImage(bitmap, 0, top, width, rows, 0, 0, width, rows);
    data.set(combineChannels(context.getImageData(0, 0, width, rows).data, 4, use), top * width);
  }
  return { width, height, data };
}

function createContext(width: number, height: number): CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D {
  const settings = { willReadFrequently: true };
  const canvas: HTMLCanvasElement | OffscreenCanvas =
    typeof OffscreenCanvas === 'undefined'
      ? Object.assign(document.createElement('canvas'), { width, height })
      : new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', settings) as CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | null;
  // Safari 16.4 to 16.6 knows OffscreenCanvas in workers but gives no 2D context for some.
  if (!context) throw new NeedsMainThread();
  return context;
}
