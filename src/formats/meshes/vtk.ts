// VTK's legacy files of surfaces (.vtk), which 3D Slicer writes. Loaded with the first of them. Source: VTK 9, "VTK legacy file formats"
import { VolumeViewError } from '../../core/errors.ts';
import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { wholeList } from './number-list.ts';
import { readSpace } from './space-comment.ts';
import { TextScanner } from './text-scanner.ts';

const format = 'VTK file';

/** Numbers of a type: bytes of one, and how it is read. A long has 8 bytes, as on all machines but those with Windows. */
type Numbers = readonly [bytes: number, read: (view: DataView, at: number) => number];

const types: Readonly<Record<string, Numbers>> = {
  char: [1, (view, at) => view.getInt8(at)],
  unsigned_char: [1, (view, at) => view.getUint8(at)],
  short: [2, (view, at) => view.getInt16(at)],
  unsigned_short: [2, (view, at) => view.getUint16(at)],
  int: [4, (view, at) => view.getInt32(at)],
  vtkidtype: [4, (view, at) => view.getInt32(at)],
  unsigned_int: [4, (view, at) => view.getUint32(at)],
  float: [4, (view, at) => view.getFloat32(at)],
  double: [8, (view, at) => view.getFloat64(at)],
  long: [8, (view, at) => Number(view.getBigInt64(at))],
  unsigned_long: [8, (view, at) => Number(view.getBigUint64(at))],
  vtktypeint64: [8, (view, at) => Number(view.getBigInt64(at))],
};

/** Cells that are no triangles, or polygons. */
const others: Readonly<Record<string, string>> = { VERTICES: 'points', LINES: 'lines' };

/** The lines of a file, and the numbers between them. */
class Reading {
  readonly scanner: TextScanner;
  isText = true;

  constructor(readonly bytes: Uint8Array) {
    this.scanner = new TextScanner(bytes);
  }

  line(): string {
    const line = this.scanner.rest();
    this.scanner.nextLine();
    return line;
  }

  /** The words of the next line that has some; none at the end. */
  words(): string[] {
    while (!this.scanner.isAtEnd) {
      const line = this.line();
      if (line !== '') return line.split(/\s+/);
    }
    return [];
  }

