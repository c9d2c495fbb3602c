import type { Vector3 } from '../volume/matrix.ts';

/** Tiles of a mosaic. */
export interface TileLayout {
  readonly columns: number;
  readonly rows: number;
}

/**
 * How slices lie in one image of at most `maxEdge` pixels along each edge: with the fewest pixels, and of these the one that is nearest
 * to a square. null if they do not fit.
 * @param dimensions - columns and rows of a slice, and slices
 */
export function layOut([nx, ny, nz]: Vector3, maxEdge: number): TileLayout | null {
  let best: (TileLayout & { readonly pixels: number; readonly edge: number }) | null = null;
  for (let columns = Math.min(nz, Math.floor(maxEdge / nx)); columns >= 1; columns--) {
    const rows = Math.ceil(nz / columns);
    if (rows * ny > maxEdge) break; // With fewer columns there are more rows.
    const pixels = columns * nx * rows * ny;
    const edge = Math.max(columns * nx, rows * ny);
    // A few empty tiles pack to nothing; a long strip is a problem for other programs.
    const cost = (one: { pixels: number; edge: number }): number => one.edge * Math.max(1, one.pixels / (nx * ny * nz));
    if (!best || cost({ pixels, edge }) < cost(best)) best = { columns, rows, pixels, edge };
  }
  return best && { columns: best.columns, rows: best.rows };
}
