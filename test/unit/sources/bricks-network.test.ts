// Bricks of pyramids that are larger than any disk, from a server on this machine that computes their chunks, delays answers and fails.
import { expect } from '@esm-bundle/chai';
import type { BrickStore } from '../../../src/formats/base/brick-store.ts';
import type { Brick } from '../../../src/bricks/pyramid.ts';
import { openZarr } from '../../../src/sources/open-zarr.ts';
import { expectFormula, failureOf, noSignal, openBricksOf } from '../../helpers/brick-stores.ts';
import { formulaFiles, formulaOf } from '../../helpers/formula-pyramid.ts';
import type { Formula, FormulaPyramid } from '../../helpers/formula-pyramid.ts';
import { startFormulaServer } from '../../helpers/formula-server.ts';
import type { FormulaServer, ServerFaults } from '../../helpers/formula-server.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

interface Served {
  readonly server: FormulaServer;
  readonly store: BrickStore;
  readonly formula: Formula;
}

async function withBricks(
  pyramid: FormulaPyramid,
  faults: ServerFaults,
  run: (served: Served) => Promise<void>,
): Promise<void> {
  const formula = formulaOf(pyramid);
  const server = await startFormulaServer(formulaFiles(formula), faults);
  try {
    const { tree } = await openZarr(server.url, { pageOrigin: server.origin }, undefined);
    const store = (await openBricksOf(tree!))!;
    await run({ server, store, formula });
    store.close();
  } finally {
    await server.close();
  }
}

/** Bricks of all levels, at places that a fixed rule chooses. */
function someBricks({ levels }: BrickStore, perLevel: number): Brick[] {
  return levels.flatMap(({ bricks }, level) =>
    Array.from({ length: perLevel }, (_, i): Brick => {
      const [x, y, z] = bricks.map(
        (count, axis) => (count * ((i + 1) * [0.618, 0.755, 0.57][axis] + 0.31 * level)) % count,
      );
      return { level, at: [Math.floor(x), Math.floor(y), Math.floor(z)] };
    }),
  );
}

/** Waits until something is so, 10 seconds at most. */
async function until(isSo: () => boolean): Promise<void> {
  for (let n = 0; n < 1000 && !isSo(); n++) await new Promise((resolve) => setTimeout(resolve, 10));
  expect(isSo()).to.equal(true);
}

const large: FormulaPyramid = { dimensions: [2048, 2048, 2048], levels: 7 };

describe('bricks from a server', () => {
  it('of 2048^3 voxels have the values of the formula, with at most 8 requests at once', () =>
    withBricks(large, { delayMs: 2 }, async ({ server, store, formula }) => {
      expect(store.levels.map(({ dimensions }) => dimensions[0])).to.deep.equal([2048, 1024, 512, 256, 128, 64, 32]);
      await Promise.all(someBricks(store, 1).map((brick) => expectFormula(store, formula, brick)));
      expect(server.counts.most).to.be.within(2, 8);
    }));

  it('of 16,384 x 16,384 x 8,192 voxels, of 16 bits, in shards, have the values of the formula', () =>
    withBricks(
      { dimensions: [16_384, 16_384, 8192], levels: 10, type: 'uint16', perShard: 8 },
      {},
      async ({ store, formula, server }) => {
        for (const brick of someBricks(store, 1)) await expectFormula(store, formula, brick);
        // No more than the chunks of a brick and their neighbours: a shard of the finest level has 33 MB.
        expect(server.counts.sent).to.be.below(10 * 27 * 2 ** 16 * 2);
        expect(server.counts.most).to.be.at.most(8);
      },
    ));

  it('come in spite of failures: of each ten requests for chunks one fails', () =>
    withBricks({ dimensions: [128, 128, 64], levels: 3 }, { failing: 0.1 }, async ({ server, store, formula }) => {
      const bricks = someBricks(store, 8);
      await Promise.all(bricks.map((brick) => expectFormula(store, formula, brick)));
      expect(server.counts.failed).to.be.at.least(3);
      expect(server.counts.most).to.be.at.most(8);
    }));

  it('that fail five times are an error in words, and can be asked for again', () =>
    withBricks({ dimensions: [64, 64, 64], levels: 2 }, {}, async ({ server, store, formula }) => {
      const brick: Brick = { level: 1, at: [0, 0, 0] };
      server.faults = { failing: 1 };
      const error = await failureOf(store.read(brick, noSignal()));
      expect(error).to.include({ code: 'source/unavailable' });
      expect(server.asked.filter((path) => path === '1/c/0/0/0').length).to.equal(5);
      server.faults = {};
      await expectFormula(store, formula, brick);
    }));

  it('that are given up end in the network, and no request is alive once the bricks are closed', () =>
    withBricks(large, {}, async ({ server, store }) => {
      server.faults = { delayMs: 3000 };
      const chunks = (): number => server.asked.filter((path) => path.includes('/c/')).length;
      const moved = new AbortController();
      const given = someBricks(store, 3).map((brick) => failureOf(store.read(brick, moved.signal)));
      await until(() => chunks() === 8);
      moved.abort(new Error('moved on'));
      for (const error of await Promise.all(given)) expect(error).to.include({ message: 'moved on' });
      await until(() => server.counts.running === 0);
      expect(server.counts.cancelled).to.equal(8);
      const others = someBricks(store, 1).map((brick) => failureOf(store.read(brick, noSignal())));
      await until(() => chunks() === 16);
      store.close();
      for (const error of await Promise.all(others)) expect(error).to.include({ name: 'AbortError' });
      await until(() => server.counts.running === 0);
      expect(server.counts.cancelled).to.equal(16);
      expect(chunks()).to.equal(16);
    }));
});
