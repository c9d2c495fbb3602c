import { VolumeViewError } from '../../core/errors.ts';

/** Maximum number of pixels of an image: 2^28 are 16,384 x 16,384, the largest texture of today's devices. */
export const maxPixels = 2 ** 28;

/**
 * Maximum length of an edge, four times what browsers allow for images: a row that is one pixel wide takes as much time
 * as a wide one.
 */
const maxEdge = 2 ** 18;

/**
 * Call this before an image is unpacked.
 * @param what - 'the PNG'
 * @throws {VolumeViewError} `format/too-large`
 */
export function refusePixels(
  what: string,
  { width, height }: { readonly width: number; readonly height: number },
): void {
  const got = `${what} got ${width} x ${height} pixels`;
  if (width * height > maxPixels)
    throw new VolumeViewError('format/too-large', `${got}; expected at most ${maxPixels.toLocaleString('en')} in all`);
  if (Math.max(width, height) <= maxEdge) return;
  throw new VolumeViewError(
    'format/too-large',
    `${got}; expected at most ${maxEdge.toLocaleString('en')} on each edge. Lay the slices out in a mosaic of several columns and rows`,
  );
}
