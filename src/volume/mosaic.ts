import { VolumeViewError } from '../core/errors.ts';
import type { Vector3 } from './matrix.ts';
import type { Samples } from './samples.ts';

/** How a volume's slices lie in one image: tiles row by row from the top left. */
export interface MosaicLayout {
  readonly columns: number;
  readonly rows: number;
  /** Tiles in use; the others are ignored. */
  readonly slices: number;
}

/** An image of one channel, row by row from the top left. */
export interface GrayImage {
  readonly width: number;
  readonly height: number;
  /** `width * height` values. */
  readonly data: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /** What of the picture is not in it, in words; absent where all is. */
  readonly left?: readonly string[];
}

/**
 * The layout of a mosaic, checked against its image.
 * @param size - image in pixels
 * @param tiles - tiles per row and column
 * @param slices - tiles in use; all of them if undefined
 * @throws {VolumeViewError} `mosaic/layout`
 */
export function checkMosaicLayout(
  size: { width: number; height: number },
  tiles: { columns: number; rows: number },
  slices?: number,
): MosaicLayout {
  const { columns, rows } = tiles;
  const fail = (what: string): never => {
    throw new VolumeViewError('mosaic/layout', what);
  };
  if (!isCount(columns) || !isCount(rows)) {
    fail(`mosaic got ${columns} x ${rows} tiles; expected two whole numbers from 1`);
  }
  if (columns > size.width || rows > size.height) {
    fail(
      `mosaic got ${columns} x ${rows} tiles for an image of ${size.width} x ${size.height} pixels, which makes tiles ` +
        'of less than one pixel; check mosaic="COLUMNSxROWS"',
    );
  }
  const used = slices ?? columns * rows;
  if (!isCount(used) || used > columns * rows) {
    fail(
      `slices got ${used}; expected a whole number from 1 to ${columns * rows}, the tiles of a ${columns}x${rows} mosaic`,
    );
  }
  return { columns, rows, slices: used };
}

/** Width and height of a tile in image pixels; need not be whole numbers. */
export function measureTile(size: { width: number; height: number }, layout: MosaicLayout): [number, number] {
  return [size.width / layout.columns, size.height / layout.rows];
}

/**
 * Voxels of the volume that a mosaic holds. If a tile is not a whole number of pixels, its voxels are rounded to the
 * nearest whole number.
 * @returns nx, ny, nz
 */
export function mosaicDimensions(size: { width: number; height: number }, layout: MosaicLayout): Vector3 {
  const [width, height] = measureTile(size, layout);
  return [Math.round(width), Math.round(height), layout.slices];
}

/**
 * Cuts a mosaic into a volume's samples: columns along i, rows along j, tiles along k. Tiles of whole pixels are copied
 * as they are. Others are sampled linearly at equal distances, and only from pixels whose centres lie inside the tile,
 * so that no neighbour bleeds in.
 * @returns `nx * ny * nz` values of the image's own type, i fastest
 */
export function cutMosaic(image: GrayImage, layout: MosaicLayout): Samples {
  const [nx, ny, nz] = mosaicDimensions(image, layout);
  const columns = Array.from({ length: layout.columns }, (_, tile) => placeSamples(image.width, layout.columns, tile));
  const rows = Array.from({ length: layout.rows }, (_, tile) => placeSamples(image.height, layout.rows, tile));
  const samples = image.data instanceof Uint8Array ? new Uint8Array(nx * ny * nz) : new Uint16Array(nx * ny * nz);
  const exact = image.width % layout.columns === 0 && image.height % layout.rows === 0;
  for (let k = 0; k < nz; k++) {
    const across = columns[k % layout.columns];
    const down = rows[Math.floor(k / layout.columns)];
    for (let j = 0; j < ny; j++) {
      const to = (k * ny + j) * nx;
      if (exact) {
        const from = down.lower[j] * image.width + across.lower[0];
        samples.set(image.data.subarray(from, from + nx), to);
      } else {
        sampleRow(
          image,
          across,
          { lower: down.lower[j], upper: down.upper[j], weight: down.weight[j] },
          samples.subarray(to, to + nx),
        );
      }
    }
  }
  return samples;
}

/** Where the samples of one tile lie along one axis: value = (1 - weight) * pixel[lower] + weight * pixel[upper]. */
interface Placement {
  readonly lower: Int32Array;
  readonly upper: Int32Array;
  readonly weight: Float64Array;
}

function placeSamples(pixels: number, tiles: number, tile: number): Placement {
  const count = Math.round(pixels / tiles);
  const start = (tile * pixels) / tiles;
  const end = ((tile + 1) * pixels) / tiles;
  // Pixel p has its centre at p + 0.5; the tile is the half-open [start, end).
  const first = Math.ceil(start - 0.5);
  const last = Math.ceil(end - 0.5) - 1;
  const lower = new Int32Array(count);
  const upper = new Int32Array(count);
  const weight = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const position = start + ((i + 0.5) * (end - start)) / count - 0.5;
    const inside = Math.min(last, Math.max(first, position));
    lower[i] = Math.floor(inside);
    upper[i] = Math.min(last, lower[i] + 1);
    weight[i] = inside - lower[i];
  }
  return { lower, upper, weight };
}

/** One row of voxels, bilinearly, rounded to the nearest stored value. */
function sampleRow(
  image: GrayImage,
  across: Placement,
  down: { lower: number; upper: number; weight: number },
  row: Samples,
): void {
  const { data, width } = image;
  const top = down.lower * width;
  const bottom = down.upper * width;
  for (let i = 0; i < row.length; i++) {
    const left = across.lower[i];
    const right = across.upper[i];
    const x = across.weight[i];
    const above = data[top + left] + x * (data[top + right] - data[top + left]);
    const below = data[bottom + left] + x * (data[bottom + right] - data[bottom + left]);
    row[i] = Math.floor(above + down.weight * (below - above) + 0.5);
  }
}

function isCount(value: number): boolean {
  return Number.isSafeInteger(value) && value > 0;
}
