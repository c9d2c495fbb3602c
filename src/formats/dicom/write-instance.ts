// Writes what a DICOMweb server says of an instance as a file, which is then read as every other file. Only elements that
// are read are written. Source: DICOM PS3.18, annex F; PS3.5, 7.1 and A.4
import { joinPieces } from '../base/join-pieces.ts';
import { findTag, pixelTags, sequences } from './tags.ts';

/** A set of elements, by their numbers in hexadecimal digits. */
export type JsonSet = Readonly<Record<string, JsonElement | undefined>>;

export interface JsonElement {
  readonly vr?: string;
  readonly Value?: readonly unknown[];
  readonly InlineBinary?: string;
  readonly BulkDataURI?: string;
}

/** The pixels of an instance, as they come from the server. */
export interface JsonPixels {
  /** Of the element. */
  readonly id: number;
  /** Transfer syntax: how they are packed. */
  readonly syntax: string;
  /** One for each frame, or all together. */
  readonly pieces: readonly Uint8Array<ArrayBuffer>[];
  readonly isPacked: boolean;
  /** Bytes that the element says it has where its pieces are left out; undefined where they are not. */
  readonly announced?: number;
}

/** An element of a set; undefined where it is missing. */
export const elementOf = (set: JsonSet, id: number): JsonElement | undefined =>
  set[id.toString(16).padStart(8, '0').toUpperCase()];

/** Sequences in sequences: those that are read have few. */
const maxDepth = 8;

const encoder = new TextEncoder();
const sequenceIds: ReadonlySet<number> = new Set(Object.values(sequences).map(({ id }) => id));

const binary: Readonly<Record<string, readonly [bytes: number, set: (view: DataView, at: number, n: number) => void]>> =
  {
    US: [2, (view, at, n) => view.setUint16(at, n, true)],
    SS: [2, (view, at, n) => view.setInt16(at, n, true)],
    UL: [4, (view, at, n) => view.setUint32(at, n, true)],
    SL: [4, (view, at, n) => view.setInt32(at, n, true)],
    FL: [4, (view, at, n) => view.setFloat32(at, n, true)],
    FD: [8, (view, at, n) => view.setFloat64(at, n, true)],
  };

/**
 * @param bulk - bytes of elements that the server gives at addresses of their own, by address
 * @param pixels - null for an instance without any
 */
export function writeInstance(
  set: JsonSet,
  bulk: ReadonlyMap<string, Uint8Array<ArrayBuffer>>,
  pixels: JsonPixels | null,
): Uint8Array<ArrayBuffer> {
  // JSON is UTF-8, whatever the file was.
  const named: JsonSet = { ...set, '00080005': { vr: 'CS', Value: ['ISO_IR 192'] } };
  const pieces = [
    new Uint8Array(128),
    encoder.encode('DICM'),
    ...writeElement(0x00020010, 'UI', [padText(pixels?.syntax ?? '1.2.840.10008.1.2.1', '\0')]),
    ...writeSet(named, bulk, 0),
    ...(pixels ? writePixels(pixels) : []),
  ];
  return joinPieces(pieces);
}

/** The addresses of elements that are read and stand elsewhere, except the pixels. */
export function listBulk(set: JsonSet, depth = 0): string[] {
  return knownElements(set).flatMap(({ element, isSequence }) => {
    if (isSequence) return depth < maxDepth ? itemsOf(element).flatMap((item) => listBulk(item, depth + 1)) : [];
    return typeof element.BulkDataURI === 'string' ? [element.BulkDataURI] : [];
  });
}

interface Known {
  readonly id: number;
  readonly vr: string;
  readonly element: JsonElement;
  readonly isSequence: boolean;
}

/** In the order of their numbers. */
function knownElements(set: JsonSet): Known[] {
  const known: Known[] = [];
  for (const [key, element] of Object.entries(set)) {
    const id = /^[\dA-F]{8}$/i.test(key) ? parseInt(key, 16) : 0;
    const tag = findTag(id);
    if (!tag || !element || id < 0x00080000 || pixelTags.has(id)) continue;
    const vr = typeof element.vr === 'string' && /^[A-Z]{2}$/.test(element.vr) ? element.vr : tag.vr;
    known.push({ id, vr, element, isSequence: sequenceIds.has(id) });
  }
  known.sort((a, b) => a.id - b.id);
  return known;
}

