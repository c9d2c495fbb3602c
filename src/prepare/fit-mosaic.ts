import type { Vector3 } from '../volume/matrix.ts';
import { reduceDimensions, reduceVolume } from '../volume/reduce.ts';
import type { Block } from '../volume/reduce.ts';
import { measureReduction } from './measure-error.ts';
import type { ValueOf } from './measure-error.ts';
import { layOut } from './mosaic-layout.ts';

/** So many slices are looked at to compare reductions. */
const comparedSlices = 24;

/** More voxels are never averaged into one along an axis. */
const maxFactor = 32;

/**
 * Chooses how many voxels to average along each axis so that the slices fit into one image: of all ways that average no more than
 * they must, the one that leaves the smallest error.
 * @param maxEdge - of the image, pixels
 * @returns all 1 if nothing has to be averaged; null if nothing helps
 */
export function chooseFactors(
  block: Block & { readonly valueOf: ValueOf; readonly isDiscrete?: boolean },
  maxEdge: number,
): Vector3 | null {
  const { dimensions } = block;
  const fits = (factors: Vector3): boolean => layOut(reduceDimensions(dimensions, factors), maxEdge) !== null;
  if (fits([1, 1, 1])) return [1, 1, 1];
  const ways: Vector3[] = [];
  const last = dimensions.map((n) => Math.min(n, maxFactor));
  for (let x = 1; x <= last[0]; x++) {
    for (let y = 1; y <= last[1]; y++) {
      let z = 1;
      while (z <= last[2] && !fits([x, y, z])) z++;
      if (z <= last[2]) ways.push([x, y, z]);
    }
  }
  const least = ways.filter((way) => !ways.some((other) => other !== way && other.every((n, axis) => n <= way[axis])));
  if (least.length <= 1) return least[0] ?? null;
  const everySlice = Math.max(1, Math.floor(dimensions[2] / comparedSlices));
  // Voxels much longer one way than the other are never the best; measuring them all takes long.
  const likely = sortedBy(least, (way) => Math.max(...way)).slice(0, 6);
  // Between labels there are no values.
  if (block.isDiscrete) return likely[0];
  return sortedBy(
    likely,
    (way) => measureReduction(block, { ...reduceVolume(block, way), valueOf: block.valueOf }, everySlice).rms,
  )[0];
}

function sortedBy<T>(list: readonly T[], costOf: (one: T) => number): T[] {
  const costs = new Map(list.map((one) => [one, costOf(one)]));
  const sorted = [...list];
  sorted.sort((a, b) => costs.get(a)! - costs.get(b)!);
  return sorted;
}
