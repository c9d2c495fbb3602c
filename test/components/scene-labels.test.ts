// Labels: the GPU's picture against the twin's.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../src/optics/camera.ts';
import { stagesOf } from '../../src/optics/reference.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import { isEdge, listOff } from '../helpers/edges.ts';
import { blocks, mixedLooks } from '../helpers/labels.ts';
import { comparePictures, drawPicture, drawReference, height, raysOf, referenceOf, shareScene, width } from '../helpers/picture.ts';
import type { View } from '../helpers/picture.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' });
const diagonal = longestDiagonal(volume.grid);
const view: View = { volume, camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6), stepLength: diagonal / 60 };

for (const version of [2, 1] as const) {
  describe(`labels in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    for (const [count, name] of [[9, '8 bits'], [1000, '16 bits']] as const) {
      it(`${name}: the picture is the twin's, and another one than without`, async () => {
        const labels = mixedLooks(blocks(volume.grid.dimensions, count));
        await scene().setLabels(null);
        const before = drawPicture(scene(), view);
        await scene().setLabels(labels);
        const got = drawPicture(scene(), view);
        const labelled = { ...view, labels };
        const expected = drawReference(labelled);
        const rays = raysOf(view);
        const stages = stagesOf(referenceOf(labelled), rays);
        const edges = new Set([...listOff(got, expected)].filter((pixel) => isEdge(stages, rays, pixel)));
        const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
        console.log(`WebGL ${version} ${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${edges.size} pixels left out`);
        expect(worst).to.be.at.most(2);
        expect(edges.size).to.be.below(0.02 * width * height);
        expect(comparePictures(got, before).worst).to.be.above(20);
        await scene().setLabels(null);
        expect(comparePictures(drawPicture(scene(), view), before).worst, 'afterwards').to.equal(0);
      });
    }
  });
}