  /** @throws {VolumeViewError} `format/corrupt` before memory is allocated for more numbers than there are bytes */
  numbers(type: string, count: number): Float64Array {
    const name = type.toLowerCase();
    if (!Object.hasOwn(types, name)) throw corrupt(format, `has numbers of the type "${type.slice(0, 40)}"`);
    const { scanner, bytes } = this;
    const [size, read] = types[name];
    // Digits, and blanks between them.
    const least = this.isText ? 2 * count - 1 : size * count;
    if (!Number.isSafeInteger(count) || count < 0 || scanner.at + least > bytes.length)
      throw corrupt(format, 'ends early, or has a wrong count');
    if (this.isText)
      return Float64Array.from({ length: count }, () => {
        const number = scanner.anyNumber();
        if (Number.isNaN(number)) throw corrupt(format, `has no number in line ${scanner.line}`);
        return number;
      });
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const start = scanner.at;
    scanner.at += count * size;
    return Float64Array.from({ length: count }, (_, i) => read(view, start + i * size));
  }
}

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large` */
export function readVtk(bytes: Uint8Array): Mesh {
  const reading = new Reading(bytes);
  reading.line();
  const title = reading.line();
  const form = reading.line().toUpperCase();
  if (form !== 'ASCII' && form !== 'BINARY')
    throw corrupt(format, `is "${form.slice(0, 40)}"; expected ASCII or BINARY`);
  reading.isText = form === 'ASCII';
  let positions: Mesh['positions'] | null = null;
  const corners = wholeList();
  const left = new Set<string>();
  for (let words = reading.words(); words.length > 0; words = reading.words()) {
    const [word, first = '', second = ''] = words;
    const name = word.toUpperCase();
    if (name === 'DATASET') checkKind(first);
    else if (name === 'POINTS') {
      checkCounts(format, Number(first), 0);
      positions = Float32Array.from(reading.numbers(second, 3 * Number(first)));
    } else if (name === 'POLYGONS' || name === 'TRIANGLE_STRIPS' || Object.hasOwn(others, name)) {
      const isOther = Object.hasOwn(others, name);
      if (isOther) left.add(others[name]);
      for (const cell of readCells(reading, Number(first), Number(second)))
        if (!isOther) addCell(cell, name === 'TRIANGLE_STRIPS', corners);
    } else if (name === 'FIELD') for (let i = 0; i < Number(second); i++) skipArray(reading);
    else if (name === 'METADATA') skipLines(reading);
    else if (name === 'POINT_DATA' || name === 'CELL_DATA') break;
    else
      throw corrupt(format, `got "${word.slice(0, 40)}" in line ${reading.scanner.line}; expected POINTS or POLYGONS`);
  }
  if (!positions) throw corrupt(format, 'has no points');
  const rest = new TextDecoder('latin1').decode(bytes.subarray(reading.scanner.at));
  if (/^COLOR_SCALARS\b/m.test(rest)) left.add('colours');
  return {
    positions,
    normals: null,
    indices: corners.take(),
    colors: null,
    space: readSpace(title),
    format,
    ...(left.size > 0 && { left: [`not shown: ${[...left].join(', ')}`] }),
  };
}

function checkKind(kind: string): void {
  if (kind.toUpperCase() === 'POLYDATA') return;
  throw new VolumeViewError(
    'format/unsupported',
    `the VTK file is of the kind ${kind.slice(0, 40)}; expected POLYDATA, a surface. "Extract Surface" of ParaView makes one`,
  );
}

/** The corners of each cell. Since version 5 the places where cells begin come first, and then the corners of all. */
function* readCells(reading: Reading, first: number, second: number): Generator<Float64Array> {
  const { scanner } = reading;
  const start = scanner.at;
  const [word = '', type = ''] = reading.words();
  if (word.toUpperCase() === 'OFFSETS') {
    const offsets = reading.numbers(type, first);
    const [, ofCorners = ''] = reading.words();
    const all = reading.numbers(ofCorners, second);
    for (let i = 1; i < first; i++) yield all.subarray(offsets[i - 1], offsets[i]);
    return;
  }
  scanner.at = start;
  const all = reading.numbers('int', second);
  for (let at = 0, i = 0; i < first; i++, at += all[at] + 1) {
    if (!(at < all.length && at + all[at] < all.length && all[at] >= 0))
      throw corrupt(format, 'has fewer corners than it says');
    yield all.subarray(at + 1, at + 1 + all[at]);
  }
}

/** Polygons become fans. In a strip each corner makes a triangle with the two before it, every other one turned. */
function addCell(cell: Float64Array, isStrip: boolean, corners: ReturnType<typeof wholeList>): void {
  for (let i = 2; i < cell.length; i++) {
    const [a, b] = isStrip ? (i % 2 === 0 ? [i - 2, i - 1] : [i - 1, i - 2]) : [0, i - 1];
    for (const corner of [cell[a], cell[b], cell[i]]) {
      if (!(corner >= 0 && corner < 2 ** 32)) throw corrupt(format, `has a corner ${corner}`);
      corners.push(corner);
    }
  }
  checkCounts(format, 0, corners.length / 3);
}

function skipArray(reading: Reading): void {
  const [, components, tuples, type = ''] = reading.words();
  reading.numbers(type, Number(components) * Number(tuples));
  // In a file of this kind its description may follow.
  const { at } = reading.scanner;
  const [word = ''] = reading.words();
  if (word.toUpperCase() === 'METADATA') skipLines(reading);
  else reading.scanner.at = at;
}

/** A description ends with an empty line. */
function skipLines(reading: Reading): void {
  while (!reading.scanner.isAtEnd && reading.line() !== '');
}
