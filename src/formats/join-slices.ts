import { VolumeViewError } from '../errors.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import { countSampleBytes } from './count-sample-bytes.ts';

export interface Slice {
  /** For messages. */
  readonly name: string;
  readonly image: GrayImage;
}

/**
 * Join images of one size into one, below one another: the mosaic of one column that a stack of slices is.
 * @param slices - `count` of them
 * @throws {VolumeViewError} `format/too-large` before anything is allocated, `format/corrupt` where they differ
 */
export async function joinSlices(slices: AsyncIterable<Slice>, count: number): Promise<GrayImage> {
  let first: Slice | null = null;
  let data: GrayImage['data'] = new Uint8Array(0);
  let at = 0;
  for await (const slice of slices) {
    const { width, height, data: pixels } = slice.image;
    if (!first) {
      first = slice;
      const type = { name: describeDepth(pixels), bytesPerSample: pixels.BYTES_PER_ELEMENT };
      const bytes = countSampleBytes('the stack of images', [width, height, count], type);
      data = pixels instanceof Uint8Array ? new Uint8Array(bytes) : new Uint16Array(bytes / 2);
    }
    checkLike(first, slice);
    data.set(pixels, at);
    at += pixels.length;
  }
  return { width: first?.image.width ?? 0, height: (first?.image.height ?? 0) * count, data };
}

function checkLike(first: Slice, slice: Slice): void {
  const [expected, got] = [describeImage(first.image), describeImage(slice.image)];
  if (got === expected) return;
  throw new VolumeViewError('format/corrupt', `the stack got ${slice.name} of ${got}; expected ${expected} as in ${first.name}: the slices of a volume are alike`);
}

function describeImage({ width, height, data }: GrayImage): string {
  return `${width} x ${height} pixels of ${describeDepth(data)}`;
}

function describeDepth(data: GrayImage['data']): string {
  return data instanceof Uint8Array ? '8 bits' : '16 bits';
}
