// The largest error that is stated of a picture at rest is not exceeded where a style alone makes things show.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import type { VolumeStyle } from '../../../../src/optics/transfer/volume-styles.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { casesOf } from '../../../helpers/cases.ts';
import { measureAtRest } from '../../../helpers/at-rest.ts';
import { shareScene } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** One value, but for three voxels. It is flat, and seen from above: depth takes time, and shows no more of them. */
function specks(): Volume {
  const dimensions = [20, 20, 7] as const;
  const volume = syntheticVolume({ dimensions, field: () => 0.4 });
  for (const [i, j, k] of [
    [6, 8, 3],
    [13, 12, 2],
    [9, 10, 4],
  ])
    volume.samples[i + 20 * (j + 20 * k)] = 200;
  return { ...volume, macrocells: buildMacrocells(volume.samples, dimensions) };
}

/** It looks the same whatever the value. */
const oneColor: TransferFunction = [0, 1].map((value) => ({ value, color: [1, 0.8, 0.5] as const, opacity: 0.6 }));

const styled = (...styles: readonly VolumeStyle[]): RayStyle => ({ styles: [{ weight: 1, styles }] });

const looks: Record<string, RayStyle> = {
  '`gradient-opacity`': styled({
    kind: 'gradient',
    stops: [
      [0.11, 0],
      [0.112, 1],
      [0.114, 0],
    ],
  }),
  'a boundary': styled({ kind: 'boundary', retained: 0, boundary: 25, power: 2 }),
  'a silhouette': styled({ kind: 'silhouette', retained: 0.02, boundary: 0.9, sharpness: 300 }),
  'a cartoon': styled({ kind: 'cartoon', parallel: [1, 0.8, 0.3], orthogonal: [0.2, 0, 0.5], steps: 3 }),
  'light on fog of one colour': { lit: true },
};

describe('the largest error that a picture at rest states', () => {
  const shared = shareScene({});
  for (const [name, style] of casesOf(Object.entries(looks), (_, i) => i === 0 || i === 4)) {
    it(`is not exceeded where specks show by ${name} alone`, async function () {
      this.timeout(240_000);
      const volume = specks();
      const camera = orbitCamera({ theta: 0.7, phi: 0.5, radius: 34 }, boundingSphere(volume.grid).center, 0.5);
      const { stated, error, samplesAVoxel } = await measureAtRest(shared(), {
        volume,
        style,
        transferFunction: oneColor,
        camera,
        size: { width: 56, height: 56 },
      });
      console.log(
        `${name}: stated ${stated.rms.toFixed(2)}, ${stated.max?.toFixed(1)}; true ${error.rms.toFixed(2)}, ${error.max.toFixed(1)}; ${samplesAVoxel} samples a voxel`,
      );
      expect(stated.max).to.be.at.least(error.max);
      expect(stated.max).to.be.below(255);
    });
  }
});
