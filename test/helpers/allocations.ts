/**
 * The bytes of the largest array, and of all arrays together, that are allocated while a function runs. Arrays that are allocated inside
 * of fflate or the browser are not counted.
 */
export interface Allocations {
  readonly largest: number;
  readonly sum: number;
}

const arrays = ['Uint8Array', 'Uint16Array', 'Uint32Array', 'Int32Array', 'Float32Array', 'Float64Array'] as const;

/** Run a function, and record the arrays that it allocates by length. An error that it throws is returned with the result. */
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
