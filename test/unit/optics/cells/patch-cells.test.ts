// In which macrocells gradients may be how large, against all that rays could find there.
import { expect } from '@esm-bundle/chai';
import { cartesianGradient } from '../../../../src/optics/rays/gradient.ts';
import { boundGradients, contributionOfGradients } from '../../../../src/optics/cells/patch-cells.ts';
import { perWorldUnit } from '../../../../src/optics/rays/patch-classify.ts';
import type { Patch } from '../../../../src/optics/transfer/patches.ts';
import { cartesianField } from '../../../../src/optics/rays/ray-field.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import { length } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions = [19, 17, 21] as const;

function rough(options: { spacing?: Vector3; skewed?: boolean; holes?: boolean }): Volume {
  const random = randomNumbers(3);
  const indexToWorld = options.skewed
    ? { indexToWorld: [2, 0.9, 0, -9, 0, 1.5, 0.4, 3, 0.3, 0, 1, 7, 0, 0, 0, 1] as const }
    : {};
  const volume = syntheticVolume({
    dimensions,
    kind: 'float32',
    spacing: options.spacing,
    slope: -300,
    intercept: 20,
    ...indexToWorld,
    field: (x) => (options.holes && random() < 0.05 ? NaN : random() ** 12 * (x > 0.5 ? 1 : 0.2)),
  });
  return options.holes
    ? { ...volume, hasNoData: true, macrocells: buildMacrocells(volume.samples, dimensions) }
    : volume;
}

describe('the gradients that macrocells may have', () => {
  for (const [name, options] of Object.entries({
    'a cubic grid': {},
    'long voxels': { spacing: [1, 2, 5] as Vector3 },
    'a skewed grid': { skewed: true },
    'places without data': { holes: true },
  })) {
    it(`bound all of ${name}, and not by much`, () => {
      const volume = rough(options);
      const {
        grid,
        macrocells: {
          dimensions: [nx, ny],
          size,
        },
      } = volume;
      const bounds = boundGradients(volume);
      const field = cartesianField({ ...volume, dimensions });
      const gradient = cartesianGradient(field, grid);
      const random = randomNumbers(8);
      const largest = new Float64Array(bounds.length);
      for (let n = 0; n < 40_000; n++) {
        const place = [random(), random(), random()] as const;
        const [i, j, k] = place.map((x, axis) => Math.floor((x * dimensions[axis]) / size));
        const cell = i + nx * (j + ny * k);
        largest[cell] = Math.max(
          largest[cell],
          perWorldUnit(grid) * length(gradient(place, field.sampleAt(place)).world),
        );
      }
      for (let cell = 0; cell < bounds.length; cell++)
        expect(bounds[cell], `cell ${cell}`).to.be.at.least(largest[cell]);
      const closest = bounds.reduce((min, bound, cell) => Math.min(min, bound / largest[cell]), Infinity);
      expect(closest).to.be.below('holes' in options ? 4 : 3);
    });
  }

  it('say where a patch may show: not in what is flat, nor at other values', () => {
    const volume = syntheticVolume({ dimensions: [20, 4, 4], field: (x) => (x > 0.9 ? 1 : 0.4) });
    const box: Patch = { kind: 'box', values: [0.3, 0.5], gradients: [0.1, 0.4], color: [1, 1, 1], opacity: 0.5 };
    const shows = contributionOfGradients([box], volume);
    expect([0, 1, 2, 3, 4].map((cell) => shows(0.4, 0.4, cell))).to.deep.equal([false, false, false, true, true]);
    expect(shows(0.6, 1, 4)).to.equal(false);
    expect(
      contributionOfGradients([{ ...box, gradients: [0, 0.4] }], volume)(0.4, 0.4, 0),
      'what is flat shows',
    ).to.equal(true);
    const bell: Patch = {
      kind: 'gaussian',
      value: 0.4,
      gradient: 0.4,
      widths: [0.1, 0.1],
      color: [1, 1, 1],
      opacity: 0.5,
    };
    expect([0, 4].map((cell) => contributionOfGradients([bell], volume)(0.4, 0.4, cell))).to.deep.equal([false, true]);
  });
});
