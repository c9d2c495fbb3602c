import { expect } from '@esm-bundle/chai';
import { buildPyramid, countBricks } from '../../../src/bricks/pyramid.ts';
import { residentSampler } from '../../../src/bricks/resident-field.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import type { Samples } from '../../../src/volume/samples.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** The same by the interpolation of rays, voxel by voxel. */
function measureByRays(dimensions: Vector3, samples: Samples, side: number) {
  const pyramid = buildPyramid({ dimensions, samples }, side);
  const cells = countBricks(pyramid, 0);
  const count = cells[0] * cells[1] * cells[2];
  const levels = pyramid.levels.map((_, level) => {
    const valueAt = residentSampler(pyramid, new Uint8Array(count).fill(level));
    const [max, squares, numbers] = [0, 0, 0].map(() => new Float64Array(count));
    let at = 0;
    for (let k = 0; k < dimensions[2]; k++)
      for (let j = 0; j < dimensions[1]; j++)
        for (let i = 0; i < dimensions[0]; i++, at++) {
          const there = valueAt((i + 0.5) / dimensions[0], (j + 0.5) / dimensions[1], (k + 0.5) / dimensions[2]);
          const cell = Math.floor(i / side) + cells[0] * (Math.floor(j / side) + cells[1] * Math.floor(k / side));
          const off = Math.abs(there - samples[at]);
          max[cell] = Math.max(max[cell], off);
          squares[cell] += off ** 2;
          numbers[cell]++;
        }
    return { max: [...max], rms: [...squares].map((sum, cell) => Math.sqrt(sum / numbers[cell])) };
  });
  return { pyramid, levels };
}

describe('What the levels of a pyramid hide', () => {
  it('is what rays would find, cell by cell, for axes that bricks do not divide', () => {
    const random = randomNumbers(3);
    const dimensions: Vector3 = [21, 10, 13];
    const samples = Float32Array.from({ length: 21 * 10 * 13 }, random);
    const { pyramid, levels } = measureByRays(dimensions, samples, 8);
    const table = measureResiduals(pyramid, 8);
    for (const [level, { max, rms }] of levels.entries())
      for (const cell of max.keys()) {
        expect(table.levels[level].max[cell]).to.be.closeTo(max[cell], 1e-6);
        expect(table.levels[level].rms[cell]).to.be.closeTo(rms[cell], 1e-6);
      }
    expect(levels[2].max[0]).to.be.above(0.4);
  });

  it('goes together as far as values do: not in noise, and nearly all the way in waves', () => {
    const side = 48;
    const random = randomNumbers(7);
    const alongOf = (field: (i: number) => number): readonly number[] => {
      const samples = Float32Array.from({ length: side ** 3 }, (_, n) => field(n % side));
      return measureResiduals(buildPyramid({ dimensions: [side, side, side], samples }, 8), 8).along!;
    };
    const ofNoise = alongOf(random);
    expect(ofNoise[0]).to.equal(0);
    expect(ofNoise[1]).to.be.within(0.1, 0.25);
    // Along two of three axes these waves do not change. Along x, what a mean of two voxels hides changes its sign within a few voxels.
    expect(alongOf((i) => Math.sin(i / 3))[1]).to.be.within(0.6, 1);
    expect(alongOf(() => 5)).to.deep.equal([0, 0, 0, 0]);
  });

  it('has a speck of one voxel in full', () => {
    const samples = new Uint8Array(32 ** 3);
    samples[20 + 32 * (9 + 32 * 3)] = 200;
    const pyramid = buildPyramid({ dimensions: [32, 32, 32], samples }, 8);
    const { levels, low, high } = measureResiduals(pyramid, 8);
    const cell = 2 + 4 * 1;
    // Its means are 25 and 3; the mean of 64 voxels is rounded.
    expect(levels[1].max[cell]).to.be.within(170, 200);
    expect(levels[2].max[cell]).to.be.within(190, 200);
    expect([low[cell], high[cell]]).to.deep.equal([0, 200]);
    expect([low[63], high[63], levels[2].max[63], levels[2].rms[63]]).to.deep.equal([0, 0, 0, 0]);
  });

  it('is nothing where all voxels are equal', () => {
    const pyramid = buildPyramid({ dimensions: [20, 20, 20], samples: new Uint8Array(8000).fill(7) }, 8);
    for (const { max, rms } of measureResiduals(pyramid, 8).levels)
      expect([...max, ...rms].some(Boolean)).to.equal(false);
  });

  it('is the whole range at an edge of the data', () => {
    const samples = new Float32Array(16 ** 3).map((_, n) => (n % 16 < 5 ? NaN : n % 16));
    const { levels } = measureResiduals(buildPyramid({ dimensions: [16, 16, 16], samples }, 8), 8);
    expect(levels[1].max[0]).to.equal(10);
  });
});
