/**
 * Stored samples. Signed 8- and 16-bit files are shifted to unsigned and wider types become float. `slope` and
 * `intercept` undo the shift, so textures and shaders have to know only three types.
 */
export type Samples = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>;

/** An empty array of the samples' own type. */
export function allocateLike(samples: Samples, length: number): Samples {
  return new (samples.constructor as new (length: number) => Samples)(length);
}
