import { loadReader } from '../base/load-reader.ts';
import { corruptPng } from './png-chunks.ts';
import type { PngHeader, PngParts } from './png-chunks.ts';

/** Packed bytes per piece. A piece unpacks to at most 1,032 times as many, and unpacking ends when the picture is full. */
const pieceBytes = 2 ** 14;

/** In an interlaced file every n-th pixel of the picture forms a picture of its own, a pass. */
interface Pass {
  readonly x: number;
  readonly y: number;
  readonly xStep: number;
  readonly yStep: number;
}

const wholePicture: readonly Pass[] = [{ x: 0, y: 0, xStep: 1, yStep: 1 }];

/** Source: the PNG specification, section 8.2, "Adam7". */
const interlacedPasses: readonly Pass[] = [
  { x: 0, y: 0, xStep: 8, yStep: 8 },
  { x: 4, y: 0, xStep: 8, yStep: 8 },
  { x: 0, y: 4, xStep: 4, yStep: 8 },
  { x: 2, y: 0, xStep: 4, yStep: 4 },
  { x: 0, y: 2, xStep: 2, yStep: 4 },
  { x: 1, y: 0, xStep: 2, yStep: 2 },
  { x: 0, y: 1, xStep: 1, yStep: 2 },
];

/** Bytes of one row of the picture. */
export function bytesPerRow({ width, depth, channels }: PngHeader): number {
  return Math.ceil((width * channels * depth) / 8);
}

/**
 * Unpacks a picture into its rows with the browser's own decompressor. If that finds damage, our own decoder repeats
 * it: a picture that is complete before the damage is still read. The function never holds more than the picture,
 * whatever the packed data would unpack to.
 * @param packed - in one piece
 * @returns `bytesPerRow` * height bytes, 16-bit numbers in PNG's own order, the high byte first
 * @throws {VolumeViewError} `format/corrupt`
 */
export async function unpackRows(
  { header }: Pick<PngParts, 'header'>,
  packed: Uint8Array<ArrayBuffer>,
): Promise<Uint8Array<ArrayBuffer>> {
  let picture = new RowWriter(header);
  try {
    await unpack(packed, picture);
  } catch {
    const { unpackDamaged } = await loadReader(() => import('./unpack-damaged.ts'));
    picture = new RowWriter(header, picture.data);
    unpackDamaged(packed, picture, pieceBytes);
  }
  if (!picture.isFull) throw corruptPng('ends early');
  return picture.data;
}

async function unpack(packed: Uint8Array<ArrayBuffer>, picture: RowWriter): Promise<void> {
  const reader = pieces(packed).pipeThrough(new DecompressionStream('deflate')).getReader();
  try {
    while (!picture.isFull) {
      const { done, value } = await reader.read();
      if (done) return;
      picture.take(value);
    }
  } finally {
    await reader.cancel().catch(() => undefined);
  }
}

/** Yields bytes piece by piece, each when the reader asks for it. */
function pieces(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream(
    {
      pull(controller) {
        if (at >= bytes.length) return controller.close();
        controller.enqueue(bytes.subarray(at, (at += pieceBytes)));
      },
    },
    { highWaterMark: 0 },
  );
}

/** Receives unpacked bytes, and puts the rows that they make in their places. */
class RowWriter {
  readonly #header: PngHeader;
  /** Bytes from a pixel to the next, at least one. */
  readonly #step: number;
  readonly #passes: Pass[];
  #pass: Pass = wholePicture[0];
  #rows = 0;
  /** Row of the pass. */
  #row = 0;
  /** The filter's number, then the row as it is packed. */
  #line = new Uint8Array(0);
  #filled = 0;
  #above = new Uint8Array(0);
  #isFull = false;

