/** A picture of bytes: RGBA, premultiplied, rows one after the other. */
export interface Pixels {
  readonly data: ArrayLike<number>;
  readonly width: number;
  readonly height: number;
}

/** Pixels interpolated between four pixels of a picture that has only every second pixel along each axis. */
export interface Quad {
  /** RGBA of four pixels of the whole picture: the known one, then those to the right, above, and above to the right. */
  readonly colors: Float64Array;
  /** Curvature of the picture here: the largest second difference of a channel. */
  curvature: number;
  /** The largest channel value of the four known pixels around it. */
  brightest: number;
}

export function emptyQuad(): Quad {
  return { colors: new Float64Array(16), curvature: 0, brightest: 0 };
}

/**
 * Fills the quad of 2 x 2 pixels at the (x, y) of every second pixel from the twelve known pixels around it. A pixel between two known
 * ones uses four in a row; the one in the middle of four uses twelve. Both are exact for polynomials of third degree.
 * @param picture - every `stride`th of its pixels along each axis is used
 * @param quad - is filled, in the picture's own unit
 * Twin: shaders/chunks/depth/between-pixels.glsl
 */
export function interpolateQuad(
  { data, width, height }: Pixels,
  stride: number,
  [x, y]: readonly [number, number],
  quad: Quad,
): void {
  const columns = Math.ceil(width / stride);
  const rows = Math.ceil(height / stride);
  const place = (i: number, j: number): number =>
    4 * stride * (Math.min(rows - 1, Math.max(0, y + j)) * width + Math.min(columns - 1, Math.max(0, x + i)));
  const [a, b, c, d] = [place(0, 0), place(1, 0), place(0, 1), place(1, 1)];
  const [leftOfA, rightOfB, leftOfC, rightOfD] = [place(-1, 0), place(2, 0), place(-1, 1), place(2, 1)];
  const [belowA, belowB, aboveC, aboveD] = [place(0, -1), place(1, -1), place(0, 2), place(1, 2)];
  const at = (index: number, channel: number): number => data[index + channel];
  const curvature = (i: number, j: number, k: number, channel: number): number =>
    Math.abs(at(i, channel) - 2 * at(j, channel) + at(k, channel));
  quad.curvature = quad.brightest = 0;
  for (let n = 0; n < 4; n++) {
    quad.colors[n] = at(a, n);
    quad.colors[4 + n] = (9 * (at(a, n) + at(b, n)) - at(leftOfA, n) - at(rightOfB, n)) / 16;
    quad.colors[8 + n] = (9 * (at(a, n) + at(c, n)) - at(belowA, n) - at(aboveC, n)) / 16;
    const outer =
      at(leftOfA, n) +
      at(rightOfB, n) +
      at(leftOfC, n) +
      at(rightOfD, n) +
      at(belowA, n) +
      at(belowB, n) +
      at(aboveC, n) +
      at(aboveD, n);
    quad.colors[12 + n] = (10 * (at(a, n) + at(b, n) + at(c, n) + at(d, n)) - outer) / 32;
    quad.brightest = Math.max(quad.brightest, at(a, n), at(b, n), at(c, n), at(d, n));
    quad.curvature = Math.max(
      quad.curvature,
      curvature(leftOfA, a, b, n),
      curvature(a, b, rightOfB, n),
      curvature(leftOfC, c, d, n),
      curvature(c, d, rightOfD, n),
      curvature(belowA, a, c, n),
      curvature(a, c, aboveC, n),
      curvature(belowB, b, d, n),
      curvature(b, d, aboveD, n),
    );
  }
}
