// Bricks of OME-Zarr pyramids against formulas, against zarr-python, and against what the ordinary reader reads.
import { expect } from '@esm-bundle/chai';
import { ByteCache } from '../../../../src/formats/zarr/byte-cache.ts';
import { Queue } from '../../../../src/formats/base/queue.ts';
import {
  allBricks,
  expectFormula,
  failureOf,
  formulaTree,
  noSignal,
  openBricksOf,
} from '../../../helpers/brick-stores.ts';
import { fetchFixture, roomyLimits } from '../../../helpers/decode.ts';
import { formulaFiles, formulaOf } from '../../../helpers/formula-pyramid.ts';
import type { FormulaPyramid } from '../../../helpers/formula-pyramid.ts';
import { pyramidFiles } from '../../../helpers/zarr-bytes.ts';
import type { PyramidCase, ZarrFiles } from '../../../helpers/zarr-bytes.ts';
import { memoryTree, readStore } from '../../../helpers/zarr-tree.ts';

const small: FormulaPyramid = { dimensions: [80, 72, 48], levels: 4 };

describe('bricks of a pyramid', () => {
  const kinds: Record<string, Partial<FormulaPyramid>> = {
    'of 8 bits': {},
    'of 16 bits': { type: 'uint16' },
    'in chunks that bricks do not divide': { chunk: 20 },
    'in larger chunks': { chunk: 64 },
    'in shards': { perShard: 2 },
    'in shards, of which chunks are missing': {
      perShard: 3,
      chunk: 16,
      isMissing: (level, [i, j, k]) => (i + 2 * j + 3 * k + level) % 4 === 0,
    },
    'of which chunks are missing': { isMissing: (level, [i, j, k]) => (i + j + k + level) % 3 === 0 },
  };
  for (const [name, kind] of Object.entries(kinds))
    it(`${name} have the values of the formula, with their halo, repeated at the ends`, async () => {
      const formula = formulaOf({ ...small, ...kind });
      const store = (await openBricksOf(formulaTree(formulaFiles(formula))))!;
      expect(store.levels.map(({ dimensions }) => dimensions)).to.deep.equal([
        [80, 72, 48],
        [40, 36, 24],
        [20, 18, 12],
        [10, 9, 6],
      ]);
      expect(store.levels.map(({ factors }) => factors[0])).to.deep.equal([1, 2, 4, 8]);
      const bricks = allBricks(store);
      expect(bricks.length).to.equal(3 * 3 * 2 + 2 * 2 * 1 + 1 + 1);
      await Promise.all(bricks.map((brick) => expectFormula(store, formula, brick)));
      await Promise.all(bricks.map((brick) => expectFormula(store, formula, brick, true)));
    });

  it('of the formula are means: level 1 is that of eight voxels of level 0, except its rounding', () => {
    const formula = formulaOf({ ...small, type: 'uint16' });
    const [fine, coarse] = [formula.boxOf(0, [32, 20, 24], [16, 16, 16]), formula.boxOf(1, [16, 10, 12], [8, 8, 8])];
    for (let k = 0; k < 8; k++)
      for (let j = 0; j < 8; j++)
        for (let i = 0; i < 8; i++) {
          let sum = 0;
          for (let n = 0; n < 8; n++)
            sum += fine[2 * i + (n & 1) + 16 * (2 * j + ((n >> 1) & 1) + 16 * (2 * k + (n >> 2)))];
          expect(coarse[i + 8 * (j + 8 * k)]).to.be.closeTo(sum / 8, 1);
        }
  });

  const shapes: Record<string, PyramidCase> = {
    'xyz, Zarr 2': { axes: 'xyz', shape: [37, 35, 34], levels: 2, chunk: [9, 16, 40] },
    'yxz, Zarr 3': { version: 3, axes: 'yxz', shape: [37, 5, 70], levels: 2, chunk: [9, 5, 33] },
    tczyx: { axes: 'tczyx', shape: [2, 3, 6, 40, 7], levels: 2 },
    'of 2D': { axes: 'yx', shape: [70, 33], levels: 2, type: 'float32' },
    'in shards': { version: 3, axes: 'czyx', shape: [2, 36, 8, 10], chunk: [1, 6, 4, 5], shard: [1, 18, 8, 10] },
    'with scales along the axes': {
      axes: 'zyx',
      shape: [5, 40, 20],
      scale: [3, 0.5, 0.25],
      translation: [10, -4, 2],
      levels: 3,
      type: 'float32',
    },
  };
  for (const [name, pyramid] of Object.entries(shapes))
    it(`are those of the ordinary reader: ${name}`, async () => {
      const files = pyramidFiles({
        valueAt: ({ x, y, z, t, c }) => 700 + 3 * x + 5 * y + 7 * z + 1000 * c + 4000 * t,
        ...pyramid,
      });
      const choice = { channel: pyramid.axes?.includes('c') ? '2' : null };
      const settings = { scan: { index: 1 } };
      const store = (await openBricksOf(memoryTree(files, false, choice), {}, settings))!;
      for (const [level, { dimensions, indexToWorld, bricks }] of store.levels.entries()) {
        const maxBytes = dimensions.reduce((product, n) => product * n, pyramid.type === 'float32' ? 4 : 2);
        const whole = await readStore(memoryTree(files, false, choice), settings, {
          limits: { ...roomyLimits, maxBytes },
        });
        expect(whole.grid.dimensions).to.deep.equal(dimensions);
        expect(whole.grid.indexToWorld).to.deep.equal(indexToWorld);
        expect(bricks).to.deep.equal(dimensions.map((n) => Math.ceil(n / 32)));
        for (const brick of allBricks(store).filter((one) => one.level === level)) {
          const { samples } = await store.read(brick, noSignal());
          let n = 0;
          for (let k = -2; k < 34; k++)
            for (let j = -2; j < 34; j++)
              for (let i = -2; i < 34; i++, n++) {
                const [x, y, z] = [i, j, k].map((one, axis) =>
                  Math.min(dimensions[axis] - 1, Math.max(0, Math.min(32, Math.max(-1, one)) + 32 * brick.at[axis])),
                );
                const expected =
                  whole.slope * whole.samples[x + dimensions[0] * (y + dimensions[1] * z)] + whole.intercept;
                const got = store.slope * samples[n] + store.intercept;
                if (Math.abs(got - expected) > 1e-3) expect([brick, i, j, k, got]).to.equal(expected);
              }
        }
      }
    });

  it('of levels that other programs put elsewhere keep their places: without half a voxel, with ratios of lengths, and along some axes only', async () => {
    const files = pyramidFiles({ shape: [9, 33, 65], levels: 1 });
    const levels = [
      { shape: [9, 33, 65], scale: [1, 1, 1], translation: [0, 0, 0] },
      // Every second voxel, and z as it was: OME's own reader for microscopes.
      { shape: [9, 16, 32], scale: [1, 2, 2], translation: [0, 0, 0] },
      // The ratio of the lengths.
      { shape: [9, 8, 16], scale: [1, 33 / 8, 65 / 16], translation: [0, (33 / 8 - 1) / 2, (65 / 16 - 1) / 2] },
      // A ratio that is no whole number of voxels.
      { shape: [9, 13, 26], scale: [1, 2.5, 2.5], translation: [0, 0.75, 0.75] },
    ];
    for (const [number, { shape }] of levels.entries())
      for (const [path, bytes] of pyramidFiles({ shape, levels: 1, type: 'uint16' }))
        if (path.startsWith('0/')) files.set(path.replace('0/', `${number}/`), bytes);
    const image = JSON.parse(new TextDecoder().decode(files.get('.zattrs')));
    image.multiscales[0].datasets = levels.map(({ scale, translation }, path) => ({
      path: String(path),
      coordinateTransformations: [
        { type: 'scale', scale },
        { type: 'translation', translation },
      ],
    }));
    files.set('.zattrs', new TextEncoder().encode(JSON.stringify(image)));
    const store = (await openBricksOf(memoryTree(files)))!;
    expect(store.levels.map(({ factors }) => factors)).to.deep.equal([
      [1, 1, 1],
      [2, 2, 1],
      [4, 4, 1],
    ]);
    // The place of any point of a brick is between voxels that the brick of the level has.
    for (const { factors, bricks, indexToWorld: m, dimensions } of store.levels)
      for (let axis = 0; axis < 3; axis++)
        for (let voxel = -0.5; voxel <= store.levels[0].dimensions[axis] - 0.5; voxel += 0.5) {
          const finest = store.levels[0].indexToWorld;
          const place = (voxel * finest[5 * axis] + finest[4 * axis + 3] - m[4 * axis + 3]) / m[5 * axis];
          const cell = Math.max(0, Math.floor(Math.min(voxel, store.levels[0].dimensions[axis] - 1) / 32));
          const brick = Math.min(bricks[axis] - 1, Math.floor(cell / factors[axis]));
          const inside = Math.min(dimensions[axis], Math.max(-1, place)) - 32 * brick;
          expect(inside).to.be.within(-1.001, 32.501);
        }
  });

  it('are none of several channels, of labels, and where the page says the voxels', async () => {
    const tree = (pyramid: Partial<PyramidCase>): ReturnType<typeof memoryTree> =>
      memoryTree(pyramidFiles({ shape: [4, 40, 40], levels: 2, ...pyramid }));
    expect(await openBricksOf(tree({ axes: 'czyx', shape: [2, 4, 40, 40] }))).to.equal(null);
    expect(await openBricksOf(tree({ attributes: { 'image-label': { colors: [] } } }))).to.equal(null);
    expect(await openBricksOf(tree({}), {}, { spacing: [1, 1, 1] })).to.equal(null);
    expect(await openBricksOf(tree({}))).not.to.equal(null);
  });

  it('are none where each would need most of what is kept: chunks of whole slices', async () => {
    const slices = pyramidFiles({ shape: [70, 64, 64], levels: 1, chunk: [1, 64, 64], type: 'uint8' });
    const open = (keptBytes: number): Promise<unknown> => openBricksOf(memoryTree(slices), { keptBytes });
    expect(await open(4 * 34 * 4096 - 1)).to.equal(null);
    expect(await open(4 * 34 * 4096)).not.to.equal(null);
  });

  it('need each chunk once, as long as it is kept', async () => {
    const formula = formulaOf(small);
    const files = formulaTree(formulaFiles(formula));
    const asked: string[] = [];
    const tree: typeof files = {
      ...files,
      read: (...args) => {
        asked.push(args[0]);
        return files.read(...args);
      },
    };
    const store = (await openBricksOf(tree))!;
    for (const brick of allBricks(store)) await store.read(brick, noSignal());
    const chunks = asked.filter((path) => path.includes('/c/'));
    expect(chunks.length).to.equal(3 * 3 * 2 + 2 * 2 * 1 + 1 + 1);
    expect(new Set(chunks).size).to.equal(chunks.length);
  });

  it('need only the chunks in which they lie where they are read alone', async () => {
    const files = formulaTree(formulaFiles(formulaOf({ dimensions: [160, 160, 160], levels: 1 })));
    const countChunks = async (isAlone: boolean): Promise<number> => {
      let count = 0;
      const read: typeof files.read = (path, ...rest) => {
        if (path.includes('/c/')) count++;
        return files.read(path, ...rest);
      };
      const store = (await openBricksOf({ ...files, read }))!;
      await store.read({ level: 0, at: [2, 2, 2] }, noSignal(), isAlone);
      return count;
    };
    expect([await countChunks(true), await countChunks(false)]).to.deep.equal([1, 27]);
  });

  it('that lie are refused: a level of another shape, and a chunk that is cut', async () => {
    const lying = pyramidFiles({ shape: [16, 40, 40], levels: 2 });
    for (const [path, bytes] of pyramidFiles({ shape: [8, 30, 20], levels: 1 }))
      if (path.startsWith('0/')) lying.set(path.replace('0/', '1/'), bytes);
    expect(await failureOf(openBricksOf(memoryTree(lying)))).to.include({ code: 'format/corrupt' });
    const cut = pyramidFiles({ shape: [8, 40, 40], levels: 1, chunk: [8, 40, 40] });
    cut.set('0/0/0/0', cut.get('0/0/0/0')!.slice(0, -2));
    const store = (await openBricksOf(memoryTree(cut)))!;
    expect(await failureOf(store.read({ level: 0, at: [0, 0, 0] }, noSignal()))).to.include({ code: 'format/corrupt' });
  });

  it('that do not exist are refused', async () => {
    const store = (await openBricksOf(formulaTree(formulaFiles(formulaOf(small)))))!;
    for (const brick of [
      { level: 4, at: [0, 0, 0] },
      { level: 0, at: [3, 0, 0] },
      { level: 0, at: [0, -1, 0] },
      { level: 0, at: [0, 0, 0.5] },
    ] as const)
      expect(() => store.read(brick, noSignal())).to.throw(RangeError);
  });
});

