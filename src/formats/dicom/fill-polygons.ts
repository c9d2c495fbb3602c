import type { Budget } from '../base/budget.ts';

/** A closed line in a grid: column and row of its points, in turns. */
export type Polygon = Float64Array;

/**
 * Lists the pixels whose middles lie inside an odd number of closed lines: so a line in another one is a hole, whether it is a line of its
 * own or joined to the outer one by a bridge there and back. A middle on a line belongs to one of its two sides, always the same.
 * @param what - for messages
 * @param onRun - gets a row, its first pixel and the one after its last
 * @throws {VolumeViewError} `format/too-large`
 */
export function fillPolygons(
  polygons: readonly Polygon[],
  { columns, rows }: { readonly columns: number; readonly rows: number },
  { budget, what }: { readonly budget: Budget; readonly what: string },
  onRun: (row: number, begin: number, end: number) => void,
): void {
  // Where lines cross each row is counted first, so that one array holds all of it.
  const starts = new Uint32Array(rows + 1);
  const eachCrossing = (act: (row: number, column: number) => void): void => {
    for (const points of polygons) {
      const last = points.length - 2;
      for (let at = 0, before = last; at < points.length; before = at, at += 2) {
        // Always upwards: a bridge crosses a row at the same place on its way there and back.
        const [lower, upper] = points[before + 1] < points[at + 1] ? [before, at] : [at, before];
        const [x, y] = [points[lower], points[lower + 1]];
        const slope = (points[upper] - x) / (points[upper + 1] - y);
        const [first, end] = [Math.max(0, Math.ceil(y)), Math.min(rows, Math.ceil(points[upper + 1]))];
        budget.step(1 + Math.max(0, end - first), what);
        for (let row = first; row < end; row++) act(row, x + (row - y) * slope);
      }
    }
  };
  eachCrossing((row) => starts[row + 1]++);
  for (let row = 0; row < rows; row++) starts[row + 1] += starts[row];
  const bytes = 8 * starts[rows];
  budget.take(bytes, what);
  const crossings = new Float64Array(starts[rows]);
  const next = starts.slice(0, rows);
  eachCrossing((row, column) => (crossings[next[row]++] = column));
  for (let row = 0; row < rows; row++) {
    const inRow = crossings.subarray(starts[row], starts[row + 1]);
    inRow.sort();
    for (let i = 0; i + 1 < inRow.length; i += 2) {
      const [begin, end] = [Math.max(0, Math.ceil(inRow[i])), Math.min(columns, Math.ceil(inRow[i + 1]))];
      if (begin < end) onRun(row, begin, end);
    }
  }
  budget.giveBack(bytes);
}
