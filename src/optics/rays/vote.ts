import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/volume.ts';

/**
 * Finds the sample that a place belongs to, for samples that stand for things, without values in between. The eight voxels around the place
 * vote by their tri-linear weights, and the value with the most votes wins. If several have the same votes, the smallest wins; so the result
 * does not depend on the order of the axes. All samples that are no finite number (no data) vote as one value, smaller than any other.
 * @param place - in the unit cube; voxel centres are at (i + 0.5) / n, and the outer half voxels belong to their voxels
 * @returns the value; NaN for no data
 * Source: Hadwiger, Berger and Hauser, *High-quality two-level volume rendering of segmented data sets on consumer graphics
 * hardware*, 2003. Twin: shaders/chunks/field/vote.glsl
 */
export function voteOfCorners(samples: Samples, [nx, ny, nz]: Vector3, place: Vector3): number {
  const [i, up, iUp] = locate(place[0], nx);
  const [j, right, jUp] = locate(place[1], ny);
  const [k, deep, kUp] = locate(place[2], nz);
  const at = i + nx * (j + ny * k);
  const [x, y, z] = [iUp - i, nx * (jUp - j), nx * ny * (kUp - k)];
  const values = [0, x, y, x + y, z, x + z, y + z, x + y + z].map((offset) => {
    const value = samples[at + offset];
    return Number.isFinite(value) ? value : -Infinity;
  });
  const isUniform = values.every((value) => value === values[0]);
  const winner = isUniform ? values[0] : electCorner(values, weighCorners([up, right, deep]));
  return winner === -Infinity ? NaN : winner;
}

/**
 * The value with the most votes of a box's corners.
 * @param values - of the corners, i fastest
 * @param weights - of their votes
 */
export function electCorner(values: readonly number[], weights: readonly number[]): number {
  let [winner, max] = [values[0], -1];
  for (const candidate of values) {
    const votes = countVotes(weights, (c) => values[c] === candidate);
    if (votes > max || (votes === max && candidate < winner)) [winner, max] = [candidate, votes];
  }
  return winner;
}

/**
 * The tri-linear weights of a box's corners, i fastest: parameters are the shares of the way from the lower to the upper corners along
 * each axis.
 */
export function weighCorners([up, right, deep]: Vector3): number[] {
  const face = [(1 - up) * (1 - right), up * (1 - right), (1 - up) * right, up * right];
  return [...face.map((weight) => weight * (1 - deep)), ...face.map((weight) => weight * deep)];
}

/** The sum of the weights of some corners. */
export function countVotes(weights: readonly number[], counts: (corner: number) => boolean): number {
  return weights.reduce((sum, weight, c) => sum + (counts(c) ? weight : 0), 0);
}

/** The lower of two neighbours, the share of the way to the upper neighbour, and the upper neighbour. */
function locate(u: number, n: number): [low: number, share: number, high: number] {
  const x = Math.min(Math.max(u * n - 0.5, 0), n - 1);
  const low = Math.floor(x);
  return [low, x - low, Math.min(low + 1, n - 1)];
}
