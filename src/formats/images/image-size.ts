import { VolumeViewError } from '../../core/errors.ts';

// The size in the header of a JPEG or a WebP. It is checked before the browser decodes the image, because a browser
// allocates whatever the header says.

export type ImageType = 'image/jpeg' | 'image/webp';

export interface ImageSize {
  readonly width: number;
  readonly height: number;
}

/** @throws {VolumeViewError} `format/corrupt` if the file has no size */
export function readImageSize(bytes: Uint8Array<ArrayBuffer>, type: ImageType): ImageSize {
  const size = type === 'image/jpeg' ? findJpegSize(bytes) : findWebpSize(bytes);
  if (size && size.width > 0 && size.height > 0) return size;
  const got = size ? `a size of ${size.width} x ${size.height}` : 'no size';
  throw new VolumeViewError(
    'format/corrupt',
    `this ${type} of ${bytes.length} bytes got ${got} in its header: it is damaged or cut short; save or fetch it again`,
  );
}

/**
 * Markers that begin a frame: 0xC0 to 0xCF, except those of tables and of arithmetic coding. Source: ITU-T T.81, table
 * B.1.
 */
const isFrame = (marker: number): boolean =>
  marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;

/** Walks through marker segments, each with its length, up to the first frame. */
function findJpegSize(bytes: Uint8Array<ArrayBuffer>): ImageSize | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 2; at + 9 <= bytes.length;) {
    // Between segments decoders skip anything that is not a marker.
    if (bytes[at] !== 0xff || bytes[at + 1] === 0xff || bytes[at + 1] === 0) {
      at++;
      continue;
    }
    const marker = bytes[at + 1];
    if (isFrame(marker)) return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    const isAlone = marker === 1 || (marker >= 0xd0 && marker <= 0xd9);
    at += isAlone ? 2 : 2 + Math.max(2, view.getUint16(at + 2));
  }
  return null;
}

/**
 * The first chunk has the size: of the picture, or of the canvas that it lies on. Source: RFC 9649, sections 2.5 to 2.7
 * and 3.4.
 */
function findWebpSize(bytes: Uint8Array<ArrayBuffer>): ImageSize | null {
  if (bytes.length < 30) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const threeBytes = (at: number): number => view.getUint16(at, true) + 65536 * bytes[at + 2];
  switch (String.fromCharCode(...bytes.subarray(12, 16))) {
    case 'VP8 ':
      return threeBytes(23) === 0x2a019d
        ? { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff }
        : null;
    case 'VP8L': {
      const bits = view.getUint32(21, true);
      return bytes[20] === 0x2f ? { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff) } : null;
    }
    case 'VP8X':
      return { width: 1 + threeBytes(24), height: 1 + threeBytes(27) };
    default:
      return null;
  }
}
