/** How far two pictures are apart, 1/255. */
export interface PictureDifference {
  /** Root mean square over all pixels and the four premultiplied channels. */
  readonly rms: number;
  /** 99th percentile over the pixels of the worst channel. */
  readonly p99: number;
}

/**
 * How two pictures in floats differ, over all pixels.
 * @param a - RGBA, premultiplied, 0..1
 */
export function comparePictures(a: Float32Array, b: Float32Array): PictureDifference {
  const worst = new Float64Array(a.length / 4);
  let sum = 0;
  for (let i = 0; i < a.length; i++) {
    const difference = Math.abs(a[i] - b[i]) * 255;
    sum += difference ** 2;
    if (difference > worst[i >> 2]) worst[i >> 2] = difference;
  }
  worst.sort();
  return { rms: Math.sqrt(sum / a.length), p99: worst[Math.min(worst.length - 1, Math.floor(worst.length * 0.99))] };
}
