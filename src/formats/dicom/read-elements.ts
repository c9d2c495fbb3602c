// Finds the elements of a file. The file comes from a stranger: every length is checked, and sequences go down to a limit.
import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { DataSet } from './data-set.ts';
import { findTag, itemTags, pixelTags, sequences } from './tags.ts';

/** The pixels of a file as they lie in it. */
export interface PixelElement {
  readonly numbers: 'integers' | 'float32' | 'float64';
  readonly vr: string;
  readonly littleEndian: boolean;
  /** The bytes; null where they are in fragments. */
  readonly bytes: Uint8Array<ArrayBuffer> | null;
  /** Bytes that the file says it has of them, where they are not in fragments. */
  readonly announced: number;
  /** Bytes that there are of them in the file, where they are not in fragments: also of those that were not read. */
  readonly there: number;
  /** Where they begin in the bytes that were read. */
  readonly start: number;
  /** Bytes of the file that were not read: with any, neither are the pixels. */
  readonly missing: number;
  /** The pieces of packed pixels, one or more for each frame. */
  readonly fragments: readonly Uint8Array<ArrayBuffer>[];
  /** Where frames begin, in bytes from the start of the first fragment, with the eight bytes before each fragment; may be empty. */
  readonly offsets: readonly number[];
}

export interface Elements {
  readonly set: DataSet;
  readonly pixels: PixelElement | null;
}

/** Value representations whose length has two bytes; of all others, and of those to come, it has four. Source: PS3.5, 7.1.2 */
const shortLength = /^(AE|AS|AT|CS|DA|DS|DT|FD|FL|IS|LO|LT|PN|SH|SL|SS|ST|TM|UI|UL|US)$/;

/** The length of what ends with a mark of its own. */
const untilMark = 0xffffffff;

/** Sequences in sequences: files in use have fewer than ten. */
const maxDepth = 32;

interface Reading {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Bytes of the file after these. */
  readonly missing: number;
  readonly view: DataView;
  readonly littleEndian: boolean;
  readonly budget: Budget;
  /** For messages: 'file 12 of 300'. */
  readonly what: string;
}

interface Header {
  readonly id: number;
  readonly vr: string;
  readonly length: number;
  /** Where the value begins. */
  readonly start: number;
}

/** @param from - where the first element begins @param how - of the data set, as the transfer syntax says */
export function readElements(
  bytes: Uint8Array<ArrayBuffer>,
  from: number,
  how: Omit<Reading, 'bytes' | 'view'> & { readonly isExplicit: boolean },
): Elements {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const reading: Reading = { ...how, bytes, view };
  const set = new DataSet(bytes, how.littleEndian);
  let pixels: PixelElement | null = null;
  readSet(reading, set, { start: from, end: bytes.length, isExplicit: how.isExplicit, depth: 0 }, (header) => {
    pixels = readPixels(reading, header);
  });
  return { set, pixels };
}

/** The elements of the group before the data set, which say how it is written. */
export function readFileMeta(
  bytes: Uint8Array<ArrayBuffer>,
  from: number,
  budget: Budget,
  what: string,
): { set: DataSet; end: number } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const reading: Reading = { bytes, view, missing: 0, littleEndian: true, budget, what };
  const set = new DataSet(bytes, true);
  let at = from;
  while (at + 8 <= bytes.length && view.getUint16(at, true) === 2) {
    budget.step(1, what);
    const { id, vr, length, start } = readHeader(reading, at, true);
    const end = start + length;
    if (end > bytes.length) throw endsEarly(reading, id, length, bytes.length - start);
    if (findTag(id)) set.set(id, { vr, start, end });
    at = end;
  }
  return { set, end: at };
}

interface Span {
  readonly start: number;
  readonly end: number;
  readonly isExplicit: boolean;
  readonly depth: number;
}

/**
 * Reads elements up to the end of a span, or to the mark at the end of an item.
 * @param onPixels - gets the pixels of the file, after which nothing is read
 * @returns where the next element begins
 */
function readSet(
  reading: Reading,
  set: DataSet,
  { start: from, end, isExplicit, depth }: Span,
  onPixels?: (header: Header) => void,
): number {
  const { budget, what } = reading;
  let at = from;
  while (at + 8 <= end) {
    budget.step(1, what);
    const header = readHeader(reading, at, isExplicit);
    const { id, vr, length, start } = header;
    if (id === itemTags.itemEnd || id === itemTags.sequenceEnd) return at + 8;
    if (onPixels && pixelTags.has(id)) {
      onPixels(header);
      return end;
    }
    const isKnown = findTag(id) !== undefined;
    const isSequence = vr === 'SQ' || length === untilMark || (isKnown && isSequenceTag(id));
    if (length !== untilMark && length > end - start) throw endsEarly(reading, id, length, end - start);
    if (length === untilMark && isInFragments(header)) {
      at = skipFragments(reading, start, end);
      continue;
    }
    if (isSequence && (isKnown || length === untilMark)) {
      // An unknown element of no length is a sequence with implicit representations (PS3.5, 6.2.2, note 2).
      const items: DataSet[] = [];
      const span = {
        start,
        end: length === untilMark ? end : start + length,
        isExplicit: isExplicit && vr !== 'UN',
        depth: depth + 1,
      };
      at = readItems(reading, span, length === untilMark, (item) => isKnown && items.push(item));
      if (isKnown) set.setItems(id, items);
      continue;
    }
    if (isKnown) set.set(id, { vr, start, end: start + length });
    at = start + length;
  }
  return end;
}

