// Pictures in pieces where the author's shapes stand in the volume: each piece ends its rays where the whole picture does.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { drawInPieces } from '../../helpers/draw-in-pieces.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { shapesAmong } from '../../helpers/shapes-among.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const veil: TransferFunction = [
  { value: 0.2, color: [0.2, 0.4, 1], opacity: 0 },
  { value: 1, color: [1, 0.8, 0.2], opacity: 0.6 },
];
const volume = syntheticVolume({
  dimensions: [20, 24, 28],
  field: (x, y, z) => Math.exp(-8 * ((x - 0.4) ** 2 + (y - 0.5) ** 2 + (z - 0.6) ** 2)),
});
const diagonal = longestDiagonal(volume.grid);
const size = { width: 83, height: 61 };
const glass =
  '<shape><appearance><material diffuseColor="0 0 0" emissiveColor="0.2 0.9 0.4" transparency="0.5"></material></appearance><box size="9 9 9"></box></shape>';
const shapes = {
  ...shapesAmong(volume.grid),
  glass,
  'glass and a ball': glass + shapesAmong(volume.grid)['a large ball'],
};

/** Kinds that are drawn in WebGL 1 too. */
const both: readonly string[] = ['several of them', 'glass and a ball'];

describe('a picture in pieces, with shapes in it', () => {
  for (const webgl1 of [false, true]) {
    for (const [name, children] of Object.entries(shapes)) {
      if (webgl1 && !both.includes(name)) continue;
      it(`is the one that is drawn at once: ${name}, WebGL ${webgl1 ? 1 : 2}`, () =>
        withScene({ webgl1, children }, (scene) => {
          scene.setVolume(volume);
          changePlan(scene, { maxCurvature: 0, edgeCurvature: 30 }); // As at rest.
          void scene.setAppearance({
            optics: { transferFunction: veil, referenceLength: 4, opacityFactor: 1, lightFactor: 1 },
          });
          for (const theta of [0.3, 2]) {
            changePlan(scene, { camera: orbitCamera({ theta, phi: 1.1, radius: 1.5 * diagonal }, [0, 0, 0], 0.8) });
            changePlan(scene, { picture: size });
            drawAt(scene, diagonal / 50);
            const atOnce = readPixels(scene);
            // Of another shape, too, as rounding makes it.
            changePlan(scene, { picture: { width: 20, height: 14 } });
            drawAt(scene, diagonal / 10);
            const quick = readPixels(scene);
            expect(scene.gatherable).to.equal(true);
            expect(scene.endsAtShapes, 'rays end at them').to.equal(true);
            drawInPieces(scene, diagonal / 50, size);
            expect(readPixels(scene), 'nothing of it is seen yet').to.deep.equal(quick);
            changePlan(scene, { picture: size, stepLength: diagonal / 50 });
            scene.drawGathered();
            const inPieces = readPixels(scene);
            expect(comparePictures(inPieces, atOnce).worst, `from ${theta}`).to.equal(0);
            drawAt(scene, diagonal / 50);
            expect(comparePictures(readPixels(scene), atOnce).worst, 'the next one, at once').to.equal(0);
            // What was begun and given up leaves nothing behind.
            changePlan(scene, { picture: { width: 20, height: 14 } });
            scene.startGathering({ stepLength: diagonal / 50 }, size);
            drawAt(scene, diagonal / 10);
            expect(readPixels(scene), 'a smaller one after it').to.deep.equal(quick);
          }
        }));
    }
  }
});
