import { expect } from '@esm-bundle/chai';
import { atlasLayout } from '../../../src/volume/atlas.ts';
import { cartesianGrid, corners, spacingOf } from '../../../src/volume/grid.ts';
import { transformPoint } from '../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import { chooseReduction, reduceDimensions, reduceVolume } from '../../../src/volume/reduce.ts';
import type { Samples } from '../../../src/volume/volume.ts';

const oblique: Matrix4 = [-1.5, 0.2, 0.1, 30, 0.3, 2, -0.4, -20, 0.05, 0.25, 3.5, 10, 0, 0, 0, 1];
const roomy = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 30 };

function block(
  dimensions: Vector3,
  samples?: Samples,
): { dimensions: Vector3; samples: Samples; indexToWorld: Matrix4 } {
  return {
    dimensions,
    samples: samples ?? new Uint8Array(dimensions[0] * dimensions[1] * dimensions[2]),
    indexToWorld: oblique,
  };
}

describe('reduction to what a device holds', () => {
  it('leaves what fits alone', () => {
    expect(chooseReduction(block([100, 90, 80]), roomy)).to.deep.equal([1, 1, 1]);
  });

  it('follows each limit', () => {
    expect(chooseReduction(block([300, 20, 20]), { ...roomy, maxVoxelsPerAxis: 128 })).to.deep.equal([3, 1, 1]);
    const bytes = block([64, 64, 64]);
    const factors = chooseReduction(bytes, { ...roomy, maxBytes: 40000 });
    const [nx, ny, nz] = reduceDimensions(bytes.dimensions, factors);
    expect(nx * ny * nz).to.be.at.most(40000);
    // The finest axis (1.5) pays before the coarsest (3.5).
    expect(factors[0]).to.be.at.least(factors[2]);
    const atlas = chooseReduction(bytes, { ...roomy, maxAtlasSize: 256 });
    expect(atlasLayout(reduceDimensions(bytes.dimensions, atlas), 256)).to.not.equal(null);
  });

  it('ends even where nothing can fit', () => {
    expect(chooseReduction(block([9, 9, 9]), { maxVoxelsPerAxis: 1, maxAtlasSize: 0, maxBytes: 0 })).to.deep.equal([
      9, 9, 9,
    ]);
  });

  it('averages whole boxes', () => {
    const samples = new Uint8Array([0, 2, 4, 6, 10, 12, 14, 16]);
    expect(Array.from(reduceVolume(block([2, 2, 2], samples), [2, 2, 2]).samples)).to.deep.equal([8]);
    expect(Array.from(reduceVolume(block([4, 2, 1], samples), [2, 1, 1]).samples)).to.deep.equal([1, 5, 11, 15]);
  });

  it('leaves NaN out', () => {
    const samples = new Float32Array([NaN, 2, NaN, NaN]);
    const reduced = reduceVolume(block([4, 1, 1], samples), [2, 1, 1]).samples;
    expect(reduced[0]).to.equal(2);
    expect(Number.isNaN(reduced[1])).to.equal(true);
  });

  it('keeps the outer faces, a constant and the mean, whether the factor divides or not', () => {
    for (const [dimensions, factors] of [
      [
        [8, 6, 4],
        [2, 3, 4],
      ],
      [
        [7, 5, 3],
        [2, 3, 2],
      ],
      [
        [100, 1, 13],
        [7, 1, 5],
      ],
    ] as [Vector3, Vector3][]) {
      const count = dimensions[0] * dimensions[1] * dimensions[2];
      const ramp = new Float32Array(count).map((_, i) => (i * 37) % 101);
      const before = block(dimensions, ramp);
      const after = reduceVolume(before, factors);
      expect(after.dimensions).to.deep.equal(dimensions.map((n, a) => Math.ceil(n / factors[a])));
      corners(cartesianGrid(after.dimensions, after.indexToWorld)).forEach((corner, c) =>
        corner.forEach((value, axis) =>
          expect(value).to.be.closeTo(corners(cartesianGrid(dimensions, before.indexToWorld))[c][axis], 1e-9),
        ),
      );
      const mean = (values: Samples): number =>
        Array.from(values).reduce((sum, value) => sum + value, 0) / values.length;
      expect(mean(after.samples)).to.be.closeTo(mean(ramp), 1e-4);
      const flat = reduceVolume(block(dimensions, new Uint16Array(count).fill(60001)), factors);
      expect(flat.samples.every((value) => value === 60001)).to.equal(true);
    }
  });

  it('keeps a linear field where it is in the world', () => {
    const dimensions: Vector3 = [12, 10, 8];
    const before = block(dimensions, new Float32Array(960));
    const field = (p: Vector3): number => 3 * p[0] - 2 * p[1] + 0.5 * p[2];
    const fill = (
      target: Pick<typeof before, 'dimensions' | 'indexToWorld'>,
      visit: (i: number, p: Vector3) => void,
    ): void => {
      const [nx, ny, nz] = target.dimensions;
      for (let k = 0; k < nz; k++)
        for (let j = 0; j < ny; j++)
          for (let i = 0; i < nx; i++) {
            visit((k * ny + j) * nx + i, transformPoint(target.indexToWorld, [i, j, k]));
          }
    };
    fill(before, (at, p) => (before.samples[at] = field(p)));
    for (const factors of [
      [2, 2, 2],
      [5, 3, 3],
    ] as Vector3[]) {
      const after = reduceVolume(before, factors);
      // Boxes of equal shares: the mean of a linear field over a box of whole voxels is its value at the middle. With
      // cut voxels each counts as a flat block, which is off by up to an eighth of a voxel's step per axis.
      const slack = factors[0] === 2 ? 1e-3 : 0.5 * spacingOf(oblique).reduce((a, b) => a + b);
      fill(after, (at, p) => expect(after.samples[at]).to.be.closeTo(field(p), slack));
    }
  });
});
