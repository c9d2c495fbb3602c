import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { fetchFixture } from '../../helpers/decode.ts';
import { readExpected } from '../../helpers/expected-file.ts';
import type { ExpectedFile } from '../../helpers/expected-file.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { encodePng } from '../../../src/prepare/radar-mosaic.ts';
import { writeMosaic } from '../../../src/prepare/write-mosaic.ts';
import { base, readPrepared, roundTrip, sourcesOf } from '../../helpers/prepared.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

// Every file that the tests have of a format goes through the command, and is read again as a page reads it: the same values at the same
// places, within the error that was stated.

/** Files that are read as part of another one, and archives, which test/package/prepare-folder.mjs has. */
const isPart = /\.(txt|raw|zraw|img|BRIK|bin|dat|npz)(\.gz)?$/i;

/** One file of the fixtures, with all others beside it. */
function fixtureStore(path: string): ByteStore {
  const read = async (url: string): Promise<Uint8Array<ArrayBuffer>> => {
    try {
      return await fetchFixture(new URL(url).pathname.slice(1));
    } catch (cause) {
      throw new VolumeViewError('source/not-found', 'no such fixture', { cause });
    }
  };
  return {
    list: async () => [`${base}${path}`],
    stat: async (url) => ({ size: (await read(url)).length }),
    read: async (url, { range } = {}) => ({
      bytes: (await read(url)).slice(range?.start, range?.end),
      url,
      contentType: '',
    }),
  };
}

async function tryFile(path: string): Promise<number> {
  const store = fixtureStore(path);
  const [source] = await sourcesOf(store);
  return roundTrip(store, source);
}

describe('a file becomes a mosaic, and its values stay', () => {
  for (const list of [
    'nibabel-fixtures.json',
    'format-fixtures.json',
    'itk-fixtures.json',
    'radar-fixtures.json',
    'nexrad-fixtures.json',
  ]) {
    it(list, async function () {
      this.timeout(120_000);
      const paths = [...new Set((await readExpected<ExpectedFile>(list)).map(({ path }) => path))];
      let count = 0;
      for (const path of paths.filter((one) => !isPart.test(one))) {
        try {
          count += await tryFile(path);
        } catch (error) {
          throw new Error(`${path}: ${String(error)}`, { cause: error });
        }
      }
      expect(count).to.be.at.least(paths.length / 3);
    });
  }
});

it('labels that were made smaller say how many voxels have another label, and no difference of values', async () => {
  const isRight = (x: number, y: number, z: number): number => (x + y / 8 + z / 16 > 0.6 ? 7 / 255 : 2 / 255);
  const made = syntheticVolume({ dimensions: [32, 32, 16], field: isRight });
  const labels = { ...made, slope: 1, intercept: 0, isDiscrete: true, named: [{ id: 7, name: 'Right', color: null }] };
  const { image, manifest, error, dimensions } = writeMosaic(labels, 64);
  expect(manifest.prepared).to.deep.equal({ from: [32, 32, 16], changedLabels: error.changedLabels });
  expect(error.changedLabels).to.be.within(0.001, 0.1);
  const read = await readPrepared({ png: encodePng(image), manifest });
  expect(new Set(read.samples).size).to.equal(2);
  // The share is that of the original's voxels whose place has another label in what was read.
  const scale = dimensions.map((n, axis) => n / labels.grid.dimensions[axis]);
  let changed = 0;
  made.samples.forEach((sample, at) => {
    const place = [at % 32, Math.floor(at / 32) % 32, Math.floor(at / 1024)].map((i, axis) =>
      Math.floor((i + 0.5) * scale[axis]),
    );
    const stored = read.samples[place[0] + dimensions[0] * (place[1] + dimensions[1] * place[2])];
    changed += Number((read.ids ? read.ids[stored] : read.slope * stored + read.intercept) !== sample);
  });
  expect(changed / made.samples.length).to.be.closeTo(error.changedLabels!, 1e-12);
  expect(read.left!.join()).to.match(/[\d.]+ % of the voxels have another label/);
});
