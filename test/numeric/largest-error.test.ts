import { expect } from '@esm-bundle/chai';
import { contributionOf } from '../../src/optics/empty-space-distance.ts';
import { parseTransferFunction } from '../../src/optics/parse-transfer-function.ts';
import { findSeenCells } from '../../src/optics/seen-cells.ts';
import { boundMissed, stateError } from '../../src/quality/largest-error.ts';
import type { SeenVolume } from '../../src/quality/largest-error.ts';
import { measureRoughness } from '../../src/volume/roughness.ts';
import { randomNumbers, syntheticVolume } from '../helpers/synthetic.ts';

function see(field: (x: number, y: number, z: number) => number, text: string): SeenVolume {
  const volume = syntheticVolume({ dimensions: [24, 24, 24], spacing: [1, 1, 1], field });
  const transferFunction = parseTransferFunction(text, [0, 1]);
  return { volume, transferFunction, cells: findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume), opticalScale: 1 };
}

const covered = { rms: 0.3, p99: 0.5, p999: 0.8, max: 0.9, order: 2, discretization: 0.1, coverage: 0.5, covered: 900 };

describe('the roughness of a block', () => {
  it('is its largest second difference along any axis', () => {
    const random = randomNumbers(5);
    const [nx, ny, nz] = [9, 7, 11];
    const samples = Float32Array.from({ length: nx * ny * nz }, () => random());
    samples[300] = NaN;
    const at = (i: number, j: number, k: number): number =>
      samples[Math.min(nx - 1, Math.max(0, i)) + nx * (Math.min(ny - 1, Math.max(0, j)) + ny * Math.min(nz - 1, Math.max(0, k)))];
    let largest = 0;
    for (let k = 4; k < 8; k++) for (let j = 4; j < 7; j++) for (let i = 4; i < 8; i++) {
      for (const [x, y, z] of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
        const second = Math.abs(at(i - x, j - y, k - z) - 2 * at(i, j, k) + at(i + x, j + y, k + z));
        if (second > largest) largest = second;
      }
    }
    expect(measureRoughness(samples, [nx, ny, nz], [4, 4, 4], 4)).to.be.closeTo(largest, 1e-7);
  });

  it('of a ramp is nothing inside of the grid', () => {
    const samples = Float32Array.from({ length: 1000 }, (_, i) => i % 10);
    expect(measureRoughness(samples, [10, 10, 10], [1, 1, 1], 8)).to.equal(0);
  });
});

describe('the bound of what probes could have missed', () => {
  it('is large where one voxel may be bright, small where the data are smooth, and nothing where nothing is seen', () => {
    const speck = (x: number, y: number, z: number): number => (Math.max(Math.abs(x - 0.48), Math.abs(y - 0.48), Math.abs(z - 0.48)) < 0.02 ? 1 : 0.1);
    const smooth = (x: number): number => 0.3 + 0.1 * Math.sin(3 * x);
    const ramp = '0 #fff 0, 1 #fff 60%';
    expect(boundMissed(see(speck, ramp), 1)).to.be.above(0.5);
    expect(boundMissed(see(smooth, ramp), 1)).to.be.below(0.03);
    expect(boundMissed(see(smooth, '0.9 #fff 0, 1 #fff 60%'), 1)).to.equal(0);
  });

  it('gets smaller with shorter steps, but not where the transfer function jumps', () => {
    const noise = randomNumbers(9);
    const rough = see(() => 0.4 + 0.2 * noise(), '0 #fff 0, 1 #fff 30%');
    expect(boundMissed(rough, 4)).to.be.below(0.6 * boundMissed(rough, 1));
    expect(boundMissed(see((x) => x, '0 #fff 0, 0.5 #fff 0, 0.5 #fff 100%'), 4)).to.be.above(0.99);
  });

  it('is what is stated as the largest error, and all that is stated where no probe met anything', () => {
    const speck = see((x) => (Math.abs(x - 0.48) < 0.02 ? 1 : 0), '0.2 #fff 0, 1 #fff 60%');
    expect(stateError(covered, speck, 1).max).to.be.above(100);
    expect(stateError(covered, speck, 1).rms).to.equal(0.3);
    expect(stateError({ ...covered, covered: 0, rms: 0 }, speck, 1).rms, 'no zero').to.be.above(100);
    expect(stateError({ ...covered, covered: 0, rms: 0, p99: 0, max: 0 }, { ...speck, cells: speck.cells.map(() => 0) }, 1)).to.deep.equal({ rms: 0, p99: 0, max: 0 });
  });
});
