// Pyramids whose chunks are computed when they are asked for, with detail at every scale: they may be larger than any disk.
import { crc32c } from '../../src/formats/codecs/crc32c.ts';
import { jsonBytes } from './zarr-bytes.ts';

export interface FormulaPyramid {
  /** Voxels along x, y and z: 2^levels divides them, so that all levels are exact means. */
  readonly dimensions: readonly [number, number, number];
  readonly levels: number;
  readonly type?: 'uint8' | 'uint16';
  /** Voxels of a chunk along each axis; 32 if undefined. */
  readonly chunk?: number;
  /** Chunks of a shard along each axis; without shards if undefined. */
  readonly perShard?: number;
  /** Whether a chunk is left out: its voxels have the fill value 7. @param at - its place along x, y and z */
  readonly isMissing?: (level: number, at: readonly number[]) => boolean;
}

/** What voxels of missing chunks have. */
export const formulaFill = 7;

/** Waves of the shortest length, voxels; each further one is longer by the second number. They are no whole numbers, so that nothing repeats. */
const [shortest, longer] = [2.9, 2.03];

/** The share of the range that all waves together have. */
const share = 0.9;

/** The waves of an axis: sin(step * x + start). */
function wavesOf(length: number): { readonly step: number; readonly start: readonly [number, number, number] }[] {
  const waves = [];
  for (let wave = shortest, n = 0; wave < 2 * length; wave *= longer, n++)
    waves.push({ step: (2 * Math.PI) / wave, start: [0.3 + n, 1.1 + 2 * n, 2.3 + 3 * n] as const });
  return waves;
}

export interface Formula {
  readonly pyramid: FormulaPyramid;
  /** Voxels along x, y and z of a level. */
  dimensionsOf(level: number): [number, number, number];
  /** Values of a box of a level, x fastest. Voxels outside of the level have the value of the nearest one in it; those of missing chunks the fill value. */
  boxOf(level: number, first: readonly number[], size: readonly number[]): Uint8Array | Uint16Array;
}

/** Values of levels that are means of 2^level voxels along each axis, rounded once: products of waves, whose means are known. */
export function formulaOf(pyramid: FormulaPyramid): Formula {
  const { dimensions, type = 'uint8', chunk = 32, isMissing } = pyramid;
  const waves = wavesOf(Math.max(...dimensions));
  const top = type === 'uint8' ? 255 : 65535;
  const amplitude = (share * top) / 2 / waves.length;
  const dimensionsOf = (level: number): [number, number, number] =>
    dimensions.map((n) => n / 2 ** level) as [number, number, number];
  return {
    pyramid,
    dimensionsOf,
    boxOf(level, first, size) {
      const ends = dimensionsOf(level);
      const places = size.map((n, axis) =>
        Array.from({ length: n }, (_, i) => Math.min(ends[axis] - 1, Math.max(0, first[axis] + i))),
      );
      const width = 2 ** level;
      // The mean of a wave over `width` voxels is the wave in their middle, times this (Dirichlet's kernel).
      const tables = waves.map(({ step, start }) => {
        const damping = Math.sin((width * step) / 2) / (width * Math.sin(step / 2));
        return places.map((all, axis) =>
          all.map((n) => damping * Math.sin(step * (width * n + (width - 1) / 2) + start[axis])),
        );
      });
      const [nx, ny, nz] = size;
      const values = new (type === 'uint8' ? Uint8Array : Uint16Array)(nx * ny * nz);
      const row = new Float64Array(nx);
      for (let k = 0, to = 0; k < nz; k++)
        for (let j = 0; j < ny; j++, to += nx) {
          row.fill(top / 2);
          for (const [xs, ys, zs] of tables) {
            const factor = amplitude * ys[j] * zs[k];
            for (let i = 0; i < nx; i++) row[i] += factor * xs[i];
          }
          for (let i = 0; i < nx; i++) values[to + i] = Math.round(row[i]);
          if (!isMissing) continue;
          const [cj, ck] = [Math.floor(places[1][j] / chunk), Math.floor(places[2][k] / chunk)];
          for (let i = 0, last = -1, isGone = false; i < nx; i++) {
            const ci = Math.floor(places[0][i] / chunk);
            if (ci !== last) isGone = isMissing(level, [(last = ci), cj, ck]);
            if (isGone) values[to + i] = formulaFill;
          }
        }
      return values;
    },
  };
}

/** The files of an OME-Zarr 0.5 whose chunks are computed. */
export interface FormulaFiles {
  /** Bytes of a file; null where there is none. */
  sizeOf(path: string): number | null;
  /** A part of a file that is there. */
  bytesOf(path: string, start: number, end: number): Uint8Array<ArrayBuffer>;
}

