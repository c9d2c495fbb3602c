import type { VolumeScene } from '../../src/x3d/scene.ts';

/** Pixels of a scene's last picture: width * height * 4 bytes, premultiplied, top row first. */
export function readPixels(scene: Pick<VolumeScene, 'readPicture'>): Uint8ClampedArray<ArrayBuffer> {
  const { data, width, height } = scene.readPicture();
  const pixels = new Uint8ClampedArray(data.length);
  for (let row = 0; row < height; row++) {
    const from = (height - 1 - row) * width * 4;
    pixels.set(data.subarray(from, from + width * 4), row * width * 4);
  }
  return pixels;
}
