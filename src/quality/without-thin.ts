import type { Pixels } from '../optics/rays/between-pixels.ts';

/** The offsets of one pixel on each side of another. */
type Sides = readonly [from: number, to: number];

/**
 * Approximates a picture without the lines and points that end rays. They are replaced by an interpolation between the pixels on both
 * sides, across or down, whichever are nearer. Lattices of adaptive ray sampling are drawn without lines and points.
 * @param jumps - for the quads of all its pixels, see findThin of optics/rays/depth-jumps.ts: the second channel has its result
 */
export function withoutThin(picture: Pixels, jumps: Pixels): Pixels {
  const { width, height } = picture;
  const data = Uint8Array.from(picture.data);
  const isThin = (x: number, y: number): boolean =>
    ((jumps.data[4 * ((y >> 1) * jumps.width + (x >> 1)) + 1] / 17) & (1 << ((x & 1) + 2 * (y & 1)))) !== 0;
  /**
   * Offsets of the nearest pixels along an axis that are not thin. If there is none on one side, both are that of the other side; if there
   * is none at all, both are 0.
   */
  const lookAlong = (isOther: (away: number) => boolean, back: number, forth: number): Sides => {
    let [from, to] = [-1, 1];
    while (from >= -back && !isOther(from)) from--;
    while (to <= forth && !isOther(to)) to++;
    const [isBack, isForth] = [from >= -back, to <= forth];
    if (isBack && isForth) return [from, to];
    return isBack ? [from, from] : isForth ? [to, to] : [0, 0];
  };
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (!isThin(x, y)) continue;
      const across = lookAlong((away) => !isThin(x + away, y), x, width - 1 - x);
      const down = lookAlong((away) => !isThin(x, y + away), y, height - 1 - y);
      const [sides, step] = reach(across) <= reach(down) && across[0] !== 0 ? [across, 4] : [down, 4 * width];
      const at = 4 * (y * width + x);
      const share = sides[0] < sides[1] ? sides[0] / (sides[0] - sides[1]) : 0;
      for (let c = at; c < at + 4; c++)
        data[c] = Math.round(
          (1 - share) * picture.data[c + sides[0] * step] + share * picture.data[c + sides[1] * step],
        );
    }
  }
  return { data, width, height };
}

/** The distance between both pixels; Infinity if they are on one side only, or there are none. */
function reach([from, to]: Sides): number {
  return from < to ? to - from : Infinity;
}
