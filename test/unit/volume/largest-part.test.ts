import { expect } from '@esm-bundle/chai';
import { findLargestPart } from '../../../src/volume/largest-part.ts';
import { axialIndexToWorld } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** Labels by index, and their grid. */
function label(dimensions: Vector3, spacing: Vector3, at: (i: number, j: number, k: number) => number) {
  const [nx, ny, nz] = dimensions;
  const numbers = new Uint8Array(nx * ny * nz);
  for (let n = 0; n < numbers.length; n++) numbers[n] = at(n % nx, Math.floor(n / nx) % ny, Math.floor(n / (nx * ny)));
  return [numbers, { dimensions, indexToWorld: axialIndexToWorld(dimensions, spacing) }] as const;
}

describe('the largest part of a label', () => {
  it('is a box, and its centre the middle of the box', () => {
    const isIn = (x: number, low: number, high: number): boolean => x >= low && x <= high;
    const [numbers, grid] = label([20, 20, 20], [1, 1, 1], (i, j, k) =>
      isIn(i, 3, 7) && isIn(j, 10, 12) && isIn(k, 5, 11) ? 4 : isIn(i, 15, 17) && j < 2 && k < 2 ? 4 : i === 0 ? 9 : 0,
    );
    expect(findLargestPart(numbers, grid, 4)).to.deep.equal({ center: [5, 11, 8], voxels: 5 * 3 * 7 });
    expect(findLargestPart(numbers, grid, 5)).to.equal(null);
  });

  it('is met although its centre of mass lies outside of it', () => {
    // A ring: the centre of mass is in the hole.
    const [numbers, grid] = label([21, 21, 3], [1, 1, 1], (i, j, k) => {
      const r = Math.hypot(i - 10, j - 10);
      return k === 1 && r > 7 && r < 9.5 ? 1 : 0;
    });
    const { center } = findLargestPart(numbers, grid, 1)!;
    expect(numbers[center[0] + 21 * (center[1] + 21 * center[2])]).to.equal(1);
    expect(Math.hypot(center[0] - 10, center[1] - 10)).to.be.below(7.3);
  });

  it('counts distances in the world: voxels of a thick slice are far apart', () => {
    // An L of a row along i and a column along k, 10 mm apart: the nearest voxel to the centre is found in mm.
    const [numbers, grid] = label([11, 1, 3], [1, 1, 10], (i, _, k) => (k === 0 || i === 0 ? 1 : 0));
    const { center, voxels } = findLargestPart(numbers, grid, 1)!;
    expect(voxels).to.equal(13);
    // Centre of mass: i = 55 / 13, k = 3 / 13.
    expect(center).to.deep.equal([4, 0, 0]);
  });

  it('does not join voxels that touch by edges only, nor rows over the end of a row', () => {
    const [numbers, grid] = label([4, 4, 1], [1, 1, 1], (i, j) =>
      (i === 3 && j === 0) || (i === 0 && j === 1) ? 1 : i === 1 && j === 2 ? 1 : 0,
    );
    expect(findLargestPart(numbers, grid, 1)!.voxels).to.equal(1);
  });

  it('finds as many voxels as a flood that takes the whole volume again and again', () => {
    const random = randomNumbers(12);
    for (let round = 0; round < 5; round++) {
      const [numbers, grid] = label([9, 8, 7], [1, 2, 3], () => (random() < 0.4 ? 1 : 0));
      let largest = 0;
      const part = new Int32Array(numbers.length).fill(-1);
      for (let seed = 0; seed < numbers.length; seed++) {
        if (numbers[seed] !== 1 || part[seed] >= 0) continue;
        part[seed] = seed;
        let [before, count] = [0, 1];
        while (count > before) {
          before = count;
          for (let n = 0; n < numbers.length; n++) {
            if (numbers[n] !== 1 || part[n] === seed) continue;
            const [i, j, k] = [n % 9, Math.floor(n / 9) % 8, Math.floor(n / 72)];
            const beside = [
              i > 0 && n - 1,
              i < 8 && n + 1,
              j > 0 && n - 9,
              j < 7 && n + 9,
              k > 0 && n - 72,
              k < 6 && n + 72,
            ];
            if (!beside.some((one) => one !== false && part[one] === seed)) continue;
            part[n] = seed;
            count++;
          }
        }
        largest = Math.max(largest, count);
      }
      expect(findLargestPart(numbers, grid, 1)!.voxels).to.equal(largest);
    }
  });
});
