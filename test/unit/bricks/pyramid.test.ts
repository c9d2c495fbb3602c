import { expect } from '@esm-bundle/chai';
import {
  buildPyramid,
  cellsOf,
  copyBrick,
  countBricks,
  halve,
  listBricks,
  toLevel,
} from '../../../src/bricks/pyramid.ts';
import { residentSampler } from '../../../src/bricks/resident-field.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** A float volume of a function of the voxel's indices. */
function volumeOf([nx, ny, nz]: Vector3, value: (i: number, j: number, k: number) => number) {
  const samples = new Float32Array(nx * ny * nz);
  let at = 0;
  for (let k = 0; k < nz; k++) for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++) samples[at++] = value(i, j, k);
  return { dimensions: [nx, ny, nz] as Vector3, samples };
}

describe('A pyramid of means', () => {
  it('has the mean of the voxels that there are, also where an axis is odd', () => {
    const { dimensions, samples } = halve(volumeOf([3, 2, 1], (i, j) => i + 10 * j));
    expect(dimensions).to.deep.equal([2, 1, 1]);
    expect([...samples]).to.deep.equal([5.5, 7]);
  });

  it('has no data where fewer than half of its voxels have any', () => {
    const half = halve(volumeOf([2, 2, 1], (i, j) => (j === 0 ? NaN : 4 + i)));
    const quarter = halve(volumeOf([2, 2, 1], (i, j) => (j === 0 || i === 0 ? NaN : 4)));
    expect([...half.samples, ...quarter.samples]).to.deep.equal([4.5, NaN]);
  });

  it('rounds the means of whole numbers', () => {
    expect([...halve({ dimensions: [2, 1, 1], samples: new Uint8Array([3, 6]) }).samples]).to.deep.equal([5]);
  });

  it('ends with a level that is one brick', () => {
    const pyramid = buildPyramid(
      volumeOf([20, 9, 5], () => 1),
      8,
    );
    expect(pyramid.levels.map(({ dimensions }) => dimensions)).to.deep.equal([
      [20, 9, 5],
      [10, 5, 3],
      [5, 3, 2],
    ]);
    expect(countBricks(pyramid, 0)).to.deep.equal([3, 2, 1]);
  });

  // A ramp is the same at each level, but half a voxel too far: 0.5 voxels at level 1, 1.5 at level 2 would show here.
  it('has its voxels where they are: a ramp keeps its values at every level, at places away from its ends', () => {
    const dimensions: Vector3 = [21, 17, 30];
    const pyramid = buildPyramid(
      volumeOf(dimensions, (i, j, k) => 3 * i - 2 * j + k),
      8,
    );
    expect(pyramid.levels.length).to.equal(3);
    const random = randomNumbers(1);
    for (const level of [0, 1, 2]) {
      const count = countBricks(pyramid, 0).reduce((a, b) => a * b);
      const valueAt = residentSampler(pyramid, new Uint8Array(count).fill(level));
      for (let n = 0; n < 100; n++) {
        const share = dimensions.map((size) => (4 + random() * (size - 9)) / size) as unknown as Vector3;
        const [i, j, k] = share.map((x, axis) => x * dimensions[axis] - 0.5);
        expect(valueAt(...share)).to.be.closeTo(3 * i - 2 * j + k, 1e-4, `level ${level}`);
      }
    }
    expect(toLevel(pyramid, 2)).to.deep.equal([21 / 24, 17 / 20, 30 / 32]);
  });

  it('is cut into bricks that cover each cell once at each level', () => {
    const pyramid = buildPyramid(
      volumeOf([40, 17, 9], () => 0),
      8,
    );
    for (const level of pyramid.levels.keys()) {
      const cells = listBricks(pyramid, level).flatMap((brick) => cellsOf(pyramid, brick));
      cells.sort((a, b) => a - b);
      expect(cells).to.deep.equal(Array.from({ length: 5 * 3 * 2 }, (_, n) => n));
    }
  });

  it('fills a brick at the end of a level with zeros', () => {
    const pyramid = buildPyramid(
      volumeOf([3, 2, 2], (i, j, k) => 1 + i + 10 * j + 100 * k),
      2,
    );
    expect([...copyBrick(pyramid, { level: 0, at: [1, 0, 0] })]).to.deep.equal([3, 0, 13, 0, 103, 0, 113, 0]);
  });
});
