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

/** @param numbers - of the whole frame, to be written */
export function unpackDct(parts: JpegParts, numbers: Uint16Array): void {
  const { rows, columns, first, others, factors, precision, restart, what } = parts;
  if (!first || !others || !factors || (precision !== 8 && precision !== 12))
    throw corruptFile(
      what,
      'has packed pixels (JPEG) without tables, or of other than 8 and 12 bits; copy the file again',
    );
  const bits = new JpegBits(parts.bytes, parts.start, what);
  const coefficients = new Float64Array(64);
  const middle = 2 ** (precision - 1);
  const across = Math.ceil(columns / 8);
  const blocks = across * Math.ceil(rows / 8);
  let mean = 0;
  for (let block = 0; block < blocks; block++) {
    if (restart > 0 && block > 0 && block % restart === 0) {
      bits.restart();
      mean = 0;
    }
    mean = readBlock(bits, { first, others, factors, mean }, coefficients);
    bits.check();
    const pixels = sumCosines(coefficients);
    const [left, top] = [8 * (block % across), 8 * Math.floor(block / across)];
    for (let y = 0; y < 8 && top + y < rows; y++) {
      for (let x = 0; x < 8 && left + x < columns; x++) {
        const value = Math.round(pixels[8 * y + x] + middle);
        numbers[(top + y) * columns + left + x] = Math.max(0, Math.min(2 * middle - 1, value));
      }
    }
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
