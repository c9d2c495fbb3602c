import type { Vector3 } from './matrix.ts';
import { allocateLike } from './samples.ts';
import type { Samples } from './samples.ts';

/** A mosaic of whole tiles that fits a texture. */
export interface AtlasLayout {
  readonly columns: number;
  readonly rows: number;
  /** Texels. */
  readonly width: number;
  readonly height: number;
}

/**
 * Arranges a volume's slices as tiles of a near-square image, for devices without 3D textures.
 * @param maxSize - longest edge that the device supports, texels
 * @returns null if no arrangement fits
 */
export function atlasLayout(dimensions: Vector3, maxSize: number): AtlasLayout | null {
  const [nx, ny, nz] = dimensions;
  const maxColumns = Math.min(nz, Math.floor(maxSize / nx));
  let best: AtlasLayout | null = null;
  for (let columns = 1; columns <= maxColumns; columns++) {
    const rows = Math.ceil(nz / columns);
    const layout = { columns, rows, width: columns * nx, height: rows * ny };
    if (layout.height > maxSize) continue;
    // The best layout has the shortest longer edge, because of devices' limits and the texture cache. Among equals, the
    // fewest texels.
    const edge = Math.max(layout.width, layout.height) - (best ? Math.max(best.width, best.height) : Infinity);
    if (!best || edge < 0 || (edge === 0 && layout.width * layout.height < best.width * best.height)) best = layout;
  }
  return best;
}

/**
 * Writes a volume's samples as an atlas.
 * @param band - rows of the atlas's texels to write; all of them if absent
 * @returns `layout.width * band.count` values of the samples' own type; unused tiles are 0
 */
export function packAtlas(
  samples: Samples,
  [nx, ny, nz]: Vector3,
  { columns, width, height }: AtlasLayout,
  band: { readonly first: number; readonly count: number } = { first: 0, count: height },
): Samples {
  const atlas = allocateLike(samples, width * band.count);
  for (let row = 0; row < band.count; row++) {
    const tileRow = Math.floor((band.first + row) / ny);
    const j = (band.first + row) % ny;
    const slices = Math.min(columns, nz - tileRow * columns);
    for (let column = 0; column < slices; column++) {
      const from = ((tileRow * columns + column) * ny + j) * nx;
      atlas.set(samples.subarray(from, from + nx), row * width + column * nx);
    }
  }
  return atlas;
}
