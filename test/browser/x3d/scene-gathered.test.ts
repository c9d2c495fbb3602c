import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { drawInPieces } from '../../helpers/draw-in-pieces.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

const veil: TransferFunction = [
  { value: 0.2, color: [0.2, 0.4, 1], opacity: 0 },
  { value: 1, color: [1, 0.8, 0.2], opacity: 0.6 },
];
const volume = syntheticVolume({
  dimensions: [20, 24, 28],
  field: (x, y, z) => Math.exp(-8 * ((x - 0.4) ** 2 + (y - 0.5) ** 2 + (z - 0.6) ** 2)),
});
const size = { width: 61, height: 47 };

describe('a picture in pieces', () => {
  for (const webgl1 of [false, true]) {
    it(`is the one that is drawn at once, in WebGL ${webgl1 ? 1 : 2}, after a smaller one and before the next`, async () => {
      await withScene({ webgl1 }, (scene) => {
        const diagonal = longestDiagonal(volume.grid);
        scene.setVolume(volume);
        void scene.setAppearance({
          optics: { transferFunction: veil, referenceLength: 4, opacityFactor: 1, lightFactor: 1 },
        });
        expect(scene.gatherable, 'before the first picture').to.equal(false);
        for (const theta of [0.3, 2]) {
          changePlan(scene, { camera: orbitCamera({ theta, phi: 1.1, radius: 1.5 * diagonal }, [0, 0, 0], 0.8) });
          changePlan(scene, { picture: size });
          drawAt(scene, diagonal / 50);
          const atOnce = readPixels(scene);
          changePlan(scene, { picture: { width: 20, height: 15 } });
          drawAt(scene, diagonal / 10);
          const quick = readPixels(scene);
          expect(scene.gatherable).to.equal(true);
          drawInPieces(scene, diagonal / 50, size);
          drawAt(scene, diagonal / 10);
          expect(readPixels(scene), 'nothing of it is seen yet').to.deep.equal(quick);
          changePlan(scene, { picture: size, stepLength: diagonal / 50 });
          scene.drawGathered();
          const { worst } = comparePictures(readPixels(scene), atOnce);
          expect(worst, `from ${theta}`).to.be.at.most(1);
          expect(Math.max(...atOnce)).to.be.above(100);
          expect(scene.gatherable, 'right after it').to.equal(true);
        }
      });
    });
  }
});
