import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { corruptZstd } from './zstd-codes.ts';
import { maxBlockBytes, startFrame, unpackBlock } from './zstd-block.ts';
import { xxh64 } from './xxh64.ts';

// Our own Zstandard decoder. Of those on npm, fzstd 0.1 checks no checksum, and a block of 128 kB can make it write 12 GB; zstddec 0.3 is
// WebAssembly, which a page may not allow, in a memory that never becomes smaller. Neither limits the size of the output.
// Source: RFC 8878

/** True where bytes begin with Zstandard's signature, or with a part that is to be skipped. */
export function isZstd(bytes: Uint8Array): boolean {
  return bytes.length > 4 && bytes[1] === 0xb5 && bytes[0] === 0x28 && bytes[2] === 0x2f && bytes[3] === 0xfd;
}

const isSkipped = (bytes: Uint8Array, at: number): boolean =>
  (bytes[at] & 0xf0) === 0x50 && bytes[at + 1] === 0x2a && bytes[at + 2] === 0x4d && bytes[at + 3] === 0x18;

/** Windows of more than this are refused, as the program zstd does it without --long. */
const maxWindowBytes = 2 ** 27;

/** Steps of a block, in addition to those of its bytes: its codes. */
const stepsPerBlock = 512;

/** A file length that gives the largest useful budget, for callers without a budget: `atMost` is their limit. */
const anyFileBytes = 2 ** 22;

/**
 * Unpacks Zstandard data and checks the checksums: all frames that follow each other. Other data after them are ignored.
 * @param atMost - maximum bytes of output
 * @param budget - the output and the copy that extends it are taken from it during the work
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 */
export function unzstd(
  bytes: Uint8Array,
  atMost: number,
  budget = Budget.ofFile(anyFileBytes),
): Uint8Array<ArrayBuffer> {
  const output = new Output(atMost, budget);
  try {
    let at = 0;
    for (let isFirst = true; at < bytes.length; isFirst = false) {
      if (isSkipped(bytes, at) && at + 8 <= bytes.length)
        at += 8 + new DataView(bytes.buffer, bytes.byteOffset + at).getUint32(4, true);
      else if (isZstd(bytes.subarray(at))) at = unpackFrame(bytes, at, output);
      else if (isFirst) throw corruptZstd('has no header');
      else break;
      budget.step(stepsPerBlock, 'a Zstandard frame');
    }
    return output.finish();
  } finally {
    output.release();
  }
}

interface FrameHeader {
  /** Where its first block begins. */
  readonly end: number;
  /** Bytes of the frame, unpacked; null if it does not say it. */
  readonly size: number | null;
  readonly hasChecksum: boolean;
}

/** Source: RFC 8878, 3.1.1.1 */
function readFrameHeader(bytes: Uint8Array, start: number): FrameHeader {
  const flags = bytes[start + 4];
  const isSingle = (flags & 0x20) !== 0;
  const window = bytes[start + 5];
  let at = start + (isSingle ? 5 : 6);
  const dictionary = number(bytes, at, [0, 1, 2, 4][flags & 3]);
  at += [0, 1, 2, 4][flags & 3];
  const sizeBytes = [isSingle ? 1 : 0, 2, 4, 8][flags >> 6];
  const size = sizeBytes === 0 ? null : number(bytes, at, sizeBytes) + (sizeBytes === 2 ? 256 : 0);
  at += sizeBytes;
  if (flags & 8 || at > bytes.length) throw corruptZstd('has a damaged header');
  if (dictionary !== 0)
    throw new VolumeViewError(
      'format/unsupported',
      'the Zstandard data need a dictionary; pack the file without one: zstd file',
    );
  const windowBytes = isSingle ? 0 : 2 ** (10 + (window >> 3)) * (1 + (window & 7) / 8);
  if (windowBytes > maxWindowBytes)
    throw new VolumeViewError(
      'format/unsupported',
      `the Zstandard data look back ${windowBytes.toLocaleString('en')} bytes; expected at most ${maxWindowBytes.toLocaleString('en')}: pack the file without --long`,
    );
  return { end: at, size, hasChecksum: (flags & 4) !== 0 };
}

