import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import { Budget } from '../base/budget.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import { PartGatherer } from '../base/gather-parts.ts';

const stack = 'the stack of images';

export interface Slice {
  /** For messages. */
  readonly name: string;
  readonly image: GrayImage;
}

/**
 * Joins images of one size into one, below one another: a stack of slices becomes a mosaic of one column.
 * @param slices - `count` of them
 * @param budget - the slices' bytes are taken from it
 * @throws {VolumeViewError} `format/too-large` before anything is allocated, `format/corrupt` if their sizes differ
 */
export async function joinSlices(
  slices: AsyncIterable<Slice>,
  count: number,
  budget = new Budget(),
): Promise<GrayImage> {
  let first: Slice | null = null;
  let parts = new PartGatherer(0, stack, budget);
  const left = new Set<string>();
  for await (const slice of slices) {
    const { width, height, data: pixels } = slice.image;
    if (!first) {
      first = slice;
      const type = { name: describeDepth(pixels), bytesPerSample: pixels.BYTES_PER_ELEMENT };
      parts = new PartGatherer(countSampleBytes(stack, [width, height, count], type), stack, budget);
    }
    slice.image.left?.forEach((one) => left.add(one));
    checkLike(first, slice);
    parts.add(new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength));
  }
  const all = parts.finish();
  const data = first?.image.data instanceof Uint16Array ? new Uint16Array(all.buffer) : all;
  return {
    width: first?.image.width ?? 0,
    height: (first?.image.height ?? 0) * count,
    data,
    ...(left.size > 0 ? { left: [...left] } : {}),
  };
}

function checkLike(first: Slice, slice: Slice): void {
  const [expected, got] = [describeImage(first.image), describeImage(slice.image)];
  if (got === expected) return;
  throw new VolumeViewError(
    'format/corrupt',
    `the stack got ${slice.name} of ${got}; expected ${expected} as in ${first.name}: the slices of a volume are alike`,
  );
}

function describeImage({ width, height, data }: GrayImage): string {
  return `${width} x ${height} pixels of ${describeDepth(data)}`;
}

function describeDepth(data: GrayImage['data']): string {
  return data instanceof Uint8Array ? '8 bits' : '16 bits';
}
