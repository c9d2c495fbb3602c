import { expect } from '@esm-bundle/chai';
import { gatherPicture } from '../../../../src/viewer/frames/gather-picture.ts';
import type { Gathering } from '../../../../src/viewer/frames/gather-picture.ts';
import { plainRays } from '../../../../src/renderer/ray/ray-plan.ts';
import type { Pass, Scene } from '../../../../src/viewer/model/scene.ts';
import { fakeOf, fakeScene } from '../../../helpers/fake.ts';

/** A scene of one pass. @param finished - when the GPU has drawn what it was told to */
function sceneOf(webgl2: boolean, finished: () => Promise<void>): { scene: Scene; rows: number[]; pieces: number[] } {
  const rows: number[] = [];
  const pieces: number[] = [];
  const scene = fakeScene({
    device: { maxTextureSize: 4096, webgl2 },
    startGathering: (_, { width, height }) => {
      expect(rows, 'before the first piece').to.deep.equal([]);
      return [fakeOf<Pass>('Pass', { width, height, stride: 1, over: undefined })];
    },
    gather: (_, { firstRow, rows: count }) => {
      pieces.push(count);
      for (let row = firstRow; row < firstRow + count; row++) rows.push(row);
    },
    finished,
  });
  return { scene, rows, pieces };
}

/** A plan of a picture that is 100 pixels wide. */
function pictureOf(height: number): Pick<Gathering, 'plan'> {
  return { plan: { ...plainRays, picture: { width: 100, height } } };
}

/** Pieces that always take too long: each has as few rows as may be. */
const picture = { ...pictureOf(80), rows: 16, pieceMs: 1e-6 };

const nextTask = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('a picture in pieces', () => {
  for (const [what, webgl2, finished] of [
    ['fences', true, nextTask],
    ['none, as in WebGL 1', false, async () => {}],
  ] as const) {
    it(`lets the page go on, and has each row once, with ${what}`, async () => {
      const { scene, rows } = sceneOf(webgl2, finished);
      const seen: number[] = [];
      const page = setInterval(() => seen.push(rows.length));
      expect(await gatherPicture(scene, picture, () => true)).to.be.a('number');
      clearInterval(page);
      expect(rows).to.deep.equal(Array.from({ length: 80 }, (_, row) => row));
      expect(new Set(seen).size, 'tasks of the page between pieces').to.be.at.least(4);
    });

    it(`is given up where the page changes something meanwhile, with ${what}`, async () => {
      const { scene, rows } = sceneOf(webgl2, finished);
      let goesOn = true;
      setTimeout(() => (goesOn = false));
      expect(await gatherPicture(scene, picture, () => goesOn)).to.equal(null);
      expect(rows.length).to.be.below(80);
    });
  }

  it('has no more than twice the rows in a piece that it should have, however little those at its empty edge took', async () => {
    const { scene, rows, pieces } = sceneOf(true, nextTask);
    expect(await gatherPicture(scene, { ...picture, ...pictureOf(400), pieceMs: 1e6 }, () => true)).to.be.a('number');
    expect(rows.length).to.equal(400);
    expect(pieces[0]).to.equal(8);
    expect(Math.max(...pieces)).to.equal(2 * picture.rows);
  });

  it('begins each piece at a whole quad, whatever the one before took', async () => {
    for (const pieceMs of [1e-6, 3, 1e6]) {
      const { scene, pieces } = sceneOf(true, nextTask);
      expect(await gatherPicture(scene, { ...picture, ...pictureOf(301), rows: 35, pieceMs }, () => true)).to.be.a(
        'number',
      );
      expect(
        pieces.slice(0, -1).every((count) => count % 4 === 0),
        pieces.join(' '),
      ).to.equal(true);
      expect(pieces.reduce((sum, count) => sum + count, 0)).to.equal(301);
    }
  });
});