const number = (bytes: Uint8Array, at: number, length: number): number =>
  Array.from({ length }, (_, i) => (bytes[at + i] ?? 0) * 2 ** (8 * i)).reduce((sum, part) => sum + part, 0);

/** @returns where the frame ends */
function unpackFrame(bytes: Uint8Array, start: number, output: Output): number {
  const header = readFrameHeader(bytes, start);
  const frame = output.length;
  if (header.size !== null) output.reserve(frame + header.size);
  const state = startFrame();
  let at = header.end;
  for (let isLast = false; !isLast;) {
    if (at + 3 > bytes.length) throw corruptZstd('ends early');
    const head = number(bytes, at, 3);
    isLast = (head & 1) === 1;
    const [kind, size] = [(head >> 1) & 3, head >> 3];
    at += 3;
    const packed = kind === 1 ? 1 : size;
    if (size > maxBlockBytes || kind === 3) throw corruptZstd('has a block of no known kind or size');
    if (at + packed > bytes.length) throw corruptZstd('ends early');
    const block = bytes.subarray(at, at + packed);
    at += packed;
    output.budget.step(stepsPerBlock + size / 16, 'a Zstandard block');
    if (kind === 2) output.writeBlock((out) => unpackBlock(block, state, { bytes: out, frame, at: output.length }));
    else output.write(size, (out) => (kind === 1 ? out.fill(block[0]) : out.set(block)));
  }
  if (header.size !== null && output.length - frame !== header.size)
    throw corruptZstd(`has ${output.length - frame} bytes where ${header.size} belong`);
  if (!header.hasChecksum) return at;
  if (at + 4 > bytes.length) throw corruptZstd('ends early');
  if (xxh64(output.from(frame)) !== number(bytes, at, 4)) throw corruptZstd('has a wrong checksum');
  return at + 4;
}

/** The output and its limit. */
class Output {
  length = 0;
  private bytes = new Uint8Array(0);

  constructor(
    private readonly atMost: number,
    readonly budget: Budget,
  ) {}

  /** Room for a number of bytes that was announced, and for the block that goes beyond them where they are fewer than they are. */
  reserve(length: number): void {
    this.check(length);
    this.grow(length + maxBlockBytes);
  }

  write(count: number, fill: (out: Uint8Array) => unknown): void {
    const end = this.length + count;
    this.check(end);
    if (end > this.bytes.length) this.grow(Math.max(end, 2 * this.bytes.length));
    fill(this.bytes.subarray(this.length, end));
    this.length = end;
  }

  /** @param unpack - writes at most a block @returns where it ends */
  writeBlock(unpack: (out: Uint8Array) => number): void {
    const end = this.length + maxBlockBytes;
    if (end > this.bytes.length) this.grow(Math.max(end, 2 * this.bytes.length));
    this.length = unpack(this.bytes);
    this.check(this.length);
  }

  from(start: number): Uint8Array {
    return this.bytes.subarray(start, this.length);
  }

  finish(): Uint8Array<ArrayBuffer> {
    this.budget.take(this.length, 'the Zstandard data');
    this.budget.giveBack(this.length);
    return this.bytes.slice(0, this.length);
  }

  /** Gives the output's memory back to the budget. */
  release(): void {
    this.budget.giveBack(this.bytes.length);
  }

  private check(length: number): void {
    if (length > this.atMost)
      throw new VolumeViewError(
        'format/too-large',
        `the Zstandard data unpack to more than ${this.atMost.toLocaleString('en')} bytes; check the file`,
      );
  }

  private grow(length: number): void {
    if (length <= this.bytes.length) return;
    this.budget.take(length, 'the Zstandard data');
    const larger = new Uint8Array(length);
    larger.set(this.bytes.subarray(0, this.length));
    this.budget.giveBack(this.bytes.length);
    this.bytes = larger;
  }
}
