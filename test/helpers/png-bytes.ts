import { zlibSync } from 'fflate';

/** A chunk of a PNG, with any content. */
export type PngChunk = readonly [type: string, body: Uint8Array];

const ascii = (text: string): number[] => Array.from(text, (sign) => sign.charCodeAt(0));

/** A PNG of these chunks, in this order, each with its checksum, and with the end chunk. */
export function pngBytes(chunks: readonly PngChunk[]): Uint8Array<ArrayBuffer> {
  const parts = [...chunks, ['IEND', new Uint8Array(0)] as const].map(([type, body]) => {
    const chunk = new Uint8Array(12 + body.length);
    const view = new DataView(chunk.buffer);
    view.setUint32(0, body.length);
    chunk.set(ascii(type), 4);
    chunk.set(body, 8);
    view.setUint32(8 + body.length, crc32(chunk.subarray(4, 8 + body.length)));
    return chunk;
  });
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 8));
  all.set([0x89, ...ascii('PNG\r\n\x1a\n')]);
  let at = 8;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** The header chunk, which comes first. */
export function pngHeader(width: number, height: number, { depth = 8, colorType = 0, interlace = 0 } = {}): PngChunk {
  const body = new Uint8Array(13);
  const view = new DataView(body.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  body.set([depth, colorType, 0, 0, interlace], 8);
  return ['IHDR', body];
}

/** A gray picture of zeros, with other chunks between its header and its data. */
export function grayPng(width: number, height: number, between: readonly PngChunk[] = []): Uint8Array<ArrayBuffer> {
  return pngBytes([pngHeader(width, height), ...between, ['IDAT', zlibSync(new Uint8Array((width + 1) * height))]]);
}

function crc32(bytes: Uint8Array): number {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  }
  return ~sum >>> 0;
}