interface Fixture {
  readonly shape: readonly number[];
  readonly dtype: string;
  readonly files: Readonly<Record<string, string>>;
  readonly fill?: true;
}

const { cases } = JSON.parse(new TextDecoder().decode(await fetchFixture('zarr-fixtures.json'))) as {
  readonly cases: Readonly<Record<string, Fixture>>;
};

const filesOf = ({ files }: Fixture): ZarrFiles =>
  new Map(Object.entries(files).map(([path, text]) => [path, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));

describe('bricks of stores of zarr-python', () => {
  // test/unit/formats/zarr/zarr-python.test.ts compares what the ordinary reader reads with the values that were written.
  for (const [name, one] of Object.entries(cases))
    it(`${name} have the values that were written`, async () => {
      const whole = await readStore(filesOf(one));
      const [nx, ny, nz] = whole.grid.dimensions;
      const { slope, intercept } = whole;
      const store = (await openBricksOf(memoryTree(filesOf(one)), { scaling: { slope, intercept } }))!;
      expect(store.levels[0].dimensions).to.deep.equal([nx, ny, nz]);
      let count = 0;
      for (const brick of allBricks(store)) {
        const { samples, hasNoData } = await store.read(brick, noSignal());
        expect(hasNoData).to.equal(samples.some(Number.isNaN));
        const [x, y, z] = brick.at.map((n) => 32 * n);
        for (let k = z; k < Math.min(nz, z + 32); k++)
          for (let j = y; j < Math.min(ny, y + 32); j++)
            for (let i = x; i < Math.min(nx, x + 32); i++, count++) {
              const expected = slope * whole.samples[i + nx * (j + ny * k)] + intercept;
              const got = store.slope * samples[i - x + 2 + 36 * (j - y + 2 + 36 * (k - z + 2))] + store.intercept;
              if (!Object.is(got, expected)) expect([i, j, k, got]).to.equal(expected);
            }
      }
      expect(count).to.equal(nx * ny * nz);
    });
});

describe('what is kept', () => {
  it('is what was used last, and never more than so many bytes', () => {
    const cache = new ByteCache<Uint8Array>(4000);
    for (const [key, bytes] of [
      ['a', 1000],
      ['b', 1000],
      ['c', 900],
    ] as const)
      cache.set(key, new Uint8Array(bytes));
    expect(cache.get('a')).to.have.length(1000);
    cache.set('d', new Uint8Array(500));
    expect(cache.get('b')).to.equal(undefined);
    cache.set('e', null);
    expect(cache.get('e')).to.equal(null);
    cache.set('f', new Uint8Array(4000));
    expect(cache.get('f')).to.equal(undefined);
    expect(cache.get('a')).to.have.length(1000);
    for (let n = 0; n < 100; n++) {
      cache.set(`many ${n}`, n % 2 ? null : new Uint8Array(37 * n));
      expect(cache.bytes).to.be.at.most(4000);
    }
  });
});

describe('bricks that are given up', () => {
  const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
  /** A tree that answers when it is told to, and hears when a request is given up. */
  const slowTree = (): { tree: Parameters<typeof openBricksOf>[0]; running: Set<string>; release: () => void } => {
    const files = formulaTree(formulaFiles(formulaOf(small)));
    const running = new Set<string>();
    let release = (): void => undefined;
    const held = new Promise<void>((resolve) => (release = resolve));
    return {
      running,
      release,
      tree: {
        ...files,
        async read(path, options) {
          if (path.includes('/c/')) {
            running.add(path);
            const { signal } = options!;
            try {
              await Promise.race([
                held,
                new Promise((_, reject) => signal!.addEventListener('abort', () => reject(signal!.reason as Error))),
              ]);
            } finally {
              running.delete(path);
            }
          }
          return files.read(path, options);
        },
      },
    };
  };

  it('end their requests, but not those that another brick waits for', async () => {
    const { tree, running, release } = slowTree();
    const store = (await openBricksOf(tree, { requests: new Queue(100) }))!;
    const [first, second] = [new AbortController(), new AbortController()];
    // They have chunks in common.
    const one = failureOf(store.read({ level: 0, at: [0, 0, 0] }, first.signal));
    const other = store.read({ level: 0, at: [2, 0, 0] }, second.signal);
    await wait(5);
    const all = running.size;
    expect(all).to.equal(8 + 8 - 4);
    first.abort(new Error('moved on'));
    expect(await one).to.include({ message: 'moved on' });
    expect(running.size).to.equal(8);
    release();
    await other;
    await expectFormula(store, formulaOf(small), { level: 0, at: [0, 0, 0] });
  });

  it('before their turn are never asked for, and leave their places to others', async () => {
    const { tree, running, release } = slowTree();
    const store = (await openBricksOf(tree, { requests: new Queue(2) }))!;
    const moved = new AbortController();
    const given = allBricks(store).map((brick) => failureOf(store.read(brick, moved.signal)));
    await wait(5);
    expect(running.size).to.equal(2);
    moved.abort(new Error('moved on'));
    for (const error of await Promise.all(given)) expect(error).to.include({ message: 'moved on' });
    expect(running.size).to.equal(0);
    release();
    await expectFormula(store, formulaOf(small), { level: 0, at: [2, 2, 1] });
  });

  it('with their store leave nothing behind, and nothing is read any more', async () => {
    const { tree, running } = slowTree();
    const store = (await openBricksOf(tree))!;
    const waiting = allBricks(store).map((brick) => failureOf(store.read(brick, noSignal())));
    await wait(5);
    expect(running.size).to.equal(8);
    store.close();
    for (const error of await Promise.all(waiting)) expect(error).to.include({ name: 'AbortError' });
    expect(running.size).to.equal(0);
    expect(await failureOf(store.read({ level: 0, at: [0, 0, 0] }, noSignal()))).to.include({ name: 'AbortError' });
    expect(await failureOf(store.residuals(noSignal()))).to.include({ name: 'AbortError' });
  });
});
