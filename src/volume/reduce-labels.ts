import type { LabelMap } from './labels.ts';
import type { Vector3 } from './matrix.ts';
import { overlap } from './reduce.ts';
import type { Overlap } from './reduce.ts';

/** The parts of a map that are needed: as many numbers as there are ids. */
type Numbered = Pick<LabelMap, 'dimensions' | 'numbers'> & { readonly ids: { readonly length: number } };

/**
 * The labels of a volume that was made smaller, see `reduceVolume`: each box of voxels gets the label that most of it
 * has, and voxels on a cut count by their share. Among equals the smallest number wins, as where corners vote.
 * @param to - voxels along i, j and k of the smaller volume
 */
export function reduceLabels<M extends Numbered>(map: M, to: Vector3): M {
  const { dimensions: from, ids } = map;
  const numbers =
    map.numbers instanceof Uint8Array ? new Uint8Array(to[0] * to[1] * to[2]) : new Uint16Array(to[0] * to[1] * to[2]);
  const [across, down, deep] = [0, 1, 2].map((axis) =>
    Array.from({ length: to[axis] }, (_, i) => overlap(i, from[axis] / to[axis], from[axis])),
  );
  const votes = new Float64Array(ids.length);
  let out = 0;
  for (const z of deep)
    for (const y of down) for (const x of across) numbers[out++] = findMajority(map, [x, y, z], votes);
  return { ...map, dimensions: to, numbers };
}

/** Sums of rounded shares that differ by less than this are equal. */
const rounding = 1e-9;

/** @param votes - 0 for each number, before and afterwards */
function findMajority(
  { numbers, dimensions: [nx, ny] }: Numbered,
  [x, y, z]: readonly Overlap[],
  votes: Float64Array,
): number {
  const found: number[] = [];
  for (let c = 0; c < z.weights.length; c++) {
    for (let b = 0; b < y.weights.length; b++) {
      const start = ((z.first + c) * ny + y.first + b) * nx + x.first;
      for (let a = 0; a < x.weights.length; a++) {
        const number = numbers[start + a];
        if (votes[number] === 0) found.push(number);
        votes[number] += x.weights[a] * y.weights[b] * z.weights[c];
      }
    }
  }
  found.sort((a, b) => a - b);
  const winner = found.reduce((best, number) => (votes[number] > votes[best] + rounding ? number : best));
  for (const number of found) votes[number] = 0;
  return winner;
}
