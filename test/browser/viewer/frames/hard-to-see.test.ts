// What is said of errors where hardly anything is to be seen, or nothing.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { createClip } from '../../../../src/renderer/ray/modules/clip.ts';
import { unitToWorld } from '../../../../src/volume/grid.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { scatter, withVoxels } from '../../../accuracy/hard-volumes.ts';
import { changePlan } from '../../../helpers/change-plan.ts';
import { measureAtRest } from '../../../helpers/at-rest.ts';
import type { RestResult, RestScene } from '../../../helpers/at-rest.ts';
import { keep } from '../../../helpers/clips.ts';
import { shareScene } from '../../../helpers/picture.ts';

const bright = parseTransferFunction('0.3 #fa6 0, 1 #fa6 60%', [0, 1]);
/** Of a voxel only what is next to its middle shows. */
const tips = parseTransferFunction('0.93 #fff 0, 1 #fff 99%', [0, 1]);

const cube: Vector3 = [40, 40, 40];

/** @param at - share of the grid */
function look({ grid }: Volume, far: number, at: Vector3 = [0.5, 0.5, 0.5]): Camera {
  return orbitCamera({ theta: 0, phi: Math.PI / 2, radius: far }, transformPoint(unitToWorld(grid), at), 0.5);
}

describe('the error that is stated where hardly anything is seen', () => {
  const shared = shareScene({});
  const measure = (scene: Omit<RestScene, 'style'>): Promise<RestResult> => {
    changePlan(shared(), { slices: [], cuts: [] });
    return measureAtRest(shared(), { ...scene, style: null });
  };

  it('is that of the few pixels that show something, wherever they are', async function () {
    this.timeout(240_000);
    const volume = withVoxels(
      [64, 64, 64],
      [
        [2, 2, 2],
        [61, 61, 61],
      ],
    );
    const camera = orbitCamera(
      { theta: 0.7, phi: 1.1, radius: 220 },
      transformPoint(unitToWorld(volume.grid), [0.5, 0.5, 0.5]),
      0.5,
    );
    const { stated, isKept, error } = await measure({
      volume,
      transferFunction: tips,
      camera,
      size: { width: 700, height: 700 },
    });
    console.log(
      `stated ${stated.rms.toFixed(2)}, ${stated.max?.toFixed(1)}; true ${error.rms.toFixed(2)}, ${error.max.toFixed(1)}; ${error.covered} pixels`,
    );
    expect(error.covered).to.be.within(1, 20);
    expect(isKept).to.equal(true);
    expect(stated.rms, 'as it says').to.be.at.most(1);
    expect(stated.max).to.be.at.least(error.max);
  });

  it('is what could be missed, and not said to be kept, where no probe met what may be there', async function () {
    this.timeout(120_000);
    const volume = withVoxels(cube, scatter(cube, 24));
    const { stated, isKept, error } = await measure({
      volume,
      transferFunction: bright,
      camera: look(volume, 110),
      size: { width: 60, height: 60 },
      set: (gpu) =>
        changePlan(gpu, { slices: [], cuts: [{ create: createClip, items: [keep(volume.grid, [0, 0, 1], 19.99)] }] }),
    });
    expect(error.covered, 'all is cut away').to.equal(0);
    expect(stated.rms).to.be.above(10);
    expect(isKept).to.equal(false);
  });

  for (const [name, far, at] of [
    ['a volume behind the eye', 20, [0.5, 3, 0.5]],
    ['things behind an eye in the volume', 1, [0.5, 0.6, 0.5]],
  ] as const) {
    it(`is none of ${name}`, async function () {
      this.timeout(120_000);
      const volume = withVoxels(cube, scatter([40, 12, 40], 20));
      const { stated, isKept, error } = await measure({
        volume,
        transferFunction: bright,
        camera: look(volume, far, at),
        size: { width: 60, height: 60 },
      });
      expect(error.covered).to.equal(0);
      expect(stated).to.deep.equal({ rms: 0, p99: 0, max: 0, probed: 0, rays: 0 });
      expect(isKept).to.equal(true);
    });
  }
});
