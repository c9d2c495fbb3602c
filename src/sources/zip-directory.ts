// The list of the files in a ZIP archive. Source: PKWARE's APPNOTE.TXT 6.3.10, sections 4.3 to 4.5.
import { VolumeViewError } from '../core/errors.ts';

/** One file of an archive, as the archive's list describes it. */
export interface ZipEntry {
  readonly path: string;
  /** 0 stored, 8 deflate. */
  readonly method: number;
  readonly isEncrypted: boolean;
  readonly crc: number;
  /** Bytes in the archive, and unpacked. */
  readonly packed: number;
  readonly size: number;
  /** Where its own header begins in the archive; where its data end at the latest. */
  readonly start: number;
  readonly end: number;
}

/** Reads some bytes of the archive. */
export type ReadBytes = (start: number, end: number, signal?: AbortSignal) => Promise<Uint8Array<ArrayBuffer>>;

/** Files and folders that an archive may list: twice as many as one volume may have files. */
export const maxEntries = 2 ** 14;

/** Bytes that the list may take: 1,024 for each file, where names are rarely longer than 100. */
const maxListBytes = 1024 * maxEntries;

/** Deflate expands a byte to at most 1,032 (zlib's technical notes); the shortest streams have a little less. */
const maxRatio = 1032;

const endBytes = 22;
const maxCommentBytes = 0xffff;
const locatorBytes = 20;
const end64Bytes = 56;
const entryBytes = 46;
/** The header before each file, without its name. */
export const localBytes = 30;

/** Where the list is, and how many files it has. */
interface ListPlace {
  readonly count: number;
  readonly bytes: number;
  readonly offset: number;
  /** Where the list ends in the file: behind it is the record that describes it. */
  readonly end: number;
}

