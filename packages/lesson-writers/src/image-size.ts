// The size of an image, from its first bytes. PNG: https://www.w3.org/TR/png-3/#11IHDR. GIF: 89a specification, 18. JPEG: ITU-T T.81, B.2.2. WebP: RFC 9649, 2.

export interface ImageSize {
  readonly width: number;
  readonly height: number;
}

/** Pixels; null where the bytes are none of PNG, JPEG, WebP and GIF, or are damaged. */
export function readImageSize(bytes: Uint8Array): ImageSize | null {
  const size = findSize(new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength));
  return size && size.width > 0 && size.height > 0 ? size : null;
}

function findSize(view: DataView): ImageSize | null {
  if (view.byteLength < 30) return null;
  if (view.getUint32(0) === 0x89504e47 && view.getUint32(12) === 0x49484452)
    return { width: view.getUint32(16), height: view.getUint32(20) };
  if (view.getUint32(0) === 0x47494638) return { width: view.getUint16(6, true), height: view.getUint16(8, true) };
  if (view.getUint32(0) === 0x52494646 && view.getUint32(8) === 0x57454250) return findWebpSize(view);
  return view.getUint16(0) === 0xffd8 ? findJpegSize(view) : null;
}

function findWebpSize(view: DataView): ImageSize | null {
  switch (view.getUint32(12)) {
    case 0x56503820: // VP8: the frame has the size after its start code.
      return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
    case 0x5650384c: {
      // VP8L: 14 bits each, after one byte.
      const bits = view.getUint32(21, true);
      return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
    }
    case 0x56503858: // VP8X: 24 bits each.
      return { width: (view.getUint32(24, true) & 0xffffff) + 1, height: (view.getUint32(26, true) >>> 8) + 1 };
    default:
      return null;
  }
}

/** Segments follow each other; the one of a frame has its size. */
function findJpegSize(view: DataView): ImageSize | null {
  for (let at = 2; at + 9 <= view.byteLength;) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    const isFrame = marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
    if (isFrame) return { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
  return null;
}
