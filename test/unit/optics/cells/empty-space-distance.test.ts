import { expect } from '@esm-bundle/chai';
import { contributionOf, measureEmptySpace } from '../../../../src/optics/cells/empty-space-distance.ts';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { chooseCellSize } from '../../../../src/volume/cell-size.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const white = [1, 1, 1] as const;

/** Something between 0.7 and 0.8, and from 0.95 on. */
const gaps: TransferFunction = [
  { value: 0.7, color: white, opacity: 0 },
  { value: 0.75, color: white, opacity: 0.5 },
  { value: 0.8, color: white, opacity: 0 },
  { value: 0.95, color: white, opacity: 0 },
  { value: 0.95, color: white, opacity: 0.9 },
];

/** A few bright blobs in the dark. */
function blobs(x: number, y: number, z: number): number {
  return (
    Math.exp(-90 * ((x - 0.3) ** 2 + (y - 0.6) ** 2 + (z - 0.2) ** 2)) +
    0.9 * Math.exp(-200 * ((x - 0.8) ** 2 + (y - 0.2) ** 2 + (z - 0.8) ** 2))
  );
}

describe('macrocells', () => {
  it('have 4 voxels along each edge in a volume of no more than 256 voxels a side, else 8', () => {
    expect(chooseCellSize([256, 256, 256])).to.equal(4);
    expect(chooseCellSize([256, 257, 256])).to.equal(8);
    expect(chooseCellSize([512, 512, 64])).to.equal(4);
    expect(chooseCellSize([4096, 4096, 1])).to.equal(4);
    const samples = new Uint8Array(9 * 5 * 4);
    expect(buildMacrocells(samples, [9, 5, 4])).to.deep.include({ dimensions: [3, 2, 1], size: 4 });
    expect(buildMacrocells(samples, [9, 5, 4], 8)).to.deep.include({ dimensions: [2, 1, 1], size: 8 });
  });

  it('hold the range of whatever interpolation gives inside of them, to the rim', () => {
    const random = randomNumbers(20);
    const dimensions: Vector3 = [19, 8, 33];
    const { samples } = syntheticVolume({ dimensions, kind: 'uint16', field: () => random() });
    const cells = buildMacrocells(samples, dimensions);
    expect(cells.dimensions).to.deep.equal([5, 2, 9]);
    for (let i = 0; i < 4000; i++) {
      const cell = cells.dimensions.map((n) => Math.floor(random() * n));
      // Ends of a cell as often as its inside.
      const place = cell.map((c, axis) => Math.min(dimensions[axis], (c + [0, 1, random()][i % 3]) * cells.size));
      const value = interpolate(
        samples,
        dimensions,
        place.map((x, axis) => x / dimensions[axis]) as unknown as Vector3,
      );
      const at = cell[0] + 5 * (cell[1] + 2 * cell[2]);
      expect(value).to.be.within(cells.low[at] - 1e-6, cells.high[at] + 1e-6);
    }
  });

  it('leave out voxels without data; a cell without any has no range', () => {
    const samples = new Float32Array(8 * 4 * 4).fill(NaN);
    const none = buildMacrocells(samples, [8, 4, 4]);
    expect(none.low[0]).to.equal(Infinity);
    expect(none.high[1]).to.equal(-Infinity);
    samples[7] = 4;
    const one = buildMacrocells(samples, [8, 4, 4]);
    expect([one.low[1], one.high[1]]).to.deep.equal([4, 4]);
    expect(one.low[0]).to.equal(Infinity);
  });
});

describe('the empty-space distance', () => {
  it('knows which ranges of values a transfer function shows', () => {
    const shown: [number, number][] = [
      [0.71, 0.72],
      [0, 1],
      [0.6, 0.701],
      [0.799, 0.9],
      [0.95, 0.95],
      [0.96, 2],
      [0.75, 0.75],
    ];
    const hidden: [number, number][] = [
      [0, 0.7],
      [-5, 0.1],
      [0.8, 0.949],
      [0.9, 0.9],
    ];
    for (const [low, high] of shown) expect(contributionOf(gaps)(low, high), `${low} to ${high}`).to.equal(true);
    for (const [low, high] of hidden) expect(contributionOf(gaps)(low, high), `${low} to ${high}`).to.equal(false);
    expect(contributionOf([{ value: 3, color: white, opacity: 0.1 }])(-9, -8)).to.equal(true);
    expect(contributionOf([{ value: 3, color: white, opacity: 0 }])(-9, 9)).to.equal(false);
  });

  it('of a cell is the number of cells to anything visible, along any axis', () => {
    const dimensions: Vector3 = [72, 64, 80];
    const volume = syntheticVolume({ dimensions, kind: 'uint8', field: blobs });
    const rings = measureEmptySpace(volume.macrocells, [contributionOf(gaps)], volume);
    const [nx, ny, nz] = volume.macrocells.dimensions;
    const shows = Array.from(rings, (_, c) =>
      contributionOf(gaps)(volume.slope * volume.macrocells.low[c], volume.slope * volume.macrocells.high[c]),
    );
    expect(shows.filter(Boolean).length).to.be.within(2, 100);
    for (let c = 0; c < rings.length; c++) {
      const [x, y, z] = [c % nx, Math.floor(c / nx) % ny, Math.floor(c / nx / ny)];
      let nearest = 255;
      shows.forEach((shown, d) => {
        if (shown)
          nearest = Math.min(
            nearest,
            Math.max(
              Math.abs(x - (d % nx)),
              Math.abs(y - (Math.floor(d / nx) % ny)),
              Math.abs(z - Math.floor(d / nx / ny)),
            ),
          );
      });
      expect(rings[c], `cell ${c} of ${nx * ny * nz}`).to.equal(nearest);
    }
  });

  it("is right: at no point of an empty cell is there anything to see, whatever the slope's sign", () => {
    const random = randomNumbers(21);
    const dimensions: Vector3 = [40, 40, 40];
    for (const slope of [1, -1]) {
      const volume = {
        ...syntheticVolume({ dimensions, kind: 'float32', field: blobs, slope }),
        intercept: slope < 0 ? 0.9 : 0,
      };
      const rings = measureEmptySpace(volume.macrocells, [contributionOf(gaps)], volume);
      let looked = 0;
      for (let i = 0; i < 5000; i++) {
        const p: Vector3 = [random(), random(), random()];
        const [x, y, z] = p.map((u) => Math.floor((u * 40) / volume.macrocells.size));
        if (rings[x + 10 * (y + 10 * z)] === 0) continue;
        looked++;
        const value = volume.slope * interpolate(volume.samples, dimensions, p) + volume.intercept;
        expect(evaluate(gaps, value)[3]).to.equal(0);
      }
      expect(looked).to.be.above(200);
    }
  });
});
