import { expect } from '@esm-bundle/chai';
import {
  axialIndexToWorld,
  boundingSphere,
  cartesianGrid,
  corners,
  edgeLengths,
  longestDiagonal,
  unitToWorld,
} from '../../../src/volume/grid.ts';
import { determinant } from '../../../src/volume/determinant.ts';
import { length, scaleAndTranslate, subtract, transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { obliqueAffine, randomNumbers } from '../../helpers/synthetic.ts';

function expectNear(got: Vector3, expected: Vector3, tolerance = 1e-12): void {
  got.forEach((x, i) => expect(x, `component ${i}`).to.be.closeTo(expected[i], tolerance));
}

describe('a cartesian grid', () => {
  const dimensions: Vector3 = [4, 6, 10];

  it('has its voxel centres half a voxel inside the unit cube', () => {
    const grid = cartesianGrid(dimensions, obliqueAffine(randomNumbers(2), [0.7, -1.1, 3], [5, 6, 7]));
    for (const [i, j, k] of [
      [0, 0, 0],
      [3, 5, 9],
      [1, 2, 3],
    ]) {
      const u: Vector3 = [(i + 0.5) / 4, (j + 0.5) / 6, (k + 0.5) / 10];
      expectNear(transformPoint(unitToWorld(grid), u), transformPoint(grid.indexToWorld, [i, j, k]));
    }
  });

  it('keeps flips', () => {
    const grid = cartesianGrid(dimensions, scaleAndTranslate([-2, 1, 1], [6, 0, 0]));
    expectNear(transformPoint(unitToWorld(grid), [0, 0, 0]), [7, -0.5, -0.5]);
    expectNear(transformPoint(unitToWorld(grid), [1, 1, 1]), [-1, 5.5, 9.5]);
    expect(grid.spacing).to.deep.equal([2, 1, 1]);
  });

  it('without a position of its own is centred, columns to -x, rows to -y, slices to +z, and not mirrored', () => {
    const indexToWorld = axialIndexToWorld(dimensions, [1, 2, 3]);
    expectNear(boundingSphere(cartesianGrid(dimensions, indexToWorld)).center, [0, 0, 0]);
    expectNear(subtract(transformPoint(indexToWorld, [1, 0, 0]), transformPoint(indexToWorld, [0, 0, 0])), [-1, 0, 0]);
    expectNear(subtract(transformPoint(indexToWorld, [0, 1, 0]), transformPoint(indexToWorld, [0, 0, 0])), [0, -2, 0]);
    expectNear(subtract(transformPoint(indexToWorld, [0, 0, 1]), transformPoint(indexToWorld, [0, 0, 0])), [0, 0, 3]);
    expect(determinant(indexToWorld)).to.equal(6);
  });

  it('measures edges, corners and the diagonal of a box', () => {
    const grid = cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 2, 3]));
    expect(edgeLengths(grid)).to.deep.equal([4, 12, 30]);
    expect(longestDiagonal(grid)).to.be.closeTo(Math.hypot(4, 12, 30), 1e-12);
    expect(corners(grid).map(String)).to.have.members(
      [-2, 2].flatMap((x) => [-6, 6].flatMap((y) => [-15, 15].map((z) => String([x, y, z])))),
    );
  });

  it('takes the longest of the four diagonals where it is sheared', () => {
    // The unit square sheared by 2 along x: its diagonals are (3, 1) and (1, 1); z adds 1.
    const sheared = cartesianGrid([1, 1, 1], [1, 2, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    expect(longestDiagonal(sheared)).to.be.closeTo(Math.sqrt(11), 1e-12);
    // Sheared the other way it is another of the four.
    const other = cartesianGrid([1, 1, 1], [1, -2, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    expect(longestDiagonal(other)).to.be.closeTo(Math.sqrt(11), 1e-12);
  });

  it('lies in its bounding sphere and touches it', () => {
    const grid = cartesianGrid(dimensions, obliqueAffine(randomNumbers(3), [2, 1, -0.3], [1e3, 0, -5]));
    const { center, radius } = boundingSphere(grid);
    const distances = corners(grid).map((corner) => length(subtract(corner, center)));
    expect(Math.max(...distances)).to.be.closeTo(radius, radius * 1e-12);
  });
});