/** The error of an archive that contradicts itself. @param problem - 'lists files that overlap' */
export function corruptZip(name: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the ZIP archive ${name} ${problem}; fetch it again, or pack it again`);
}

export function unsupportedZip(name: string, problem: string, advice: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `the ZIP archive ${name} ${problem}; ${advice}`);
}

/**
 * The files of an archive, without its folders, in the order of its list.
 * @param read - from the archive
 * @param size - of the archive, bytes
 * @param name - of the archive, for messages
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export async function readDirectory(read: ReadBytes, size: number, name: string): Promise<ZipEntry[]> {
  const { count, bytes, offset, end } = await findList(read, size, name);
  if (count > maxEntries) {
    throw new VolumeViewError(
      'format/too-large',
      `the ZIP archive ${name} lists ${count.toLocaleString('en')} files; expected at most ${maxEntries.toLocaleString('en')}`,
    );
  }
  const start = end - bytes;
  // Programs that unpack themselves have code before the archive, and count from behind it.
  const shift = start - offset;
  if (!(start >= 0 && shift >= 0 && bytes >= entryBytes * count))
    throw corruptZip(name, 'has a list of files that does not lie in it');
  if (bytes > maxListBytes) {
    throw new VolumeViewError(
      'format/too-large',
      `the ZIP archive ${name} has a list of files of ${bytes.toLocaleString('en')} bytes; expected at most ${maxListBytes.toLocaleString('en')}`,
    );
  }
  const list = await read(start, end);
  const entries: Listed[] = [];
  for (let at = 0, i = 0; i < count; i++) {
    const entry = readEntry(list, at, shift, name);
    entries.push(entry);
    at = entry.next;
  }
  return checkPlaces(entries, start, name).filter(({ path }) => !/[/\\]$/.test(path));
}

/** Reads the record at the end of an archive, and the one of ZIP64 before it. */
async function findList(read: ReadBytes, size: number, name: string): Promise<ListPlace> {
  const tailStart = Math.max(0, size - endBytes - maxCommentBytes - locatorBytes);
  const tail = viewOf(await read(tailStart, size));
  const at = findEnd(tail);
  if (at === null) throw corruptZip(name, 'has no list of its files at its end: it is cut short');
  const [disk, firstDisk, here, count] = [4, 6, 8, 10].map((i) => tail.getUint16(at + i, true));
  const [bytes, offset] = [12, 16].map((i) => tail.getUint32(at + i, true));
  const hasLocator = at >= locatorBytes && tail.getUint32(at - locatorBytes, true) === 0x07064b50;
  if (hasLocator) return findList64(read, getUint64(tail, at - locatorBytes + 8), tailStart + at - locatorBytes, name);
  if (disk !== firstDisk || here !== count) throw isPart(name);
  return { count, bytes, offset, end: tailStart + at };
}

async function findList64(read: ReadBytes, place: number, locator: number, name: string): Promise<ListPlace> {
  // The record may be moved by bytes before the archive. It lies right before its locator, unless a later version made it longer.
  for (const start of [locator - end64Bytes, place]) {
    if (!(start >= 0 && start + end64Bytes <= locator)) continue;
    const record = viewOf(await read(start, start + end64Bytes));
    if (record.getUint32(0, true) !== 0x06064b50) continue;
    const [disk, firstDisk] = [16, 20].map((i) => record.getUint32(i, true));
    const [here, count, bytes, offset] = [24, 32, 40, 48].map((i) => getUint64(record, i));
    if (disk !== firstDisk || here !== count) throw isPart(name);
    return { count, bytes, offset, end: start };
  }
  throw corruptZip(name, 'has no list of its files where it says');
}

function isPart(name: string): VolumeViewError {
  return unsupportedZip(name, 'is one part of several', 'expected a single archive: pack the files again');
}

/** Index of the record at an archive's end; a comment may follow it. */
function findEnd(tail: DataView): number | null {
  for (let at = tail.byteLength - endBytes; at >= 0; at--) {
    if (tail.getUint32(at, true) === 0x06054b50 && at + endBytes + tail.getUint16(at + 20, true) <= tail.byteLength)
      return at;
  }
  return null;
}

type Listed = ZipEntry & { readonly next: number };

function readEntry(list: Uint8Array<ArrayBuffer>, at: number, shift: number, name: string): Listed {
  const view = viewOf(list);
  if (at + entryBytes > list.length || view.getUint32(at, true) !== 0x02014b50)
    throw corruptZip(name, 'has a damaged list of files');
  const [flags, method] = [8, 10].map((i) => view.getUint16(at + i, true));
  const [crc, packed32, size32] = [16, 20, 24].map((i) => view.getUint32(at + i, true));
  const [nameBytes, extraBytes, commentBytes] = [28, 30, 32].map((i) => view.getUint16(at + i, true));
  const [nameStart, extraStart] = [at + entryBytes, at + entryBytes + nameBytes];
  const next = extraStart + extraBytes + commentBytes;
  if (next > list.length) throw corruptZip(name, 'has a damaged list of files');
  const large = readLarge(viewOf(list.subarray(extraStart, extraStart + extraBytes)), [
    size32,
    packed32,
    view.getUint32(at + 42, true),
  ]);
  if (!large) throw corruptZip(name, 'has a file whose size is missing');
  const [size, packed, offset] = large;
  const path = readPath(list.subarray(nameStart, extraStart));
  const isEncrypted = (flags & 1) === 1;
  const isWrong = !isEncrypted && ((method === 0 && size !== packed) || (method === 8 && size > packed * maxRatio));
  if (isWrong)
    throw corruptZip(name, `says that ${packed.toLocaleString('en')} bytes hold ${size.toLocaleString('en')}`);
  const start = offset + shift;
  return { path, method, isEncrypted, crc, packed, size, start, end: start + localBytes + packed, next };
}

/** Numbers of 64 bits stand in ZIP64's field, one for each number of 32 bits whose bits are all set, in this order. */
function readLarge(extra: DataView, numbers: readonly number[]): number[] | null {
  if (!numbers.includes(0xffffffff)) return [...numbers];
  for (let at = 0; at + 4 <= extra.byteLength;) {
    const [id, length] = [extra.getUint16(at, true), extra.getUint16(at + 2, true)];
    at += 4;
    if (id !== 1) {
      at += length;
      continue;
    }
    const end = Math.min(extra.byteLength, at + length);
    const read = numbers.map((number) => {
      if (number !== 0xffffffff) return number;
      at += 8;
      return at <= end ? getUint64(extra, at - 8) : NaN;
    });
    return read.every(Number.isSafeInteger) ? read : null;
  }
  return null;
}

/** Names are in UTF-8, or in whatever the packer's machine used: then letters beyond ASCII may be wrong, which harms no one. */
function readPath(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

/** Files that share bytes would let a small archive claim to be huge. */
function checkPlaces(entries: readonly Listed[], listStart: number, name: string): ZipEntry[] {
  const places = [...entries];
  places.sort((a, b) => a.start - b.start);
  for (const [i, { end }] of places.entries()) {
    const nextStart = places[i + 1]?.start ?? listStart;
    if (!(end <= nextStart)) throw corruptZip(name, 'lists files that overlap');
  }
  const ends = new Map(places.map((entry, i) => [entry, places[i + 1]?.start ?? listStart]));
  return entries.map(({ next: _next, ...entry }, i) => ({ ...entry, end: ends.get(entries[i])! }));
}

/** NaN where it is too large to be exact. */
function getUint64(view: DataView, at: number): number {
  const number = Number(view.getBigUint64(at, true));
  return Number.isSafeInteger(number) ? number : NaN;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
