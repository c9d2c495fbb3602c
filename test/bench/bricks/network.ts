/** A connection: seconds from a request to its first byte, and bytes a second of all answers together. */
export interface Network {
  readonly delay: number;
  readonly bandwidth: number;
}

/**
 * Seconds until all of some answers have come, after each of them. At most `atOnce` requests are under way; answers use the connection one after the
 * other.
 * @param bytes - of the answers, in the order of the requests
 * @param first - so many of them must have come before another one is asked for: what the order of the others depends on
 */
export function arrivalTimes(
  bytes: readonly number[],
  { delay, bandwidth }: Network,
  { atOnce, first }: { readonly atOnce: number; readonly first: number },
): Float64Array {
  const times = new Float64Array(bytes.length);
  let idle = 0;
  let begun = 0;
  bytes.forEach((size, n) => {
    if (n === first) begun = times[n - 1] ?? 0;
    const asked = Math.max(begun, n >= atOnce ? times[n - atOnce] : 0);
    idle = Math.max(idle, asked + delay) + size / bandwidth;
    times[n] = idle;
  });
  return times;
}
