import type { PictureError } from '../../src/quality/error-estimate.ts';

/**
 * How two pictures in floats differ, in 1/255 and by the measure of `renderStats.error`: root mean square over all
 * pixels and the four premultiplied channels; 99th percentile over the pixels of the worst channel.
 * @param a - RGBA, premultiplied, 0..1
 */
export function comparePictures(a: Float32Array, b: Float32Array): PictureError {
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
