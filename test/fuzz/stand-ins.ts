import { noteNative } from './count-memory.ts';

// Node has no decoder of pictures and videos, and no canvas. Here is what a browser would make of a JPEG, a WebP or a frame of VP9, as far as
// the package can see it: a picture of the size that the header says, all gray, and the memory that it takes. So what is tested is what the
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

/** A frame of a video: gray, of the size that its start says. */
class Frame {
  readonly format = 'I420';
  readonly visibleRect: Size;
  readonly #bytes: number;

  constructor(
    readonly timestamp: number,
    { width, height }: Size,
  ) {
    this.visibleRect = { width, height };
    this.#bytes = width * height + 2 * Math.ceil(width / 2) * Math.ceil(height / 2);
    noteNative(this.#bytes);
  }

  allocationSize(): number {
    return this.#bytes;
  }

  async copyTo(to: Uint8Array): Promise<{ offset: number; stride: number }[]> {
    const { width, height } = this.visibleRect;
    to.fill(99, 0, width * height);
    return [{ offset: 0, stride: width }];
  }

  close(): void {
    noteNative(-this.#bytes);
  }
}

interface Chunk {
  readonly type: 'key' | 'delta';
  readonly timestamp: number;
  readonly data: Uint8Array;
}

/** As WebCodecs has it: one frame for each chunk, and an error for a chunk that is none of VP9, or before which there is no whole frame. */
class Decoder {
  state = 'unconfigured';
  decodeQueueSize = 0;
  #size: Size | null = null;

  constructor(readonly callbacks: { output: (frame: Frame) => void; error: (error: Error) => void }) {}

  static async isConfigSupported({ codec }: { codec: string }): Promise<{ supported: boolean }> {
    return { supported: codec.startsWith('vp09') };
  }

  configure(): void {
    this.state = 'configured';
  }

  addEventListener(): void {}

  decode({ type, timestamp, data }: Chunk): void {
    if (type === 'key') this.#size = findVp9Size(data);
    if (this.#size && data.length > 0) this.callbacks.output(new Frame(timestamp, this.#size));
    else this.callbacks.error(new DOMException('the chunk can not be decoded', 'EncodingError'));
  }

  async flush(): Promise<void> {}

  close(): void {
    this.state = 'closed';
  }
}

/** Of a frame that can be decoded by itself. Source: VP9 bitstream specification 0.6, 6.2 */
function findVp9Size(bytes: Uint8Array): Size | null {
  if (bytes.length < 9 || bytes[0] !== 0x82 || bytes[1] !== 0x49 || bytes[2] !== 0x83 || bytes[3] !== 0x42) return null;
  const bits =
    (bytes[4] & 15) * 2 ** 28 + bytes[5] * 2 ** 20 + bytes[6] * 2 ** 12 + bytes[7] * 2 ** 4 + (bytes[8] >> 4);
  return { width: 1 + Math.floor(bits / 2 ** 16), height: 1 + (bits % 2 ** 16) };
}

export function installStandIns(): void {
  Object.assign(globalThis, {
    VideoDecoder: Decoder,
    // `new` gives the chunk itself.
    EncodedVideoChunk: function chunkOf(chunk: Chunk) {
      return chunk;
    },
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
