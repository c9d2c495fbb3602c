// Pictures at rest of what is opaque at once, against rays in float64 that miss no crossing: their errors, and what is said of them.
import { expect } from '@esm-bundle/chai';
import { listOpaqueScenes } from '../../../accuracy/opaque-scenes.ts';
import { measureTrueError } from '../../../accuracy/compare-shown.ts';
import { ExactCells } from '../../../accuracy/exact-cells.ts';
import { casesOf, takesAll } from '../../../helpers/cases.ts';
import { drawAtRest } from '../../../helpers/at-rest.ts';
import { shareScene } from '../../../helpers/picture.ts';
import '../../../helpers/provide-substeps.ts';

/**
 * Of `npm run accuracy -- opaque`. Before rays looked for jumps, these were said to be kept, with an RMSE of 0.02 to 0.99, and were off by 1.62 to 5.22: two to twenty-two rays that graze something
 * missed it, or met it where it is not.
 */
const scenes = [
  ['clouds of three scales', 0],
  ['clouds of three scales', 2],
  ['a sheared cloud', 2],
  // Where rays looked for turns by three samples, these were said to be kept, with E of 1.82, 2.69 and 1.22: thin shells, and tips, that two or three rays touch between two samples.
  ['clouds of three scales', 1],
  ['wires', 0],
  ['bright specks near the threshold', 2],
  // This stopped at a level that was said not to keep, and the next one would have.
  ['noise', 1],
  // This was not kept at any level, with E of 18.87: the tip of a speck within a ramp to full opacity.
  ['tips of specks', 1],
] as const;

/** An RMSE of less is no more than rounding to 8 bits makes, 1/255: to state it by a factor helps nobody. */
const rounding = 1 / Math.sqrt(12);

for (const version of [2, 1] as const) {
  describe(`what is opaque at once, in WebGL ${version}`, () => {
    const shared = shareScene({ webgl1: version === 1 });
    for (const [called, number] of version === 2
      ? casesOf(scenes, (_, i) => [3, 7].includes(i))
      : takesAll
        ? scenes.slice(2, 5)
        : []) {
      it(`is shown wherever a ray touches it, and its error is as it is said: ${called}, ${number}`, async function () {
        this.timeout(300_000);
        const { name, scene } = (await listOpaqueScenes(called))![number];
        const { volume, transferFunction, size, optics } = scene;
        const { stated, isKept, shown } = await drawAtRest(shared(), scene);
        const exact = new ExactCells({ volume, transferFunction, referenceLength: optics!.referenceLength! }).draw(
          shared().viewAt(size),
          size,
        )!;
        const error = measureTrueError(shown, exact);
        console.log(
          `${name}: E ${error.e.toFixed(2)}, RMSE stated ${stated.rms.toFixed(2)}, true ${error.rms.toFixed(2)}, largest of ${stated.rays} rays ${stated.probed.toFixed(1)}, of all ${error.max.toFixed(1)}`,
        );
        expect(isKept).to.equal(true);
        expect(error.e).to.be.at.most(1);
        expect(Math.max(rounding, stated.rms) / Math.max(rounding, error.rms)).to.be.within(0.5, 2);
        if (stated.max !== null) expect(stated.max, 'all pixels were probed').to.be.at.least(error.max);
        expect(stated.rays).to.be.within(Math.min(1000, error.covered), size.width * size.height);
        expect(stated.probed).to.be.within(error.p99 / 2, error.max + 1);
      });
    }
  });
}
