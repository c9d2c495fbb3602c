// Lossless JPEG: each number is the difference from what its neighbours predict. Source: ITU-T T.81, annex H
import { corruptFile } from '../base/file-problem.ts';
import { JpegBits } from './jpeg-huffman.ts';
import type { JpegParts } from './jpeg-parts.ts';

/** @param numbers - of the whole frame, to be written */
export function unpackLossless(parts: JpegParts, numbers: Uint16Array): void {
  const { rows, columns, precision, restart, what } = parts;
  const [{ first: table }] = parts.components;
  const [predictor, , low] = parts.selected;
  const shift = low & 15;
  if (!table || !(predictor >= 1 && predictor <= 7) || shift >= precision || restart % columns !== 0)
    throw corruptFile(what, 'has packed pixels (lossless JPEG) that are damaged; copy the file again');
  const bits = new JpegBits(parts.bytes, parts.start, what);
  const middle = 2 ** (precision - shift - 1);
  for (let row = 0; row < rows; row++) {
    const isStart = row === 0 || (restart > 0 && (row * columns) % restart === 0);
    if (isStart && row > 0) bits.restart();
    const start = row * columns;
    for (let i = 0; i < columns; i++) {
      const at = start + i;
      const size = bits.readSymbol(table);
      const difference = size === 16 ? 32768 : bits.readSigned(size & 15);
      const [left, above] = [numbers[at - 1], numbers[at - columns]];
      const predicted = isStart
        ? i === 0
          ? middle
          : left
        : i === 0
          ? above
          : predict(predictor, left, above, numbers[at - columns - 1]);
      numbers[at] = predicted + difference;
    }
    bits.check();
  }
  if (shift > 0) for (let i = 0; i < numbers.length; i++) numbers[i] <<= shift;
}

function predict(predictor: number, left: number, above: number, corner: number): number {
  switch (predictor) {
    case 1:
      return left;
    case 2:
      return above;
    case 3:
      return corner;
    case 4:
      return left + above - corner;
    case 5:
      return left + ((above - corner) >> 1);
    case 6:
      return above + ((left - corner) >> 1);
    default:
      return (left + above) >> 1;
  }
}
