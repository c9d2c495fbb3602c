// Small things are in the picture at rest as they are in rays in float64, where something cuts the volume, stands in it, or is painted in it, also in WebGL 1.
// `npm run accuracy -- among` measures more of it.
import { expect } from '@esm-bundle/chai';
import { measureAmong } from '../../../accuracy/among-page.ts';
import type { SeenThings } from '../../../accuracy/among-page.ts';
import { measurePane } from '../../../accuracy/among-panes.ts';
import { measureScene } from '../../../accuracy/small-page.ts';
import { casesOf, takesAll } from '../../../helpers/cases.ts';

/** Of a thing's contrast in full rays, the least that the picture has. */
const minKept = 0.75;

/** The kept shares of what counts. */
function listKept({
  pictures,
  minContrast,
}: {
  readonly pictures: readonly Pick<SeenThings, 'things'>[];
  readonly minContrast: number;
}): number[] {
  return pictures.flatMap(({ things }) =>
    things.flatMap((thing) => (thing && thing.contrast >= minContrast ? [thing.kept] : [])),
  );
}

function expectAll(name: string, kept: readonly number[], fewest: number): void {
  console.log(`${name}: ${kept.length} things, at least ${(100 * Math.min(...kept)).toFixed(0)} % kept`);
  expect(kept.length, 'things that full rays show').to.be.at.least(fewest);
  expect(
    kept.filter((share) => !(share >= minKept)),
    'dimmed',
  ).to.deep.equal([]);
}

/** As x3dom sees Apple's systems, where it asks for WebGL 1. */
async function inWebGl1<T>(use: () => Promise<T>): Promise<T> {
  Object.defineProperty(navigator, 'platform', { value: 'MacIntel', configurable: true });
  try {
    return await use();
  } finally {
    Reflect.deleteProperty(navigator, 'platform');
  }
}

const cut = 'Specks in empty space, `cutout`';

describe('the picture at rest of small things', function () {
  this.timeout(60_000);

  for (const [name, fewest] of casesOf(
    [
      [cut, 40],
      ['Specks in a veil, an oblique `<volume-clip>`', 20],
      ['Specks in a veil, on both sides of a plate', 20],
      ['Specks on a slice, 1.05 pixels a voxel', 50],
    ] as const,
    ([name]) => name === cut || name.startsWith('Specks on a slice'),
  )) {
    it(name, async () => {
      const result = await measureAmong(name, { angles: 1 });
      expect(result.webgl).to.equal(2);
      expectAll(name, listKept(result), fewest);
    });
  }

  it('in a pane, where each speck on the slice is seen', async () => {
    const result = await measurePane(1.13, 1);
    expectAll('a pane', listKept(result), result.pictures[0].things.length);
  });

  if (takesAll)
    it('plain, in WebGL 1', async () => {
      const result = await inWebGl1(() =>
        measureScene('Plate of 1 voxel, almost from its edge', { angles: 1, doubts: false }),
      );
      expect(result.webgl).to.equal(1);
      expectAll('plain', listKept(result), 30);
    });

  it('cut, and with slices, in WebGL 1', async () => {
    for (const [name, fewest] of casesOf(
      [
        ['Specks in a `region` that is 0.8 voxels thick', 40],
        ['Specks in a veil, on and before three slices', 15],
      ] as const,
      (_, i) => i === 0,
    )) {
      const result = await inWebGl1(() => measureAmong(name, { angles: 1 }));
      expect(result.webgl).to.equal(1);
      expectAll(name, listKept(result), fewest);
    }
  });

  it('lacks some of them with too few steps: so they would be missed', async () => {
    const kept = listKept(await measureAmong(cut, { angles: 1, attributes: { steps: '24' } }));
    expect(kept.filter((share) => share < minKept).length).to.be.at.least(5);
  });
});
