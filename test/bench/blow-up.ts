/** A picture enlarged to a square as browsers enlarge a canvas: bilinear, between the centres of pixels. */
export function blowUp(
  pixels: ArrayLike<number>,
  { width, height }: { width: number; height: number },
  size: number,
): Float32Array {
  const blown = new Float32Array(size * size * 4);
  const place = (n: number, count: number): [number, number, number] => {
    const at = Math.min(count - 1, Math.max(0, ((n + 0.5) / size) * count - 0.5));
    return [Math.floor(at), Math.min(count - 1, Math.floor(at) + 1), at % 1];
  };
  for (let y = 0; y < size; y++) {
    const [top, bottom, down] = place(y, height);
    for (let x = 0; x < size; x++) {
      const [left, right, across] = place(x, width);
      for (let c = 0; c < 4; c++) {
        const row = (n: number): number =>
          pixels[(n * width + left) * 4 + c] * (1 - across) + pixels[(n * width + right) * 4 + c] * across;
        blown[(y * size + x) * 4 + c] = row(top) * (1 - down) + row(bottom) * down;
      }
    }
  }
  return blown;
}
