import { decode } from 'fast-png';

/** A picture: premultiplied, 0..255, top row first. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Float64Array;
}

/** A PNG file's pixels. */
export function decodePicture(file: Uint8Array): Picture {
  const { width, height, data, channels } = decode(file);
  const picture = new Float64Array(width * height * 4);
  for (let i = 0; i < width * height; i++) {
    const alpha = channels === 4 ? data[i * 4 + 3] / 255 : 1;
    for (let c = 0; c < 3; c++) picture[i * 4 + c] = data[i * channels + c] * alpha;
    picture[i * 4 + 3] = alpha * 255;
  }
  return { width, height, data: picture };
}

/** How two pictures of one size differ, in 1/255. */
export function comparePictures(a: Picture, b: Picture): { worst: number; rmse: number } {
  let [worst, sum] = [0, 0];
  for (let i = 0; i < a.data.length; i++) {
    const difference = Math.abs(a.data[i] - b.data[i]);
    worst = Math.max(worst, difference);
    sum += difference ** 2;
  }
  return { worst, rmse: Math.sqrt(sum / a.data.length) };
}

/** How much light and matter is in a picture: mean of each channel. */
export function meanOf({ data }: Picture): [number, number, number, number] {
  const sums: [number, number, number, number] = [0, 0, 0, 0];
  data.forEach((x, i) => (sums[i % 4] += x / (data.length / 4)));
  return sums;
}
