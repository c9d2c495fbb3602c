/** Whole numbers that stand for things, as places in a list of them. */
export interface IndexedSamples {
  /** Of each voxel: where its number stands in `ids`. */
  readonly samples: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /** The different numbers, rising. */
  readonly ids: readonly number[];
}

/** What float32 makes of whole numbers: how many are rounded, and by how much at most. */
export interface Rounded {
  readonly count: number;
  readonly by: number;
}

/** Labels that can be told apart at most: as many as two bytes hold. */
export const mostLabels = 65_536;

/**
 * Put whole numbers into a list, and their places in it in their stead: so each keeps all of its digits, however large it is.
 * @param idOf - the number that a stored value stands for
 * @returns null where one is no whole number that float64 holds, or there are more than 65,536
 */
export function indexNumbers<T extends number | bigint>(stored: ArrayLike<T>, idOf: (value: T) => number): IndexedSamples | null {
  const found = new Map<T, number>();
  for (let i = 0; i < stored.length; i++) {
    if (i > 0 && stored[i] === stored[i - 1] || found.has(stored[i])) continue;
    const id = idOf(stored[i]);
    if (found.size === mostLabels || !Number.isSafeInteger(id)) return null;
    found.set(stored[i], id || 0);
  }
  const ids = [...new Set(found.values())];
  ids.sort((a, b) => a - b);
  const places = new Map(ids.map((id, place) => [id, place]));
  for (const [value, id] of found) found.set(value, places.get(id)!);
  const samples = new (ids.length <= 2 ** 8 ? Uint8Array : Uint16Array)(stored.length);
  for (let i = 0; i < stored.length; i++) samples[i] = i > 0 && stored[i] === stored[i - 1] ? samples[i - 1] : found.get(stored[i])!;
  return { samples, ids };
}

/** The data value of a stored one. */
export function valueOf({ slope, intercept, ids }: { readonly slope: number; readonly intercept: number; readonly ids?: readonly number[] }, stored: number): number {
  return ids ? (ids[stored] ?? NaN) : slope * stored + intercept;
}
