// What volume-view-prepare writes next to a pyramid, read again with its bricks; and what a stranger may have written in its place.
import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { buildPyramid } from '../../../src/bricks/pyramid.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import type { ResidualTable } from '../../../src/bricks/residuals.ts';
import { makeOmeZarr } from '../../../src/prepare/write-ome-zarr.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { failureOf, noSignal, openBricksOf } from '../../helpers/brick-stores.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { writeArray } from '../../helpers/zarr-bytes.ts';
import { memoryTree } from '../../helpers/zarr-tree.ts';

type Files = Map<string, Uint8Array<ArrayBuffer>>;

const dimensions: Vector3 = [70, 41, 33];

const storeOf = (volume: Volume): Files =>
  new Map(
    [...makeOmeZarr(volume, (bytes) => gzipSync(bytes, { level: 1, mtime: 0 })).files].map(([path, content]) => [
      path,
      new Uint8Array(typeof content === 'string' ? new TextEncoder().encode(content) : content),
    ]),
  );

async function residualsOf(files: Files): Promise<ResidualTable | null> {
  const store = (await openBricksOf(memoryTree(files)))!;
  return store.residuals(noSignal());
}

const whole = syntheticVolume({ dimensions, kind: 'uint16', slope: 65535 });

/** Blocks along z, y and x. */
const blocks = [2, 2, 3];

/** In place of an array of numbers: the same one everywhere. */
function replace(files: Files, name: string, value: number, shape = blocks): Files {
  const changed = new Map([...files].filter(([path]) => !path.startsWith(`volume-view/${name}/`)));
  writeArray(changed, `volume-view/${name}`, {
    version: 3,
    type: 'float32',
    shape,
    chunk: shape,
    valueAt: () => value,
  });
  return changed;
}