/** @param formula - of the values */
export function formulaFiles(formula: Formula): FormulaFiles {
  const { pyramid, dimensionsOf, boxOf } = formula;
  const { levels, type = 'uint8', chunk = 32, perShard, isMissing } = pyramid;
  const metadata = new Map([
    ['zarr.json', groupOf(pyramid)],
    ...Array.from(
      { length: levels },
      (_, level) => [`${level}/zarr.json`, arrayOf(dimensionsOf(level), { type, chunk, perShard })] as const,
    ),
  ]);
  const bytes = chunk ** 3 * (type === 'uint8' ? 1 : 2);
  const count = perShard ? perShard ** 3 : 1;
  /** The place of a file of chunks, x first; null for what is none. */
  const placeOf = (path: string): { readonly level: number; readonly at: number[] } | null => {
    const [, level, z, y, x] = /^(\d+)\/c\/(\d+)\/(\d+)\/(\d+)$/.exec(path) ?? [];
    if (level === undefined || Number(level) >= levels) return null;
    const at = [Number(x), Number(y), Number(z)];
    const isInside = at.every((n, axis) => n * chunk * (perShard ?? 1) < dimensionsOf(Number(level))[axis]);
    return isInside && (perShard || !isMissing?.(Number(level), at)) ? { level: Number(level), at } : null;
  };
  const chunkOf = (level: number, at: readonly number[]): Uint8Array => {
    const { buffer } = boxOf(
      level,
      at.map((n) => n * chunk),
      [chunk, chunk, chunk],
    );
    return new Uint8Array(buffer);
  };
  /** Places of the chunks of a shard, in the order of its index. */
  const inShard = (at: readonly number[]): number[][] =>
    Array.from({ length: count }, (_, n) => {
      const side = perShard!;
      return [n % side, Math.floor(n / side) % side, Math.floor(n / side ** 2)].map(
        (one, axis) => at[axis] * side + one,
      );
    });
  const indexOf = (level: number, at: readonly number[]): Uint8Array => {
    const view = new DataView(new ArrayBuffer(16 * count + 4));
    for (const [n, place] of inShard(at).entries()) {
      const isThere = place.every((one, axis) => one * chunk < dimensionsOf(level)[axis]) && !isMissing?.(level, place);
      view.setBigUint64(16 * n, isThere ? BigInt(n * bytes) : 2n ** 64n - 1n, true);
      view.setBigUint64(16 * n + 8, isThere ? BigInt(bytes) : 2n ** 64n - 1n, true);
    }
    const index = new Uint8Array(view.buffer);
    view.setUint32(16 * count, crc32c(index.subarray(0, -4)), true);
    return index;
  };
  return {
    sizeOf(path) {
      const text = metadata.get(path);
      if (text) return text.length;
      return placeOf(path) && (perShard ? bytes * count + 16 * count + 4 : bytes);
    },
    bytesOf(path, start, end) {
      const text = metadata.get(path);
      if (text) return text.slice(start, end);
      const { level, at } = placeOf(path)!;
      if (!perShard) return new Uint8Array(chunkOf(level, at).slice(start, end));
      const part = new Uint8Array(end - start);
      const put = (from: number, own: Uint8Array): void => {
        const [a, b] = [Math.max(start, from), Math.min(end, from + own.length)];
        if (b > a) part.set(own.subarray(a - from, b - from), a - start);
      };
      for (const [n, place] of inShard(at).entries())
        if (n * bytes < end && (n + 1) * bytes > start) put(n * bytes, chunkOf(level, place));
      if (end > count * bytes) put(count * bytes, indexOf(level, at));
      return part;
    },
  };
}

function groupOf({ levels }: FormulaPyramid): Uint8Array<ArrayBuffer> {
  return jsonBytes({
    zarr_format: 3,
    node_type: 'group',
    attributes: {
      ome: {
        version: '0.5',
        multiscales: [
          {
            name: 'formula',
            axes: ['z', 'y', 'x'].map((name) => ({ name, type: 'space', unit: 'millimeter' })),
            datasets: Array.from({ length: levels }, (_, level) => ({
              path: String(level),
              coordinateTransformations: [
                { type: 'scale', scale: [2 ** level, 2 ** level, 2 ** level] },
                { type: 'translation', translation: Array.from({ length: 3 }, () => (2 ** level - 1) / 2) },
              ],
            })),
          },
        ],
      },
    },
  });
}

function arrayOf(
  dimensions: readonly number[],
  { type, chunk, perShard }: { readonly type: string; readonly chunk: number; readonly perShard?: number },
): Uint8Array<ArrayBuffer> {
  const little = type === 'uint8' ? { name: 'bytes' } : { name: 'bytes', configuration: { endian: 'little' } };
  const side = chunk * (perShard ?? 1);
  const sharding = {
    name: 'sharding_indexed',
    configuration: {
      chunk_shape: [chunk, chunk, chunk],
      codecs: [little],
      index_codecs: [{ name: 'bytes', configuration: { endian: 'little' } }, { name: 'crc32c' }],
    },
  };
  return jsonBytes({
    zarr_format: 3,
    node_type: 'array',
    shape: [dimensions[2], dimensions[1], dimensions[0]],
    data_type: type,
    chunk_grid: { name: 'regular', configuration: { chunk_shape: [side, side, side] } },
    chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
    fill_value: formulaFill,
    codecs: perShard ? [sharding] : [little],
    attributes: {},
  });
}
