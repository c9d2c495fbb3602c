/** Finds the column of a value: bins of equal width over the domain, with at most one edge of a column in each. */
export interface ColumnBins {
  /** Shape [bins, 4]: the number of the column at the bin's start, where this column begins and ends, and where the next one ends. */
  readonly texels: Float32Array<ArrayBuffer>;
  /** A power of two. */
  readonly count: number;
}

const fewest = 2 ** 6;
const max = 2 ** 18;

/** Values farther below 0 or above 1 do not occur in the data and have no bin. */
const margin = 1e-3;

/** @param edges - see Columns @param min - the smallest number of bins, a power of two @returns null if edges are too close together */
export function binColumns(edges: Float32Array, min = fewest): ColumnBins | null {
  for (let count = min; count <= max; count *= 2) if (areApart(edges, count)) return fill(edges, count);
  return null;
}

/** Whether each bin holds at most one edge. */
function areApart(edges: Float32Array, count: number): boolean {
  const binOf = (edge: number): number => Math.min(count - 1, Math.max(0, Math.floor(edge * count)));
  const within = edges.filter((edge) => edge > -margin && edge < 1 + margin);
  return within.every((edge, i) => i === 0 || binOf(edge) !== binOf(within[i - 1]));
}

function fill(edges: Float32Array, count: number): ColumnBins {
  const texels = new Float32Array(count * 4);
  for (let bin = 0, column = 0; bin < count; bin++) {
    const begin = bin === 0 ? -margin : bin / count;
    while (edges[column + 1] <= begin) column++;
    texels.set([column, edges[column], edges[column + 1], edges[Math.min(column + 2, edges.length - 1)]], bin * 4);
  }
  return { texels, count };
}
