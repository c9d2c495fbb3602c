// JPEG of 8 and 12 bits, with loss: blocks of 8 x 8 pixels as sums of cosines. Source: ITU-T T.81, annexes A and F
import { corruptFile } from '../base/file-problem.ts';
import { JpegBits } from './jpeg-huffman.ts';
import type { HuffmanTable } from './jpeg-huffman.ts';
import type { JpegParts } from './jpeg-parts.ts';

/** Where each coefficient of the stream lies in its block. Source: T.81, figure A.6 */
const zigzag = Uint8Array.from([
  0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21, 28,
  35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47,
  55, 62, 63,
]);

/** Row x, column u: the share of coefficient u in pixel x. Source: T.81, A.3.3 */
const cosines = Float64Array.from({ length: 64 }, (_, i) => {
  const [x, u] = [i >> 3, i & 7];
  return (u === 0 ? Math.SQRT1_2 : 1) * 0.5 * Math.cos(((2 * x + 1) * u * Math.PI) / 16);
});

/** The numbers of one colour, in whole blocks. */
interface Plane {
  readonly numbers: Uint16Array;
  /** Numbers of a row. */
  readonly width: number;
}

/** @param numbers - of a whole frame in gray, to be written */
export function unpackDct(parts: JpegParts, numbers: Uint16Array): void {
  const { rows, columns } = parts;
  const [{ numbers: all, width }] = unpackPlanes(parts);
  for (let y = 0; y < rows; y++) numbers.set(all.subarray(y * width, y * width + columns), y * columns);
}

/** @param numbers - of a whole frame, to be written: three for each pixel */
export function unpackColors(parts: JpegParts, numbers: Uint8Array): void {
  const { rows, columns, components } = parts;
  const [maxAcross, maxDown] = [
    Math.max(...components.map(({ across }) => across)),
    Math.max(...components.map(({ down }) => down)),
  ];
  unpackPlanes(parts).forEach((plane, i) => {
    const { across, down } = components[i];
    const times = [maxAcross / across, maxDown / down] as const;
    const size = [Math.ceil((columns * across) / maxAcross), Math.ceil((rows * down) / maxDown)] as const;
    const at = makeReader(plane, size, times);
    for (let y = 0, to = i; y < rows; y++) for (let x = 0; x < columns; x++, to += 3) numbers[to] = at(x, y);
  });
}

/**
 * A number for each pixel, of a colour that has one for each 1, 2 or more pixels. Where it is one for 2, the nearest one counts three
 * times and its neighbour once, as in libjpeg.
 * @param size - of the plane, without what fills its last blocks
 */
function makeReader(
  { numbers, width }: Plane,
  [columns, rows]: readonly [number, number],
  [across, down]: readonly [number, number],
): (x: number, y: number) => number {
  const get = (x: number, y: number): number =>
    numbers[Math.max(0, Math.min(rows - 1, y)) * width + Math.max(0, Math.min(columns - 1, x))];
  if (across !== 2 || down > 2) return (x, y) => get(Math.floor(x / across), Math.floor(y / down));
  if (down !== 2)
    return (x, y) => {
      const [i, j, next] = [x >> 1, Math.floor(y / down), x & 1 ? 1 : -1];
      if (i + next < 0 || i + next >= columns) return get(i, j);
      return (3 * get(i, j) + get(i + next, j) + (x & 1 ? 2 : 1)) >> 2;
    };
  return (x, y) => {
    const [i, j, nextX, nextY] = [x >> 1, y >> 1, x & 1 ? 1 : -1, y & 1 ? 1 : -1];
    const sum = (column: number): number => 3 * get(column, j) + get(column, j + nextY);
    return (3 * sum(i) + sum(i + nextX) + (x & 1 ? 7 : 8)) >> 4;
  };
}