const sequenceIds: ReadonlySet<number> = new Set(Object.values(sequences).map(({ id }) => id));
const isSequenceTag = (id: number): boolean => sequenceIds.has(id);

/**
 * Whether what ends with a mark is packed bytes, as icons and private elements have them too: their items hold no elements.
 * Source: PS3.5, A.4
 */
const isInFragments = ({ id, vr }: Header): boolean =>
  vr !== 'SQ' && (vr === 'OB' || vr === 'OW' || pixelTags.has(id)) && !isSequenceTag(id);

/** @returns where the next element begins */
function readItems(
  reading: Reading,
  { start: from, end, isExplicit, depth }: Span,
  hasMark: boolean,
  add: (item: DataSet) => void,
): number {
  const { bytes, littleEndian, budget, what } = reading;
  if (depth > maxDepth) throw corruptFile(what, `has sequences in each other, more than ${maxDepth} deep`);
  let at = from;
  while (at + 8 <= end) {
    budget.step(1, what);
    const { id, length, start } = readMark(reading, at);
    if (id === itemTags.sequenceEnd) {
      if (hasMark) return start;
      at = start;
      continue;
    }
    if (id !== itemTags.item)
      throw corruptFile(what, `has a damaged sequence: got the element ${nameId(id)} where one of its items begins`);
    if (length !== untilMark && length > end - start) throw endsEarly(reading, id, length, end - start);
    const item = new DataSet(bytes, littleEndian);
    add(item);
    const next = readSet(reading, item, { start, end: length === untilMark ? end : start + length, isExplicit, depth });
    at = length === untilMark ? next : start + length;
  }
  return end;
}

function readHeader({ bytes, view, littleEndian, what }: Reading, at: number, isExplicit: boolean): Header {
  const id = readId(view, at, littleEndian);
  if (id >= itemTags.item && id <= itemTags.sequenceEnd)
    return { id, vr: '', length: view.getUint32(at + 4, littleEndian), start: at + 8 };
  const vr = String.fromCharCode(bytes[at + 4], bytes[at + 5]);
  // Some writers put single elements with an implicit representation into explicit files.
  if (!isExplicit || !/^[A-Z]{2}$/.test(vr))
    return { id, vr: '', length: view.getUint32(at + 4, littleEndian), start: at + 8 };
  if (shortLength.test(vr)) return { id, vr, length: view.getUint16(at + 6, littleEndian), start: at + 8 };
  if (at + 12 > bytes.length) throw corruptFile(what, 'ends early, in the middle of an element');
  return { id, vr, length: view.getUint32(at + 8, littleEndian), start: at + 12 };
}

function readMark({ view, littleEndian }: Reading, at: number): { id: number; length: number; start: number } {
  return { id: readId(view, at, littleEndian), length: view.getUint32(at + 4, littleEndian), start: at + 8 };
}

function readId(view: DataView, at: number, littleEndian: boolean): number {
  return view.getUint16(at, littleEndian) * 0x10000 + view.getUint16(at + 2, littleEndian);
}

function readPixels(reading: Reading, { id, vr, length, start }: Header): PixelElement {
  const { bytes, littleEndian, missing } = reading;
  const rest = { numbers: pixelTags.get(id) ?? 'integers', vr, littleEndian, start, missing };
  const none = { fragments: [], offsets: [] };
  if (length === untilMark)
    return { ...rest, bytes: null, announced: 0, there: 0, ...(missing > 0 ? none : readFragments(reading, start)) };
  const there = Math.max(0, Math.min(length, bytes.length + missing - start));
  return { ...rest, bytes: bytes.subarray(start, start + length), announced: length, there, ...none };
}

/** The first item says where the frames begin, or is empty. Source: PS3.5, A.4 */
function readFragments(reading: Reading, from: number): Pick<PixelElement, 'fragments' | 'offsets'> {
  const { bytes, view } = reading;
  const fragments: Uint8Array<ArrayBuffer>[] = [];
  let offsets: number[] | null = null;
  skipFragments(reading, from, bytes.length, (start, length) => {
    if (offsets) fragments.push(bytes.subarray(start, start + length));
    else offsets = Array.from({ length: length >> 2 }, (_, i) => view.getUint32(start + 4 * i, true));
  });
  return { fragments, offsets: offsets ?? [] };
}

/** @param onPiece - gets each one on the way @returns where the next element begins */
function skipFragments(
  reading: Reading,
  from: number,
  end: number,
  onPiece?: (start: number, length: number) => void,
): number {
  const { budget, what } = reading;
  for (let at = from; at + 8 <= end;) {
    budget.step(1, what);
    const { id, length, start } = readMark(reading, at);
    if (id === itemTags.sequenceEnd) return start;
    if (id !== itemTags.item)
      throw corruptFile(what, `has damaged pixels: got the element ${nameId(id)} where one of their pieces begins`);
    if (length > end - start) throw endsEarly(reading, id, length, end - start);
    onPiece?.(start, length);
    at = start + length;
  }
  return end;
}

function endsEarly({ what }: Reading, id: number, wanted: number, got: number): Error {
  return corruptFile(
    what,
    `ends early: its element ${nameId(id)} asks for ${wanted.toLocaleString('en')} bytes; got ${got.toLocaleString('en')}. Copy the file again`,
  );
}

/** '(0028,0010)'. Only the number of an element: its value stays here. */
function nameId(id: number): string {
  const hex = id.toString(16).padStart(8, '0');
  return `(${hex.slice(0, 4)},${hex.slice(4)})`;
}
