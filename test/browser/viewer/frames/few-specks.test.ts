// What is stated of the error where what shows covers few pixels.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import { outlinePatches } from '../../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../../src/optics/transfer/patches.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { casesOf } from '../../../helpers/cases.ts';
import { measureAtRest } from '../../../helpers/at-rest.ts';
import { shareScene } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** What is deeper than the specks need only takes time. */
const dimensions = [20, 6, 20] as const;

/** Four specks of one voxel in a value, in two cells at corners that are far apart: what lies between is crossed at once, and probes miss most of them. */
function specks(): Volume {
  const volume = syntheticVolume({ dimensions, field: () => 0.4 });
  for (const [i, j, k] of [
    [18, 2, 2],
    [17, 3, 6],
    [2, 3, 17],
    [6, 2, 18],
  ])
    volume.samples[i + dimensions[0] * (j + dimensions[1] * k)] = 200;
  return { ...volume, macrocells: buildMacrocells(volume.samples, dimensions) };
}

const band: Patch = { kind: 'box', values: [0.05, 0.95], gradients: [0.15, 0.25], color: [1, 0.5, 0.2], opacity: 0.6 };

const byValue: TransferFunction = [
  { value: 0.5, color: [1, 0.5, 0.2], opacity: 0 },
  { value: 0.6, color: [1, 0.5, 0.2], opacity: 0.6 },
  { value: 0.7, color: [1, 1, 1], opacity: 0.6 },
];

const looks: Record<string, readonly [RayStyle | null, TransferFunction]> = {
  'value and gradient': [{ patches: [band] }, outlinePatches([band], [0.4, 200 / 255])],
  value: [null, byValue],
};

describe('the error that is stated of few specks', () => {
  const shared = shareScene({});
  for (const [name, [style, transferFunction]] of casesOf(Object.entries(looks), (_, i) => i === 0)) {
    it(`is about what it is where they show by ${name}`, async function () {
      this.timeout(240_000);
      const volume = specks();
      const camera = orbitCamera({ theta: 0.7, phi: 1.1, radius: 90 }, boundingSphere(volume.grid).center, 0.3);
      const { stated, error, samplesAVoxel } = await measureAtRest(shared(), {
        volume,
        style,
        transferFunction,
        camera,
        size: { width: 100, height: 100 },
      });
      console.log(
        `${name}: stated ${stated.rms.toFixed(2)}, ${stated.max?.toFixed(1)}; true ${error.rms.toFixed(2)}, ${error.max.toFixed(1)}, E ${error.e.toFixed(2)}; ${error.covered} pixels; ${samplesAVoxel} samples a voxel`,
      );
      expect(error.covered).to.be.within(20, 1000);
      expect(stated.rms / error.rms).to.be.within(0.5, 2);
      expect(stated.max).to.be.at.least(error.max);
    });
  }
});