  /** @param data - bytes of all rows, which are overwritten */
  constructor(
    header: PngHeader,
    readonly data = new Uint8Array(bytesPerRow(header) * header.height),
  ) {
    this.#header = header;
    this.#step = Math.max(1, (header.depth * header.channels) / 8);
    this.#passes = [...(header.isInterlaced ? interlacedPasses : wholePicture)];
    this.#beginPass();
  }

  get isFull(): boolean {
    return this.#isFull;
  }

  take(piece: Uint8Array): void {
    for (let at = 0; at < piece.length && !this.#isFull;) {
      const part = piece.subarray(at, at + this.#line.length - this.#filled);
      this.#line.set(part, this.#filled);
      this.#filled += part.length;
      at += part.length;
      if (this.#filled === this.#line.length) this.#endRow();
    }
  }

  /** Goes to the next pass that has any pixels. */
  #beginPass(): void {
    for (let pass = this.#passes.shift(); pass; pass = this.#passes.shift()) {
      const { width, height } = this.#header;
      const columns = Math.ceil((width - pass.x) / pass.xStep);
      this.#rows = Math.ceil((height - pass.y) / pass.yStep);
      if (columns <= 0 || this.#rows <= 0) continue;
      const bytes = bytesPerRow({ ...this.#header, width: columns });
      this.#pass = pass;
      this.#row = 0;
      this.#line = new Uint8Array(1 + bytes);
      this.#above = new Uint8Array(bytes);
      return;
    }
    this.#isFull = true;
  }

  #endRow(): void {
    const bytes = this.#line.length - 1;
    if (this.#header.isInterlaced) {
      const row = new Uint8Array(bytes);
      unfilter(this.#line, row, this.#above, this.#step);
      this.#spread(row);
      this.#above = row;
    } else {
      const row = this.data.subarray(this.#row * bytes, (this.#row + 1) * bytes);
      unfilter(this.#line, row, this.#above, this.#step);
      this.#above = row;
    }
    this.#filled = 0;
    if (++this.#row === this.#rows) this.#beginPass();
  }

  /** Puts the pixels of an interlaced row where they belong; they are whole bytes there. */
  #spread(row: Uint8Array): void {
    const { x, y, xStep, yStep } = this.#pass;
    const step = this.#step;
    let to = ((y + this.#row * yStep) * this.#header.width + x) * step;
    for (let from = 0; from < row.length; to += (xStep - 1) * step) {
      for (let byte = 0; byte < step; byte++) this.data[to++] = row[from++];
    }
  }
}

/**
 * Undoes the filter of a row. Filters store each byte as its difference from its neighbours, so that rows pack better.
 * Source: the PNG specification, section 9.
 * @param line - the filter's number, then the row
 * @param above - the row before, zeros before the first
 * @param step - bytes from a pixel to the next
 */
function unfilter(line: Uint8Array, row: Uint8Array, above: Uint8Array, step: number): void {
  const { length } = row;
  switch (line[0]) {
    case 0:
      row.set(line.subarray(1));
      return;
    case 1:
      for (let i = 0; i < step; i++) row[i] = line[i + 1];
      for (let i = step; i < length; i++) row[i] = line[i + 1] + row[i - step];
      return;
    case 2:
      for (let i = 0; i < length; i++) row[i] = line[i + 1] + above[i];
      return;
    case 3:
      for (let i = 0; i < step; i++) row[i] = line[i + 1] + (above[i] >> 1);
      for (let i = step; i < length; i++) row[i] = line[i + 1] + ((row[i - step] + above[i]) >> 1);
      return;
    case 4:
      for (let i = 0; i < step; i++) row[i] = line[i + 1] + above[i];
      for (let i = step; i < length; i++) {
        const left = row[i - step];
        const up = above[i];
        const corner = above[i - step];
        const toLeft = Math.abs(up - corner);
        const toUp = Math.abs(left - corner);
        const toCorner = Math.abs(left + up - 2 * corner);
        row[i] = line[i + 1] + (toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner);
      }
      return;
    default:
      throw new Error(`unknown filter ${line[0]}`);
  }
}
