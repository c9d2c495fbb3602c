import { expect } from '@esm-bundle/chai';
import type { DataGroup } from '../../../../src/formats/base/data-tree.ts';
import { readAll } from '../../../../src/formats/base/data-tree.ts';
import { adviceOf } from '../../../../src/formats/hdf5/advice.ts';
import { openHdf5 } from '../../../../src/formats/hdf5/hdf5.ts';
import { readHdf5Radar } from '../../../../src/formats/radar/hdf5-radar.ts';
import { expectError, fetchFile, fetchFixture } from '../../../helpers/decode.ts';
import { errorOf } from '../../../helpers/error-of.ts';
import { contiguous, Hdf5Builder, types } from '../../../helpers/hdf5-builder.ts';
import { gateValues } from '../../../helpers/radar.ts';

type Table = readonly (readonly number[])[];

/** What h5py reads; made by test/fixtures/make-hdf5-fixtures.py. */
const expected = JSON.parse(new TextDecoder().decode(await fetchFile('/test/fixtures/hdf5-fixtures.json'))) as Record<
  string,
  Record<string, Table>
>;

const open = async (name: string): Promise<DataGroup> => openHdf5(await fetchFixture(`hdf5/${name}`));

/** The array that a path leads to, group by group. */
function read(root: DataGroup, path: string): number[] {
  const names = path.split('/');
  const group = names.slice(0, -1).reduce<DataGroup | null>((at, name) => at?.group(name) ?? null, root);
  return [...readAll(group!.array(names.at(-1)!)!)];
}

describe('HDF5 files as h5py reads them', () => {
  for (const [file, arrays] of Object.entries(expected).filter(([name]) => name.endsWith('.h5'))) {
    for (const [path, values] of Object.entries(arrays)) {
      it(`${file}: ${path}`, async () => expect(read(await open(file), path)).to.deep.equal(values.flat()));
    }
  }

  it('rows of an array that may grow, with edges that no filter touched', async () => {
    const array = (await open('newest.h5')).array('plain-edges-growing')!;
    const values = expected['newest.h5']['plain-edges-growing'];
    expect([...array.readRows(6, 3)]).to.deep.equal(values.slice(6).flat());
  });

  for (const file of ['links-new.h5', 'links-old.h5']) {
    it(`${file}: links that lead nowhere are nothing, circles and other files are refused`, async () => {
      const root = await open(file);
      expect(root.names).to.include.members(['dangling', 'circle', 'outside', 'absolute']);
      expect(root.array('dangling')).to.equal(null);
      expect(root.array('absolute')).to.equal(root.group('a')!.group('b')!.array('values'));
      expect(errorOf(() => root.array('circle')).message).to.contain('more than 16 soft links one after another');
      const outside = errorOf(() => root.array('outside'));
      expect(outside.code).to.equal('format/unsupported');
      expect(outside.message).to.contain('a link to another file at /outside').and.to.contain(adviceOf('one-file'));
    });
  }

  it('values in other files are refused in words', async () => {
    const array = (await open('external.h5')).array('data')!;
    const error = errorOf(() => readAll(array));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('the values of /data in other files').and.to.contain(adviceOf('one-file'));
  });

  it('what h5repack would leave out is not to be given to it', async () => {
    const array = (await open('newest.h5')).array('lzf')!;
    const error = errorOf(() => readAll(array));
    expect(error.message).to.contain('compressed with LZF').and.to.contain('h5py').and.to.not.contain('h5repack');
  });
});

describe('CfRadial 2 that xradar made of ODIM_H5, whose name it keeps', () => {
  it('is CfRadial 2', async () => {
    const bytes = await fetchFixture('hdf5/xradar-of-odim.nc');
    const radar = await readHdf5Radar(bytes);
    expect(radar.format).to.equal('CfRadial 2');
    expect(radar.site).to.deep.equal({ latitude: 50.5, longitude: -7.25, height: 321 });
    const [sweep] = radar.sweeps;
    expect(sweep.elevation).to.equal(1.5);
    expect([...sweep.azimuths.slice(0, 2)]).to.deep.equal([15, 45]);
    const data = sweep.read('DBZH')!;
    expect([data.firstGate, data.gateLength, data.gates]).to.deep.equal([250, 500, 10]);
    // As h5py reads them, times scale_factor plus add_offset.
    expect([...gateValues(data).slice(0, 4)]).to.deep.equal([-31.5, -31, -30.5, -30]);
  });
});

describe('a variable of NetCDF-4 that has the name of a dimension and is not along it', () => {
  it('has its own name, and its own numbers', () => {
    const builder = new Hdf5Builder();
    const numbers = (...values: readonly number[]): number => {
      const address = builder.place(new Uint8Array(Float64Array.from(values).buffer));
      return builder.array(types.float64, [values.length], [contiguous(address, 8 * values.length)]);
    };
    const [alone, own, other] = [numbers(0, 0), numbers(1, 2, 3), numbers(4)];
    const root = openHdf5(builder.build(builder.group({ range: alone, other, _nc4_non_coord_range: own })));
    expect(root.names).to.deep.equal(['range', 'other']);
    expect([...readAll(root.array('range')!)]).to.deep.equal([1, 2, 3]);
    expect([...readAll(root.array('other')!)]).to.deep.equal([4]);
  });
});

describe('radar scans in HDF5 of their own layout', () => {
  it('those of GAMIC are refused with what to do', async () => {
    const builder = new Hdf5Builder();
    const [what, scan0] = [builder.group({}), builder.group({})];
    const { code, message } = await expectError(readHdf5Radar(builder.build(builder.group({ what, scan0 }))));
    expect(code).to.equal('format/unsupported');
    expect(message).to.contain('GAMIC').and.to.contain('xradar');
  });
});
