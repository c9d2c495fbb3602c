import { noteNative } from './count-memory.ts';

// Node has no decoder of pictures and no canvas. Here is what a browser would make of a JPEG or a WebP, as far as the package can
// see it: a picture of the size that the header says, all gray, and the memory that it takes. So what is tested is what the
// package itself does before and after; the browsers' decoders are not.

interface Size {
  readonly width: number;
  readonly height: number;
}

class Bitmap implements Size {
  constructor(
    readonly width: number,
    readonly height: number,
  ) {
    noteNative(4 * width * height);
  }

  close(): void {
    noteNative(-4 * this.width * this.height);
  }
}

class Canvas {
  constructor(
    readonly width: number,
    readonly height: number,
  ) {}

  getContext(): object {
    return {
      clearRect: () => undefined,
      drawImage: () => undefined,
      getImageData: (_x: number, _y: number, width: number, height: number) => ({
        data: new Uint8ClampedArray(4 * width * height).fill(99),
      }),
    };
  }
}

export function installStandIns(): void {
  Object.assign(globalThis, {
    OffscreenCanvas: Canvas,
    createImageBitmap: async (blob: Blob) => {
      const bytes = new Uint8Array(await blob.arrayBuffer());
      const size = blob.type === 'image/jpeg' ? findJpegSize(bytes) : findWebpSize(bytes);
      if (!size || !(size.width > 0 && size.height > 0))
        throw new DOMException('the picture can not be decoded', 'InvalidStateError');
      return new Bitmap(size.width, size.height);
    },
  });
}

/** The size in the first start of a frame, up to the scan. Source: ITU-T T.81, B.1 and B.2 */
function findJpegSize(bytes: Uint8Array): Size | null {
  const u16 = (at: number): number => (bytes[at] << 8) | bytes[at + 1];
  for (let at = 2; at + 8 < bytes.length;) {
    if (bytes[at] !== 0xff) return null;
    const marker = bytes[at + 1];
    if (marker === 0xff || (marker >= 0xd0 && marker <= 0xd7) || marker === 0x01) at += marker === 0xff ? 1 : 2;
    else if (marker === 0xda || marker === 0xd9) return null;
    else if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker))
      return { width: u16(at + 7), height: u16(at + 5) };
    else at += 2 + Math.max(2, u16(at + 2));
  }
  return null;
}

/** The size of the first frame, lossy or not; what holds the size of an animation or of a picture with alpha wins. Source: WebP container specification */
function findWebpSize(bytes: Uint8Array): Size | null {
  const u24 = (at: number): number => bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16);
  const name = String.fromCharCode(...bytes.subarray(12, 16));
  if (bytes.length < 30) return null;
  if (name === 'VP8X') return { width: 1 + u24(24), height: 1 + u24(27) };
  if (name === 'VP8L' && bytes[20] === 0x2f) {
    const bits = u24(21) + bytes[24] * 2 ** 24;
    return { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff) };
  }
  if (name === 'VP8 ' && bytes[23] === 0x9d)
    return { width: (bytes[26] | (bytes[27] << 8)) & 0x3fff, height: (bytes[28] | (bytes[29] << 8)) & 0x3fff };
  return null;
}