describe('what a pyramid says of the detail in its levels', () => {
  const kinds: Record<string, Volume> = {
    'whole numbers': whole,
    'numbers below 0': syntheticVolume({ dimensions, kind: 'uint8', slope: 255, intercept: -1000 }),
    'floats, with voxels that have no data': syntheticVolume({
      dimensions,
      kind: 'float32',
      field: (x, y, z) => (x < 0.6 ? NaN : x + y * z),
    }),
  };
  for (const [name, volume] of Object.entries(kinds))
    it(`is what was measured, in stored values of the bricks: ${name}`, async () => {
      const store = (await openBricksOf(memoryTree(storeOf(volume))))!;
      const read = (await store.residuals(noSignal()))!;
      const { samples } = volume;
      const expected = measureResiduals(buildPyramid({ dimensions, samples }, 32), 16);
      expect([read.side, read.blocks]).to.deep.equal([16, expected.blocks]);
      expect(read.levels.length).to.equal(expected.levels.length);
      expect(read.levels.length).to.equal(store.levels.length);
      const toStored = (value: number): number => (value + volume.intercept - store.intercept) / store.slope;
      const near = (got: number, value: number): boolean =>
        got === value || Math.abs(got - value) <= 1e-3 + 1e-6 * Math.abs(value);
      expect(read.along).to.deep.equal(expected.along);
      for (let n = 0; n < expected.low.length; n++) {
        expect(near(read.low[n], toStored(expected.low[n])), `low ${n}`).to.equal(true);
        expect(near(read.high[n], toStored(expected.high[n])), `high ${n}`).to.equal(true);
        for (const [level, { max, rms }] of expected.levels.entries()) {
          // They are written with few digits; the largest one is never written too small.
          const [ofMax, ofRms] = [read.levels[level].max[n], read.levels[level].rms[n]];
          expect(ofMax, `max ${level} ${n}`).to.be.within(max[n] * (1 - 1e-6), max[n] * (17 / 16) + 1e-6);
          expect(ofRms, `rms ${level} ${n}`).to.be.within(rms[n] * (31 / 32) - 1e-6, rms[n] * (33 / 32) + 1e-6);
        }
      }
    });

  it('is nothing where nobody wrote it, or in a later version', async () => {
    const files = storeOf(whole);
    const bare = new Map([...files].filter(([path]) => !path.startsWith('volume-view/')));
    expect(await residualsOf(bare)).to.equal(null);
    expect(await residualsOf(withGroup(files, { version: 2, block: 'other' }))).to.equal(null);
  });

  it('may lack how far residuals go together, as before this was measured', async () => {
    const read = await residualsOf(withGroup(storeOf(whole), { along: undefined }));
    expect(read!.along).to.equal(undefined);
    expect(read!.levels.length).to.equal(3);
  });

  const lies: Record<string, [(files: Files) => Files, string]> = {
    'an array of another shape': [(files) => replace(files, 'residual-max-1', 1, [2, 2, 4]), 'format/corrupt'],
    'an array of an endless shape': [(files) => replace(files, 'min', 1, [1e6, 1, 1]), 'format/corrupt'],
    'a residual that is none': [(files) => replace(files, 'residual-max-1', NaN), 'format/corrupt'],
    'a residual below 0': [(files) => replace(files, 'residual-rms-1', -1), 'format/corrupt'],
    'an endless residual': [(files) => replace(files, 'residual-max-1', Infinity), 'format/corrupt'],
    'a mean above the largest': [(files) => replace(files, 'residual-rms-1', 1e9), 'format/corrupt'],
    'a smallest value above the largest': [(files) => replace(files, 'min', 1e9), 'format/corrupt'],
    'a largest value without a smallest one': [(files) => replace(files, 'min', NaN), 'format/corrupt'],
    'a missing array': [
      (files) => new Map([...files].filter(([path]) => !path.includes('residual-rms-1/'))),
      'format/corrupt',
    ],
    'another number of levels': [(files) => withGroup(files, { levels: 7 }), 'format/corrupt'],
    'blocks that are none': [(files) => withGroup(files, { block: [0, 0, 0] }), 'format/corrupt'],
    'blocks of a voxel': [(files) => withGroup(files, { block: [1, 1, 1] }), 'format/corrupt'],
    'blocks of other shapes': [(files) => withGroup(files, { block: [32, 32, 64] }), 'format/corrupt'],
    'no blocks': [(files) => withGroup(files, { block: null }), 'format/corrupt'],
    'too few numbers of how far residuals go together': [(files) => withGroup(files, { along: [0] }), 'format/corrupt'],
    'a number of these above 1': [(files) => withGroup(files, { along: [0, 0.5, 1.5] }), 'format/corrupt'],
    'none of these that is a number': [(files) => withGroup(files, { along: ['a', 'b', 'c'] }), 'format/corrupt'],
    'what is no JSON': [
      (files) => new Map(files).set('volume-view/zarr.json', new TextEncoder().encode('{')),
      'format/corrupt',
    ],
    'a chunk that is cut': [
      (files) => {
        const shard = files.get('volume-view/max/c/0/0/0')!;
        return new Map(files).set('volume-view/max/c/0/0/0', shard.slice(20));
      },
      'format/corrupt',
    ],
  };
  for (const [name, [lie, code]] of Object.entries(lies))
    it(`is refused in words, and the bricks are read all the same: ${name}`, async () => {
      const store = (await openBricksOf(memoryTree(lie(storeOf(whole)))))!;
      const error = await failureOf(store.residuals(noSignal()));
      expect(error).to.include({ code });
      expect((error as Error).message).to.match(/detail|metadata|shard|chunk/);
      const { low, high } = await store.read({ level: 0, at: [0, 0, 0] }, noSignal());
      expect(high).to.be.above(low);
    });

  it('is left out where it takes too much memory, before any of it is read', async () => {
    // 2^24 blocks of 4 voxels.
    const files: Files = new Map();
    const side = 1024;
    const levels = [side, side / 2];
    for (const [level, n] of levels.entries())
      writeArray(files, String(level), {
        version: 3,
        type: 'uint8',
        shape: [n, n, n],
        chunk: [n, n, n],
        metadata: chunksOf32,
        isMissing: () => true,
        valueAt: () => 0,
      });
    const image = { ...imageOf(levels) };
    files.set('zarr.json', new TextEncoder().encode(JSON.stringify(image)));
    const tree = memoryTree(withGroup(files, { version: 1, block: [4, 4, 4], levels: 2 }));
    const store = (await openBricksOf(tree))!;
    expect(await store.residuals(noSignal())).to.equal(null);
    expect(tree.asked.filter((path) => path.startsWith('volume-view/'))).to.deep.equal(['volume-view/zarr.json']);
  });
});

const chunksOf32 = { chunk_grid: { name: 'regular', configuration: { chunk_shape: [32, 32, 32] } } };

const imageOf = (levels: readonly number[]): object => ({
  zarr_format: 3,
  node_type: 'group',
  attributes: {
    ome: {
      version: '0.5',
      multiscales: [
        {
          axes: ['z', 'y', 'x'].map((name) => ({ name, type: 'space' })),
          datasets: levels.map((_, level) => ({
            path: String(level),
            coordinateTransformations: [{ type: 'scale', scale: [2 ** level, 2 ** level, 2 ** level] }],
          })),
        },
      ],
    },
  },
});

/** The group with other attributes. */
function withGroup(files: Files, attributes: object): Files {
  const group = JSON.parse(
    new TextDecoder().decode(files.get('volume-view/zarr.json') ?? new TextEncoder().encode('{"attributes":{}}')),
  ) as { attributes: Record<string, object> };
  group.attributes['volume-view'] = { ...group.attributes['volume-view'], ...attributes };
  return new Map(files).set('volume-view/zarr.json', new TextEncoder().encode(JSON.stringify(group)));
}
