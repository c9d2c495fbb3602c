// Small things are in the picture at rest as they are in full rays. `npm run accuracy -- small` measures more of it.
import { expect } from '@esm-bundle/chai';
import { measureScene } from '../../../accuracy/small-page.ts';
import { casesOf } from '../../../helpers/cases.ts';

/** Of a thing's contrast in full rays, the least that the element's picture has. */
const minKept = 0.75;

describe('the picture at rest of small things', () => {
  for (const [name, fewest] of casesOf(
    [
      ['Specks of 1 voxel in a veil, large', 50],
      ['Specks of 1 voxel in empty space', 50],
      ['Specks of 1 voxel in a veil, small', 30],
      ['Plate of 1 voxel', 30],
      ['Wires of 1 voxel', 40],
    ] as const,
    ([name]) => /empty space|Wires/.test(name),
  )) {
    it(name, async function () {
      this.timeout(60_000);
      const { pictures, minContrast } = await measureScene(name, { angles: 1, doubts: false });
      const kept = pictures.flatMap(({ things }) =>
        things.flatMap((thing) => (thing && thing.contrast >= minContrast ? [thing.kept] : [])),
      );
      console.log(`${name}: ${kept.length} things, at least ${(100 * Math.min(...kept)).toFixed(0)} % kept`);
      expect(kept.length, 'things that full rays show').to.be.at.least(fewest);
      expect(
        kept.filter((share) => share < minKept),
        'dimmed',
      ).to.deep.equal([]);
    });
  }
});