/** Unpacks all blocks. Those of several colours alternate, piece by piece; those of one follow each other. */
function unpackPlanes(parts: JpegParts): Plane[] {
  const { rows, columns, components, precision, restart, what } = parts;
  const damaged = (): Error =>
    corruptFile(what, 'has packed pixels (JPEG) without tables, or of other than 8 and 12 bits; copy the file again');
  if (precision !== 8 && precision !== 12) throw damaged();
  const isOne = components.length === 1;
  const shapes = components.map(({ first, others, factors, across, down }) => {
    if (!first || !others || !factors || ![1, 2, 3, 4].includes(across) || ![1, 2, 3, 4].includes(down))
      throw damaged();
    return { first, others, factors, across: isOne ? 1 : across, down: isOne ? 1 : down };
  });
  const pieceColumns = 8 * Math.max(...shapes.map(({ across }) => across));
  const pieceRows = 8 * Math.max(...shapes.map(({ down }) => down));
  const [piecesAcross, piecesDown] = [Math.ceil(columns / pieceColumns), Math.ceil(rows / pieceRows)];
  const planes = shapes.map(({ across, down }) => {
    const width = 8 * across * piecesAcross;
    return { width, numbers: new Uint16Array(width * 8 * down * piecesDown) };
  });
  const bits = new JpegBits(parts.bytes, parts.start, what);
  const coefficients = new Float64Array(64);
  const middle = 2 ** (precision - 1);
  const means = shapes.map(() => 0);
  for (let piece = 0; piece < piecesAcross * piecesDown; piece++) {
    if (restart > 0 && piece > 0 && piece % restart === 0) {
      bits.restart();
      means.fill(0);
    }
    const [left, top] = [piece % piecesAcross, Math.floor(piece / piecesAcross)];
    shapes.forEach(({ across, down, ...tables }, i) => {
      for (let block = 0; block < across * down; block++) {
        means[i] = readBlock(bits, { ...tables, mean: means[i] }, coefficients);
        const [x, y] = [left * across + (block % across), top * down + Math.floor(block / across)];
        writeBlock(sumCosines(coefficients), middle, planes[i], 8 * (y * planes[i].width + x));
      }
    });
    bits.check();
  }
  return planes;
}

function writeBlock(pixels: Float64Array, middle: number, { numbers, width }: Plane, start: number): void {
  for (let i = 0; i < 64; i++) {
    const value = Math.round(pixels[i] + middle);
    numbers[start + (i >> 3) * width + (i & 7)] = Math.max(0, Math.min(2 * middle - 1, value));
  }
}

interface BlockTables {
  readonly first: HuffmanTable;
  readonly others: HuffmanTable;
  readonly factors: Uint16Array;
  /** The first coefficient of the block before, before it was scaled. */
  readonly mean: number;
}

/** @returns its first coefficient, before it is scaled */
function readBlock(
  bits: JpegBits,
  { first, others, factors, mean: before }: BlockTables,
  coefficients: Float64Array,
): number {
  coefficients.fill(0);
  const mean = before + bits.readSigned(bits.readSymbol(first) & 15);
  coefficients[0] = mean * factors[0];
  for (let i = 1; i < 64; i++) {
    const symbol = bits.readSymbol(others);
    const [zeros, size] = [symbol >> 4, symbol & 15];
    if (size === 0) {
      if (zeros < 15) break;
      i += 15;
      continue;
    }
    i += zeros;
    if (i > 63) break;
    coefficients[zigzag[i]] = bits.readSigned(size) * factors[i];
  }
  return mean;
}

const [halves, sums] = [new Float64Array(64), new Float64Array(64)];

function sumCosines(coefficients: Float64Array): Float64Array {
  for (let v = 0; v < 8; v++) {
    for (let x = 0; x < 8; x++) {
      let sum = 0;
      for (let u = 0; u < 8; u++) sum += cosines[8 * x + u] * coefficients[8 * v + u];
      halves[8 * v + x] = sum;
    }
  }
  for (let y = 0; y < 8; y++) {
    for (let x = 0; x < 8; x++) {
      let sum = 0;
      for (let v = 0; v < 8; v++) sum += cosines[8 * y + v] * halves[8 * v + x];
      sums[8 * y + x] = sum;
    }
  }
  return sums;
}