const itemsOf = ({ Value }: JsonElement): JsonSet[] =>
  Array.isArray(Value) ? Value.filter((item): item is JsonSet => typeof item === 'object' && item !== null) : [];

type Pieces = Uint8Array<ArrayBuffer>[];

function writeSet(set: JsonSet, bulk: ReadonlyMap<string, Uint8Array<ArrayBuffer>>, depth: number): Pieces {
  return knownElements(set).flatMap(({ id, vr, element, isSequence }) => {
    if (!isSequence) return writeElement(id, vr, [valueOf(vr, element, bulk)]);
    const items = depth < maxDepth ? itemsOf(element) : [];
    return writeElement(
      id,
      'SQ',
      items.flatMap((item) => writeItem(writeSet(item, bulk, depth + 1))),
    );
  });
}

function valueOf(
  vr: string,
  { Value, InlineBinary, BulkDataURI }: JsonElement,
  bulk: ReadonlyMap<string, Uint8Array<ArrayBuffer>>,
): Uint8Array<ArrayBuffer> {
  if (typeof InlineBinary === 'string') return fromBase64(InlineBinary);
  if (typeof BulkDataURI === 'string') return bulk.get(BulkDataURI) ?? new Uint8Array();
  const values = Array.isArray(Value) ? (Value as readonly unknown[]) : [];
  if (vr in binary) {
    const [size, write] = binary[vr];
    const view = new DataView(new ArrayBuffer(size * values.length));
    values.forEach((value, i) => write(view, i * size, Number(value)));
    return new Uint8Array(view.buffer);
  }
  if (vr === 'AT') {
    const words = values.flatMap((value) =>
      [String(value).slice(0, 4), String(value).slice(4)].map((hex) => parseInt(hex, 16)),
    );
    return new Uint8Array(Uint16Array.from(words).buffer);
  }
  const text = values.map((value) => (typeof value === 'string' || typeof value === 'number' ? String(value) : ''));
  return padText(text.join('\\'), vr === 'UI' ? '\0' : ' ');
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  try {
    return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  } catch {
    return new Uint8Array();
  }
}

function padText(text: string, fill: string): Uint8Array<ArrayBuffer> {
  const bytes = encoder.encode(text);
  return bytes.length % 2 ? encoder.encode(text + fill) : bytes;
}

/** Value representations whose length has two bytes. */
const shortLength = /^(AE|AS|AT|CS|DA|DS|DT|FD|FL|IS|LO|LT|PN|SH|SL|SS|ST|TM|UI|UL|US)$/;

function writeElement(id: number, vr: string, value: Pieces): Pieces {
  const length = value.reduce((sum, piece) => sum + piece.length, 0);
  const isShort = shortLength.test(vr) && length < 0xffff;
  const header = new DataView(new ArrayBuffer(isShort ? 8 : 12));
  header.setUint16(0, id >>> 16, true);
  header.setUint16(2, id & 0xffff, true);
  // A text that is too long for its representation has an unknown one.
  const written = shortLength.test(vr) && !isShort ? 'UN' : vr;
  for (const i of [0, 1]) header.setUint8(4 + i, written.charCodeAt(i));
  if (isShort) header.setUint16(6, length, true);
  else header.setUint32(8, length, true);
  return [new Uint8Array(header.buffer), ...value];
}

function writeItem(value: Pieces): Pieces {
  return [
    mark(
      0xe000,
      value.reduce((sum, piece) => sum + piece.length, 0),
    ),
    ...value,
  ];
}

function writePixels({ id, pieces, isPacked, announced }: JsonPixels): Pieces {
  const vr = id === 0x7fe00008 ? 'OF' : id === 0x7fe00009 ? 'OD' : isPacked ? 'OB' : 'OW';
  if (announced === undefined && !isPacked) return writeElement(id, vr, [...pieces]);
  const items = pieces.flatMap((piece) => [mark(0xe000, piece.length), piece]);
  const [header] = writeElement(id, vr, []);
  new DataView(header.buffer).setUint32(8, announced ?? 0xffffffff, true);
  return announced === undefined ? [header, mark(0xe000, 0), ...items, mark(0xe0dd, 0)] : [header];
}

function mark(number: number, length: number): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(8));
  view.setUint16(0, 0xfffe, true);
  view.setUint16(2, number, true);
  view.setUint32(4, length, true);
  return new Uint8Array(view.buffer);
}
