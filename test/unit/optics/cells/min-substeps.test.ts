import { expect } from '@esm-bundle/chai';
import { minSubsteps } from '../../../../src/optics/cells/min-substeps.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import type { RayStages } from '../../../../src/optics/rays/ray-stages.ts';
import { scale } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const whole = syntheticVolume({ dimensions: [16, 8, 8] });

/** Two cells along x, each of 8 voxels. */
const volume = { ...whole, macrocells: buildMacrocells(whole.samples, whole.grid.dimensions, 8) };

/** From one voxel to the next along x. */
const forward: Vector3 = [1 / 16, 0, 0];

const at = (voxel: number): Vector3 => [voxel / 16, 0.5, 0.5];

/** What a cell with coarse voxels says: each is as long as so many of the finest, and needs 2 to `power` samples. */
const coded = (longer: number, power: number): number => 4 * Math.log2(longer) + power;

describe('the steps of a cell', () => {
  it('are cut where it needs more samples, and taken together where its voxels are long', () => {
    const substeps = (code: number, voxelsPerStep = 1): number =>
      minSubsteps(volume, Uint8Array.of(code, 0), voxelsPerStep)(at(0), scale(forward, voxelsPerStep));
    expect([0, 1, 2, 3].map((code) => substeps(code))).to.deep.equal([1, 2, 4, 8]);
    expect(substeps(coded(4, 0)), 'one sample in four voxels').to.equal(1 / 4);
    expect(substeps(coded(4, 1)), 'two').to.equal(1 / 2);
    expect(substeps(coded(4, 3)), 'eight').to.equal(2);
    expect(substeps(coded(4, 0), 0.5), 'with shorter steps each voxel has two samples, long ones too').to.equal(1 / 4);
    expect(substeps(coded(4, 1), 0.5), 'two are what it needs').to.equal(1 / 4);
    expect(substeps(coded(4, 0), 2), 'steps of two voxels').to.equal(1 / 2);
    expect(substeps(coded(4, 0), 0), 'where cells do not matter').to.equal(1);
  });

  it('are taken together no further than to its wall, in any direction', () => {
    const codes = Uint8Array.of(coded(8, 0), 0);
    const ends = [0, 2, 4.5, 6, 7.5].map((voxel) => 1 / minSubsteps(volume, codes, 1)(at(voxel), forward));
    expect(ends).to.deep.equal([7, 5, 3, 1, 1]);
    const back = [7.5, 4.5, 1.5].map((voxel) => 1 / minSubsteps(volume, codes, 1)(at(voxel), scale(forward, -1)));
    expect(back).to.deep.equal([7, 4, 1]);
    const random = randomNumbers(3);
    for (let n = 0; n < 1000; n++) {
      const place: Vector3 = [0.5 * random(), random(), random()];
      const way = [random(), random(), random()].map((x) => 0.2 * (x - 0.5)) as unknown as Vector3;
      const steps = 1 / minSubsteps(volume, codes, 1)(place, way);
      expect(steps).to.be.within(1, 8);
      if (steps > 1)
        for (const [axis, x] of place.entries())
          expect(x + steps * way[axis], `${place.join(' ')} by ${way.join(' ')}`).to.be.within(0, axis === 0 ? 0.5 : 1);
    }
  });

  it('take as few samples along a ray, and end where the ray ends', () => {
    /** The number of samples, and the length of all segments. */
    const cast = (codes: Uint8Array, steps: number): readonly [number, number] => {
      let [samples, length] = [0, 0];
      const stages: RayStages = {
        intervals: [() => ({ entry: 0, exit: 1, behind: null })],
        field: { sampleAt: () => ({ value: samples++, valid: true }), isFolded: () => false },
        moreFields: [],
        classify: {
          classifySegment: () => [0, 0, 0, 0],
          classifyValue: () => [0, 0, 0, 0],
          countSubsteps: () => 1,
        },
        shades: [],
        gather: () => ({
          add: ({ span }) => (length += span),
          chooseSubsteps: () => 1,
          finish: () => [0, 0, 0, 0],
        }),
        eyeT: 0,
        step: 1 / steps,
        maxSubsteps: 1,
        minSubsteps: minSubsteps(volume, codes, 1),
      };
      castRay(stages, { point: [0, 0.5, 0.5], direction: [1, 0, 0], lengthPerT: 1 });
      return [samples, length];
    };
    expect(cast(Uint8Array.of(0, 0), 16)).to.deep.equal([17, 1]);
    // At 0, 4, 7 and beyond the wall, at 8; then each voxel.
    expect(cast(Uint8Array.of(coded(4, 0), 0), 16)).to.deep.equal([12, 1]);
    expect(cast(Uint8Array.of(coded(4, 0), coded(4, 0)), 16)[0]).to.equal(7);
    const [some, all] = cast(Uint8Array.of(coded(4, 0), coded(4, 2)), 15.5);
    expect(some).to.be.below(14);
    expect(all, 'the last step is shorter').to.be.closeTo(1, 1e-12);
  });
});
