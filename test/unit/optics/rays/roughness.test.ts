import { expect } from '@esm-bundle/chai';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import { offLine } from '../../../../src/volume/grid.ts';
import { buildMacrocells, emptyMacrocells } from '../../../../src/volume/macrocells.ts';
import type { Macrocells } from '../../../../src/volume/macrocells.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Samples } from '../../../../src/volume/samples.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

/** Voxel (i, j, k) is 200, all others 10. */
function speckAt(dimensions: Vector3, [i, j, k]: Vector3): ReturnType<typeof syntheticVolume> {
  const volume = syntheticVolume({ dimensions, field: () => 10 / 255 });
  volume.samples[i + dimensions[0] * (j + dimensions[1] * k)] = 200;
  return { ...volume, macrocells: buildMacrocells(volume.samples, dimensions) };
}

/** Ranges and roughness as they are defined, voxel by voxel and cell by cell. */
function cellsByTheWord(samples: Samples, dimensions: Vector3, size: number): Macrocells {
  const strides = [1, dimensions[0], dimensions[0] * dimensions[1]];
  const empty = emptyMacrocells(samples, dimensions, size);
  const { dimensions: cells, low, high, roughness } = empty;
  /** From a cell's first voxel to its last, and so many beside it. */
  const alongCell = (cell: number, axis: number, attached: number): number[] =>
    Array.from({ length: size + 2 * attached }, (_, i) => cell * size - attached + i).filter(
      (i) => i >= 0 && i < dimensions[axis],
    );
  for (let cell = 0; cell < low.length; cell++) {
    const at = [cell % cells[0], Math.floor(cell / cells[0]) % cells[1], Math.floor(cell / cells[0] / cells[1])];
    let max = 0;
    for (const k of alongCell(at[2], 2, 1))
      for (const j of alongCell(at[1], 1, 1))
        for (const i of alongCell(at[0], 0, 1)) {
          const place = [i, j, k];
          const voxel = i + strides[1] * j + strides[2] * k;
          low[cell] = samples[voxel] < low[cell] ? samples[voxel] : low[cell];
          high[cell] = samples[voxel] > high[cell] ? samples[voxel] : high[cell];
          for (const axis of [0, 1, 2]) {
            if (Math.floor(place[axis] / size) !== at[axis]) continue;
            const before = place[axis] > 0 ? -strides[axis] : 0;
            const after = place[axis] < dimensions[axis] - 1 ? strides[axis] : 0;
            const bend = Math.abs(samples[voxel + before] + samples[voxel + after] - 2 * samples[voxel]);
            if (bend > max) max = bend;
          }
        }
    // Where most of the range could be off, all of it counts.
    const all = (high[cell] - low[cell]) / offLine;
    roughness[cell] = all > 0 && max >= Math.fround(0.6 * all) ? all : max;
  }
  return empty;
}

