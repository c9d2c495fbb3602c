import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { fetchFixture } from '../../helpers/decode.ts';
import { readExpected } from '../../helpers/expected-file.ts';
import type { ExpectedFile } from '../../helpers/expected-file.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { base, roundTrip, sourcesOf } from '../../helpers/prepared.ts';

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
