/** Letters of 5 x 7 points, a row a number of five bits. */
const letters: readonly (readonly number[])[] = [
  [0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001],
  [0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111],
  [0b10001, 0b11001, 0b10101, 0b10101, 0b10011, 0b10001, 0b10001],
  [0b10001, 0b01010, 0b00100, 0b00100, 0b00100, 0b01010, 0b10001],
  [0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001],
];

/** The points of a page of such letters, a margin of 4 around it. */
export function drawText(edge: number): (readonly [number, number])[] {
  const points: [number, number][] = [];
  for (let line = 0; 4 + 10 * line + 7 <= edge - 4; line++) {
    for (let column = 0; 4 + 7 * column + 5 <= edge - 4; column++) {
      letters[(line + 2 * column) % letters.length].forEach((bits, row) => {
        for (let i = 0; i < 5; i++) if ((bits >> (4 - i)) & 1) points.push([4 + 7 * column + i, 4 + 10 * line + row]);
      });
    }
  }
  return points;
}