describe('the roughness of cells', () => {
  it('reports a voxel at a corner in each of the eight cells that its tent reaches', () => {
    const dimensions: Vector3 = [12, 12, 12];
    for (const at of [
      [3, 3, 3],
      [4, 4, 4],
      [3, 4, 7],
      [8, 7, 4],
    ] as const) {
      const { macrocells } = speckAt(dimensions, at);
      // A tent reaches one voxel to either side of its middle.
      const cells = at.map((x) => [x - 0.4, x + 1.4].map((place) => Math.floor(place / macrocells.size)));
      for (const x of cells[0])
        for (const y of cells[1])
          for (const z of cells[2]) {
            const cell = x + 3 * (y + 3 * z);
            expect(macrocells.high[cell] - macrocells.low[cell], `range of cell ${cell}`).to.equal(190);
            expect(macrocells.roughness[cell], `cell ${cell}, a voxel at ${at.join()}`).to.be.at.least(
              190 / offLine - 1e-3,
            );
          }
    }
  });

  it('is 0 where values are in straight lines, and where there is nothing but a constant', () => {
    const dimensions: Vector3 = [20, 17, 18];
    const { samples } = syntheticVolume({ dimensions, kind: 'float32', field: () => 0 });
    for (let n = 0; n < samples.length; n++)
      samples[n] = 3 * (n % 20) - 2 * (Math.floor(n / 20) % 17) + Math.floor(n / 340);
    const inner = buildMacrocells(samples, dimensions, 8).roughness[1 + 3 * (1 + 3)];
    expect(inner).to.equal(0);
    expect([...new Set(buildMacrocells(new Uint8Array(20 * 17 * 18).fill(7), dimensions).roughness)]).to.deep.equal([
      0,
    ]);
  });

  for (const [name, kind] of [
    ['8 bits', 'uint8'],
    ['16 bits', 'uint16'],
    ['floats with gaps', 'float32'],
  ] as const) {
    it(`is the largest second difference that bends a cell's values, and the range that of all voxels in and next to it: ${name}`, () => {
      const random = randomNumbers(7);
      // Cells of one voxel, of two and of all at the end of an axis; specks and noise in some of what is smooth.
      for (const [size, ...dimensions] of [
        [8, 9, 17, 18],
        [8, 24, 8, 1],
        [8, 19, 10, 16],
        [4, 9, 17, 18],
        [4, 24, 4, 1],
        [4, 19, 10, 16],
      ] as const) {
        const { samples } = syntheticVolume({
          dimensions,
          kind,
          field: (x, y, z) => {
            if (kind === 'float32' && random() < 0.01) return NaN;
            return x > 0.6 && y > 0.5
              ? random()
              : 0.5 + 0.3 * Math.sin(3 * x + 2 * y) * Math.cos(3 * z) + (random() < 0.002 ? 0.2 : 0);
          },
        });
        const built = buildMacrocells(samples, dimensions, size);
        const expected = cellsByTheWord(samples, dimensions, size);
        for (const part of ['low', 'high', 'roughness'] as const)
          expect([...built[part]], `${part}, ${dimensions.join()}, ${size}`).to.deep.equal([...expected[part]]);
      }
    });
  }

  for (const [name, kind, field] of [
    ['noise', 'uint8', (random: () => number) => () => 0.2 + 0.6 * random()],
    ['few specks', 'uint8', (random: () => number) => () => (random() < 0.01 ? 0.8 : 0.1)],
    ['waves', 'float32', () => (x: number, y: number, z: number) => 100 * Math.sin(9 * x + 7 * y) * Math.cos(8 * z)],
    [
      'waves with gaps',
      'float32',
      () => (x: number, y: number, z: number) =>
        x > 0.4 && y < 0.3 ? NaN : 100 * Math.sin(9 * x + 7 * y) * Math.cos(8 * z),
    ],
  ] as const) {
    it(`bounds how far values are from the line between two samples of a cell a voxel apart: ${name}`, () => {
      const dimensions: Vector3 = [26, 19, 22];
      const random = randomNumbers(99);
      const {
        samples,
        macrocells: { dimensions: cells, size, roughness, low, high },
      } = syntheticVolume({ dimensions, kind, field: field(random) });
      let worst = 0;
      for (let i = 0; i < 60_000; i++) {
        const direction = [0, 1, 2].map(() => random() - 0.5);
        const length = Math.hypot(...direction);
        // Many of them near the corners of cells.
        const middle = dimensions.map((n) =>
          random() < 0.5 ? size * Math.round((random() * n) / size) + 3 * (random() - 0.5) : random() * n,
        );
        const [a, b, m] = [-0.5, 0.5, 0].map((t) => middle.map((x, axis) => x + (t * direction[axis]) / length));
        const cellOf = (place: number[]): number =>
          place.reduceRight((sum, x, axis) => sum * cells[axis] + Math.floor(x / size), 0);
        if ([a, b].some((place) => place.some((x, axis) => x < 0 || x >= dimensions[axis])) || cellOf(a) !== cellOf(b))
          continue;
        const [va, vb, vm] = [a, b, m].map((place) =>
          interpolate(samples, dimensions, place.map((x, axis) => x / dimensions[axis]) as unknown as Vector3),
        );
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
