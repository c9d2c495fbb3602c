import { expect } from '@esm-bundle/chai';
import { defaultPreset } from '../../../src/optics/transfer/default-preset.ts';
import { resolveTransferFunction } from '../../../src/optics/transfer/resolve-transfer-function.ts';
import { resolveAppearance } from '../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../src/viewer/model/plain-appearance.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { defaultReferenceLength } from '../../../src/volume/reference-length.ts';

const gridOf = (dimensions: Vector3, spacing: Vector3): ReturnType<typeof cartesianGrid> =>
  cartesianGrid(dimensions, axialIndexToWorld(dimensions, spacing));

describe('the reference length', () => {
  it('is 1 % of the longest edge, to the bit, of all that is not thin', () => {
    for (const [x, y, z] of [
      [100, 100, 100],
      [512, 512, 103],
      [181, 217, 181],
      [240, 240, 48],
      [256, 64, 64],
      [300, 60, 60.5],
    ]) {
      expect(defaultReferenceLength(gridOf([x, y, 1], [0.7, 0.7, 0.7 * z])), `${x} ${y} ${z}`).to.equal(
        Math.max(x * 0.7, y * 0.7, 0.7 * z) / 100,
      );
    }
  });

  it('is such that 20 of them lie across a thin volume', () => {
    for (const [dimensions, spacing] of [
      [
        [200, 200, 1],
        [1, 1, 1],
      ],
      [
        [200, 200, 2],
        [1, 1, 0.01],
      ],
      [
        [100, 100, 30],
        [3000, 3000, 100],
      ],
      [
        [1, 1, 40],
        [1, 1, 1],
      ],
      [
        [1, 500, 500],
        [0.001, 1, 1],
      ],
    ] as const) {
      const thickness = Math.min(...dimensions.map((n, axis) => n * spacing[axis]));
      expect(thickness / defaultReferenceLength(gridOf(dimensions, spacing)), String(dimensions)).to.be.closeTo(
        20,
        1e-9,
      );
    }
  });

  it('shows the middle of the window straight through any thin volume, where 1 % of the longest edge showed nothing', async () => {
    const stops = await resolveTransferFunction(defaultPreset, [0, 1]);
    const middle = stops.find(({ value }) => value === 0.5)!;
    for (const [dimensions, spacing] of [
      [
        [200, 200, 2],
        [1, 1, 0.01],
      ],
      [
        [200, 200, 1],
        [1, 1, 1],
      ],
    ] as const) {
      const grid = gridOf(dimensions, spacing);
      const thickness = dimensions[2] * spacing[2];
      const alphaOver = (length: number): number => 1 - (1 - middle.opacity) ** (thickness / length);
      expect(alphaOver(Math.max(...dimensions) / 100)).to.be.below(0.04);
      expect(alphaOver(defaultReferenceLength(grid))).to.be.within(0.7, 0.85);
    }
  });

  it('is that of the author where there is one', async () => {
    const volume = { grid: gridOf([200, 200, 1], [1, 1, 1]), range: [0, 1] } as unknown as Parameters<
      typeof resolveAppearance
    >[1];
    expect((await resolveAppearance({ ...plainAppearance, referenceLength: 3 }, volume)).referenceLength).to.equal(3);
    expect((await resolveAppearance(plainAppearance, volume)).referenceLength).to.equal(0.05);
  });
});
