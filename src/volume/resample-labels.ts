import type { CartesianGrid } from './grid.ts';
import { maxLabels, valueOf } from './index-numbers.ts';
import type { LabelMap } from './labels.ts';
import { invertAffine, multiply } from './matrix.ts';
import type { Samples } from './samples.ts';

/** A label file's voxels. */
export interface LabelVoxels {
  readonly grid: CartesianGrid;
  readonly samples: Samples;
  /** Id = slope * sample + intercept, or `ids[sample]` if there are `ids`. */
  readonly slope: number;
  readonly intercept: number;
  readonly ids?: readonly number[];
}

/** The id of a voxel without label, inside the file and around it. */
export const noLabel = 0;

/** The maximum distance of an id from a whole number: float32 and a slope may cause so much. */
export const tolerance = 1e-3;

/** Why voxels are not labels. */
export type LabelProblem =
  | { readonly problem: 'not-whole' | 'too-large'; readonly value: number }
  | { readonly problem: 'too-many' };

/** A file's ids, first that of no label, then the others ascending; and the index of each stored value's id among them. */
export interface FoundLabels {
  readonly ids: readonly number[];
  /** Takes the stored value. */
  readonly numberOf: (stored: number) => number;
}

/** The different ids of a file, including 0; samples without data count as 0. */
export function findLabels(voxels: Omit<LabelVoxels, 'grid'>): FoundLabels | LabelProblem {
  const { samples } = voxels;
  const idOf = new Map<number, number>();
  for (const stored of differentOf(samples)) {
    const value = Number.isFinite(stored) ? valueOf(voxels, stored) : noLabel;
    const id = Math.round(value) || noLabel;
    if (!(Math.abs(value - id) <= tolerance)) return { problem: 'not-whole', value };
    if (!Number.isSafeInteger(id)) return { problem: 'too-large', value };
    if (idOf.size >= maxLabels) return { problem: 'too-many' };
    idOf.set(stored, id);
  }
  const things = [...new Set(idOf.values())].filter((id) => id !== noLabel);
  if (things.length >= maxLabels) return { problem: 'too-many' };
  things.sort((a, b) => a - b);
  const ids = [noLabel, ...things];
  const places = new Map(ids.map((id, place) => [id, place]));
  const table = new Map(Array.from(idOf, ([stored, id]) => [stored, places.get(id)!]));
  if (samples instanceof Float32Array) return { ids, numberOf: (stored) => table.get(stored) ?? 0 };
  const quick = new Uint16Array(2 ** (8 * samples.BYTES_PER_ELEMENT));
  for (const [stored, place] of table) quick[stored] = place;
  return { ids, numberOf: (stored) => quick[stored] };
}

/** The different values, each once; only some of them if there are more than labels may have. */
function differentOf(samples: Samples): Iterable<number> {
  if (!(samples instanceof Float32Array)) {
    const seen = new Uint8Array(2 ** (8 * samples.BYTES_PER_ELEMENT));
    for (let i = 0; i < samples.length; i++) seen[samples[i]] = 1;
    return Array.from(seen.keys()).filter((value) => seen[value] === 1);
  }
  const found = new Set<number>();
  let last = Infinity; // No sample is infinite.
  for (let i = 0; i < samples.length && found.size <= maxLabels + 1; i++) {
    if (samples[i] === last) continue;
    last = samples[i];
    found.add(last);
  }
  return found;
}

/** The resampled labels, and how many voxels got one. */
export interface ResampledLabels {
  readonly map: LabelMap;
  /** Number of voxels that lie within the label file. */
  readonly within: number;
}

/**
 * Resamples labels to another grid: each voxel's centre gets the label of the file's voxel that contains it (the
 * nearest one); outside the file there is none. It yields after each slice, so that a page can draw meanwhile.
 */
export function* resampleLabels(
  voxels: LabelVoxels,
  { ids, numberOf }: FoundLabels,
  target: CartesianGrid,
): Generator<void, ResampledLabels> {
  const {
    grid: {
      dimensions: [mx, my, mz],
      indexToWorld,
    },
    samples,
  } = voxels;
  const [nx, ny, nz] = target.dimensions;
  const numbers = new (ids.length <= 2 ** 8 ? Uint8Array : Uint16Array)(nx * ny * nz);
  // Entries next to a whole number are rounded: on the same grid, inverted twice, a voxel must stay in its place.
  const m = multiply(invertAffine(indexToWorld)!, target.indexToWorld).map((entry) =>
    Math.abs(entry - Math.round(entry)) < 1e-9 ? Math.round(entry) : entry,
  );
  let within = 0;
  let at = 0;
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      const x0 = m[1] * j + m[2] * k + m[3] + 0.5;
      const y0 = m[5] * j + m[6] * k + m[7] + 0.5;
      const z0 = m[9] * j + m[10] * k + m[11] + 0.5;
      for (let i = 0; i < nx; i++, at++) {
        const x = Math.floor(m[0] * i + x0);
        const y = Math.floor(m[4] * i + y0);
        const z = Math.floor(m[8] * i + z0);
        if (!(x >= 0 && x < mx && y >= 0 && y < my && z >= 0 && z < mz)) continue;
        numbers[at] = numberOf(samples[x + mx * (y + my * z)]);
        within++;
      }
    }
    yield;
  }
  return { map: { dimensions: target.dimensions, numbers, ids }, within };
}
