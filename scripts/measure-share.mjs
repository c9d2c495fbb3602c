/** Pixels with at least this opacity, of 255, count as visible. */
const seenFrom = 13;

/** A row or column of pixels is ignored if it has fewer visible pixels than this share of the picture's shorter side. */
const strayShare = 0.004;

/**
 * The share of a picture that its visible part fills.
 * @param {Uint8Array} alpha - of each pixel, row by row
 * @param {readonly [number, number]} size
 * @returns {{ width: number, height: number, fits: number, isCut: boolean } | null} shares of the sides; `fits` is the larger of
 * the two; `isCut` where the visible part reaches the edge. Null where nothing is visible.
 */
export function measureShare(alpha, [width, height]) {
  const counts = [new Uint32Array(width), new Uint32Array(height)];
  for (let i = 0; i < alpha.length; i++) {
    if (alpha[i] < seenFrom) continue;
    counts[0][i % width] += 1;
    counts[1][Math.floor(i / width)] += 1;
  }
  const min = Math.max(1, strayShare * Math.min(width, height));
  const spans = counts.map((line) => {
    const isSeen = (/** @type {number} */ count) => count >= min;
    const seen = Array.from(line.keys()).filter((i) => isSeen(line[i]));
    return [seen[0] ?? -1, (seen.at(-1) ?? -1) + 1];
  });
  if (spans.some(([from]) => from < 0)) return null;
  const [across, down] = spans.map(([from, to], axis) => (to - from) / counts[axis].length);
  const isCut = spans.some(([from, to], axis) => from === 0 || to === counts[axis].length);
  return { width: across, height: down, fits: Math.max(across, down), isCut };
}
