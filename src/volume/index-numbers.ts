/** Whole numbers that stand for things, stored as indices into a list of them. */
export interface IndexedSamples {
  /** For each voxel the index of its number in `ids`. */
  readonly samples: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /** The different numbers, ascending. */
  readonly ids: readonly number[];
}

/** The error of whole numbers in float32: how many are rounded, and by how much at most. */
export interface Rounded {
  readonly count: number;
  readonly by: number;
}

/** Numbers that can't be stored among the others of their file. */
export interface Unkept {
  /** How many are infinite: they become no data. */
  readonly infinite: number;
  /** How many lie so near to the offset, compared with the largest, that their samples become 0 or lose digits. */
  readonly small: number;
}

/** Maximum number of different labels: two bytes can index so many. */
export const maxLabels = 65_536;

/**
 * Puts whole numbers into a list, and replaces them by their indices: so each keeps all of its digits, however large it
 * is.
 * @param idOf - the number that a stored value stands for
 * @returns null if one is not a whole number that float64 holds exactly, or there are more than 65,536
 */
export function indexNumbers<T extends number | bigint>(
  stored: ArrayLike<T>,
  idOf: (value: T) => number,
): IndexedSamples | null {
  const found = new Map<T, number>();
  for (let i = 0; i < stored.length; i++) {
    if ((i > 0 && stored[i] === stored[i - 1]) || found.has(stored[i])) continue;
    const id = idOf(stored[i]);
    if (found.size === maxLabels || !Number.isSafeInteger(id)) return null;
    found.set(stored[i], id || 0);
  }
  const ids = [...new Set(found.values())];
  ids.sort((a, b) => a - b);
  const places = new Map(ids.map((id, place) => [id, place]));
  for (const [value, id] of found) found.set(value, places.get(id)!);
  const samples = new (ids.length <= 2 ** 8 ? Uint8Array : Uint16Array)(stored.length);
  for (let i = 0; i < stored.length; i++)
    samples[i] = i > 0 && stored[i] === stored[i - 1] ? samples[i - 1] : found.get(stored[i])!;
  return { samples, ids };
}

/** The data value of a stored one. */
export function valueOf(
  { slope, intercept, ids }: { readonly slope: number; readonly intercept: number; readonly ids?: readonly number[] },
  stored: number,
): number {
  return ids ? (ids[stored] ?? NaN) : slope * stored + intercept;
}
