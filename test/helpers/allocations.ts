/** Most bytes of one array, and of all arrays, that are made while something runs. Those that are made inside of fflate or the browser are not seen. */
export interface Allocations {
  readonly largest: number;
  readonly sum: number;
}

const arrays = ['Uint8Array', 'Uint16Array', 'Uint32Array', 'Int32Array', 'Float32Array', 'Float64Array'] as const;

/** Run something, and see what arrays it asks for by their length. What it throws is thrown when they have been looked at. */
export async function watchAllocations(run: () => unknown): Promise<Allocations & { error: unknown }> {
  const own = arrays.map((name) => globalThis[name]);
  let [largest, sum] = [0, 0];
  for (const [i, name] of arrays.entries()) {
    const Own = own[i];
    const watched: typeof Own = new Proxy(Own, {
      construct: (target, given: [unknown], newTarget): object => {
        if (typeof given[0] === 'number') {
          const bytes = given[0] * Own.BYTES_PER_ELEMENT;
          largest = Math.max(largest, bytes);
          sum += bytes;
        }
        return Reflect.construct(target, given, newTarget === watched ? target : newTarget) as object;
      },
    });
    Object.assign(globalThis, { [name]: watched });
  }
  let error: unknown = null;
  try {
    await run();
  } catch (thrown) {
    error = thrown;
  } finally {
    arrays.forEach((name, i) => Object.assign(globalThis, { [name]: own[i] }));
  }
  return { largest, sum, error };
}
