// Stores that zarr-python wrote: every type, order of bytes, packing and layout of shards. `make-zarr-fixtures.py` has read each of them
// back, and compared it with the formula that is here.
import { expect } from '@esm-bundle/chai';
import { fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { roomyLimits } from '../../../helpers/decode.ts';
import { readStore } from '../../../helpers/zarr-tree.ts';
import type { ZarrFiles } from '../../../helpers/zarr-bytes.ts';

interface Case {
  readonly shape: readonly number[];
  readonly dtype: string;
  readonly files: Readonly<Record<string, string>>;
  /** Of a store with one chunk: its sum, its voxels without a value, and its first value, by zarr-python and NumPy. */
  readonly fill?: true;
  readonly sum?: number;
  readonly missing?: number;
  readonly first?: number | null;
}

const { cases } = JSON.parse(new TextDecoder().decode(await fetchFixture('zarr-fixtures.json'))) as {
  readonly cases: Readonly<Record<string, Case>>;
};

const filesOf = ({ files }: Case): ZarrFiles =>
  new Map(Object.entries(files).map(([path, text]) => [path, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));

/** The values of `make-zarr-fixtures.py`. */
function expected({ shape, dtype }: Case): number[] {
  const [kind, bytes] = [dtype[1], Number(dtype.slice(2))];
  return Array.from({ length: shape.reduce((product, n) => product * n, 1) }, (_, i) => {
    let value = (i * i * 7 + i * 3) % 251;
    if (kind === 'i') value -= 123;
    if (bytes >= 2 && 'iu'.includes(kind)) value *= 130;
    if (bytes >= 4 && 'iu'.includes(kind)) value *= 60;
    return kind === 'f' ? value / 8 - 5 : kind === 'b' ? value % 2 : value;
  });
}

describe('a store of zarr-python', () => {
  it('is there in many kinds', () => expect(Object.keys(cases).length).to.be.above(70));

  for (const [name, one] of Object.entries(cases)) {
    it(`${name} has the values that were written`, async () => {
      const volume = await finishVolume(await readStore(filesOf(one)), roomyLimits);
      const [nz, ny, nx] = one.shape;
      expect(volume.grid.kind === 'cartesian' && volume.grid.dimensions).to.deep.equal([nx, ny, nz]);
      const values = valuesOf(volume);
      if (!one.fill) {
        expect(values).to.deep.equal(expected(one));
        return;
      }
      const known = values.filter((value) => !Number.isNaN(value));
      expect(values.length - known.length).to.equal(one.missing);
      expect(known.reduce((sum, value) => sum + value, 0)).to.be.closeTo(one.sum!, 1e-6);
      expect(Number.isNaN(values[0]) ? null : values[0]).to.equal(one.first);
    });
  }
});
