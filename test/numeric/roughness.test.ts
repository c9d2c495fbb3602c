import { expect } from '@esm-bundle/chai';
import { interpolate } from '../../src/optics/interpolate.ts';
import { cellSize } from '../../src/volume/cell-size.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { offLine } from '../../src/volume/cell-size.ts';
import { randomNumbers, syntheticVolume } from '../helpers/synthetic.ts';

/** Voxel (i, j, k) is 200, all others 10. */
function speckAt(dimensions: Vector3, [i, j, k]: Vector3): ReturnType<typeof syntheticVolume> {
  const volume = syntheticVolume({ dimensions, field: () => 10 / 255 });
  volume.samples[i + dimensions[0] * (j + dimensions[1] * k)] = 200;
  return { ...volume, macrocells: buildMacrocells(volume.samples, dimensions) };
}

describe('the roughness of cells', () => {
  it('tells of a voxel at a corner in each of the eight cells that its tent reaches', () => {
    const dimensions: Vector3 = [24, 24, 24];
    for (const at of [[7, 7, 7], [8, 8, 8], [7, 8, 15], [16, 15, 8]] as const) {
      const { macrocells } = speckAt(dimensions, at);
      // A tent reaches one voxel to either side of its middle.
      const cells = at.map((x) => [x - 0.4, x + 1.4].map((place) => Math.floor(place / cellSize)));
      for (const x of cells[0]) for (const y of cells[1]) for (const z of cells[2]) {
        const cell = x + 3 * (y + 3 * z);
        expect(macrocells.high[cell] - macrocells.low[cell], `range of cell ${cell}`).to.equal(190);
        expect(macrocells.roughness[cell], `cell ${cell}, a voxel at ${at.join()}`).to.be.at.least(190 / offLine - 1e-3);
      }
    }
  });

  it('is 0 where values are in straight lines, and where there is nothing beside a constant', () => {
    const dimensions: Vector3 = [20, 17, 18];
    const { samples } = syntheticVolume({ dimensions, kind: 'float32', field: () => 0 });
    for (let n = 0; n < samples.length; n++) samples[n] = 3 * (n % 20) - 2 * (Math.floor(n / 20) % 17) + Math.floor(n / 340);
    const inner = buildMacrocells(samples, dimensions).roughness[1 + 3 * (1 + 3)];
    expect(inner).to.equal(0);
    expect([...new Set(buildMacrocells(new Uint8Array(20 * 17 * 18).fill(7), dimensions).roughness)]).to.deep.equal([0]);
  });

  for (const [name, kind, field] of [
    ['noise', 'uint8', (random: () => number) => () => 0.2 + 0.6 * random()],
    ['few specks', 'uint8', (random: () => number) => () => (random() < 0.01 ? 0.8 : 0.1)],
    ['waves', 'float32', () => (x: number, y: number, z: number) => 100 * Math.sin(9 * x + 7 * y) * Math.cos(8 * z)],
    ['waves with gaps', 'float32', () => (x: number, y: number, z: number) => (x > 0.4 && y < 0.3 ? NaN : 100 * Math.sin(9 * x + 7 * y) * Math.cos(8 * z))],
  ] as const) {
    it(`bounds how far values are from the line between two samples of a cell a voxel apart: ${name}`, () => {
      const dimensions: Vector3 = [26, 19, 22];
      const random = randomNumbers(99);
      const { samples, macrocells: { dimensions: cells, roughness, low, high } } = syntheticVolume({ dimensions, kind, field: field(random) });
      let worst = 0;
      for (let i = 0; i < 60_000; i++) {
        const direction = [0, 1, 2].map(() => random() - 0.5);
        const length = Math.hypot(...direction);
        // Many of them near the corners of cells.
        const middle = dimensions.map((n) => (random() < 0.5 ? cellSize * Math.round((random() * n) / cellSize) + 3 * (random() - 0.5) : random() * n));
        const [a, b, m] = [-0.5, 0.5, 0].map((t) => middle.map((x, axis) => x + (t * direction[axis]) / length));
        const cellOf = (place: number[]): number => place.reduceRight((sum, x, axis) => sum * cells[axis] + Math.floor(x / cellSize), 0);
        if ([a, b].some((place) => place.some((x, axis) => x < 0 || x >= dimensions[axis])) || cellOf(a) !== cellOf(b)) continue;
        const [va, vb, vm] = [a, b, m].map((place) => interpolate(samples, dimensions, place.map((x, axis) => x / dimensions[axis]) as unknown as Vector3));
        const off = Math.abs(vm - (va + vb) / 2);
        const cell = cellOf(m);
        const allowed = Math.min(high[cell] - low[cell], offLine * roughness[cell]);
        if (!Number.isFinite(off)) continue;
        expect(off, `at ${m.map((x) => x.toFixed(2)).join()}`).to.be.at.most(allowed + 1e-4 * (high[cell] - low[cell]));
        if (allowed > 0) worst = Math.max(worst, off / allowed);
      }
      expect(worst, 'the bound is not far from what occurs').to.be.above(0.2);
    });
  }
});
