import { expect } from '@esm-bundle/chai';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { drawLots, listClassified } from '../helpers/classified.ts';
import type { Classified } from '../helpers/classified.ts';
import { comparePictures, drawPicture, drawReference, shareScene } from '../helpers/picture.ts';
import { remember } from '../helpers/remember.ts';

const referenceOf = remember(({ view, exact }: Classified): Float64Array => drawReference({ ...view, volume: exact }));

interface Found {
  /** Largest difference from the reference, 1/255. */
  readonly worst: number;
  /** From a picture for which nothing is skipped. */
  readonly skipped: number;
  /** What is wrong, and of which scene. */
  readonly wrong: readonly string[];
}

function measure(scene: VolumeScene, one: Classified): Found {
  scene.resize(...one.view.size!);
  const [skipping, plain] = [true, false].map((skips) => {
    scene.layers[0].skipping = skips;
    return drawPicture(scene, one.view);
  });
  scene.layers[0].skipping = true;
  const { worst } = comparePictures(skipping, referenceOf(one));
  const skipped = comparePictures(skipping, plain).worst;
  const wrong = [...(worst > 2 ? [`${worst.toFixed(2)} off`] : []), ...(skipped > 0 ? [`skipping changes ${skipped}`] : [])];
  return { worst, skipped, wrong: wrong.map((what) => `${what}: ${one.name}`) };
}

const classified = listClassified();
const lots = Array.from({ length: 100 }, (_, i) => drawLots(1000 + i));

for (const version of [2, 1] as const) {
  describe(`values look as the transfer function says in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    for (const one of classified) {
      it(one.name, () => {
        expect(scene().device.webgl2).to.equal(version === 2);
        expect(Math.max(...referenceOf(one)), 'something is seen').to.be.above(60);
        const { worst, skipped, wrong } = measure(scene(), one);
        console.log(`WebGL ${version} ${one.name}: worst ${worst.toFixed(2)}, skipping ${skipped}`);
        expect(wrong).to.deep.equal([]);
      });
    }

    it('in 100 random scenes', () => {
      const found = lots.map((one) => measure(scene(), one));
      console.log(`WebGL ${version}: worst ${Math.max(...found.map(({ worst }) => worst)).toFixed(2)}, skipping ${Math.max(...found.map(({ skipped }) => skipped))}`);
      expect(found.flatMap(({ wrong }) => wrong)).to.deep.equal([]);
    });
  });
}
