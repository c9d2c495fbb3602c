import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import type { AttributeValue, DataArray, DataGroup } from '../../../../src/formats/base/data-tree.ts';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { readHdf5Radar } from '../../../../src/formats/radar/hdf5-radar.ts';
import { readOdim, readOdimTree } from '../../../../src/formats/radar/odim.ts';
import { readOdimSweep } from '../../../../src/formats/radar/odim-sweep.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { expectError, fetchFixture } from '../../../helpers/decode.ts';
import { compareRadar, gateValues, readExpected } from '../../../helpers/radar.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';

const isOdim = ({ path }: { path: string }): boolean => path.includes('odim');
const fixtures = (await readExpected('radar-fixtures.json')).filter(isOdim);
const shared = (await readExpected('radar-shared.json')).filter(isOdim);

const load = async (name: string): Promise<RadarFile> => readOdim(await fetchFixture(`radar/${name}`));

describe('ODIM_H5 against h5py', () => {
  for (const expected of fixtures) {
    it(expected.path, async () => compareRadar(await readOdim(await fetchFixture(expected.path)), expected));
  }

  it('all versions are there', () => {
    expect(fixtures.map(({ path }) => /2\.\d/.exec(path)?.[0])).to.deep.equal(['2.0', '2.1', '2.2', '2.3', '2.4']);
  });
});

describe('ODIM_H5 files of the shared data against Py-ART', () => {
  for (const expected of shared) {
    it(expected.path, async function () {
      const bytes = new Uint8Array(await fetchSharedData(this, expected.path));
      compareRadar(await readHdf5Radar(bytes), expected);
    });
  }
});

describe('sweeps, radials and gates of a scan, as xradar 0.12.0 has them', () => {
  // open_odim_datatree: sweep_fixed_angle, sizes of azimuth and range, the first range and the distance to the next.
  const scans = {
    'radar/odim_belgium_20190606/behel.pvol.hdf': {
      elevations: [0.3, 0.5, 0.8, 1.8, 3, 5, 7.5, 10, 13, 16, 20, 25],
      radials: 360,
      gates: 800,
      firstGate: 125,
      gateLength: 250,
    },
    'radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5': {
      elevations: [0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.2, 5.6, 7.4, 10, 13.3, 17.9, 23.9, 32],
      radials: 360,
      gates: 598,
      firstGate: 1250,
      gateLength: 500,
    },
  };
  for (const [path, { elevations, ...same }] of Object.entries(scans)) {
    it(path, async function () {
      const { radar } = buildPolarVolume(await readHdf5Radar(new Uint8Array(await fetchSharedData(this, path))), {});
      expect(radar!.sweeps.map(({ elevation }) => Number(elevation.toFixed(4)))).to.deep.equal(elevations);
      for (const { elevation, ...sweep } of radar!.sweeps) expect(sweep, `${elevation}`).to.deep.equal(same);
      expect(radar!.left).to.deep.equal([]);
    });
  }
});

describe('ODIM_H5 as stored', () => {
  it('names version, site and moments with unit and kind', async () => {
    const radar = await load('odim-2.1.h5');
    expect(radar.format).to.equal('ODIM_H5 2.1');
    expect(radar.site.name).to.equal('xxtes');
    expect((await load('odim-2.0.h5')).site.name).to.equal('Testfeld');
    expect(radar.moments).to.deep.equal([
      { name: 'DBZH', unit: 'dBZ', kind: 'reflectivity' },
      { name: 'VRADH', unit: 'm/s', kind: 'velocity' },
    ]);
    const kinds = (await load('odim-2.4-scan.h5')).moments.map(({ name, unit, kind }) => `${name} ${unit} ${kind}`);
    expect(kinds).to.deep.equal([
      'ZDR dB differential-reflectivity',
      'RHOHV  correlation',
      'DBZH dBZ reflectivity',
      'VRADH m/s velocity',
    ]);
  });

  it('keeps 8 and 16 bits, with 0 for no data', async () => {
    expect((await load('odim-2.0.h5')).sweeps[0].read('DBZH')?.samples).to.be.instanceOf(Uint8Array);
    const [first, second] = (await load('odim-2.2.h5')).sweeps;
    expect(first.read('DBZH')?.samples).to.be.instanceOf(Uint16Array);
    expect(first.read('VRADH')).to.equal(null);
    expect(second.read('VRADH')?.samples).to.be.instanceOf(Uint16Array);
  });

  it('widens integers where neither end of their range is free for no data', async () => {
    const [sweep] = (await load('odim-2.4-scan.h5')).sweeps;
    // -128 is valid here and 127 is not: the lowest becomes 1, and fits.
    const signed = sweep.read('ZDR')!;
    expect(signed.samples).to.be.instanceOf(Uint8Array);
    expect(gateValues(signed).reduce((min, value) => (value < min ? value : min), Infinity)).to.be.closeTo(-12.8, 1e-9);
    expect(sweep.read('DBZH')?.samples).to.be.instanceOf(Uint16Array);
    expect(sweep.read('RHOHV')?.samples).to.be.instanceOf(Float32Array);
    expect(sweep.read('no such moment')).to.equal(null);
  });

  it('has the same slope and intercept in all sweeps of a moment', async () => {
    const scales = (await load('odim-2.0.h5')).sweeps
      .map((sweep) => sweep.read('DBZH')!)
      .map(({ slope, intercept }) => [slope, intercept]);
    expect(scales).to.deep.equal([
      [0.5, -32],
      [0.5, -32],
      [0.5, -32],
    ]);
  });
});

describe('elevations of the radials of an ODIM_H5 file', () => {
  const angles = { plain: [0.5, 0.5, 0.5, 0.5], up: [0.4, 0.6, 0.8, 1], down: [1, 0.8, 0.6, -0.4] };

  it('are those that it states, as Py-ART takes them, or half way between where radials start and stop', () => {
    expect(elevationsOf({})).to.equal(undefined);
    expect(elevationsOf({ elangles: angles.up })).to.deep.equal(angles.up);
    expect(elevationsOf({ startelA: angles.up, stopelA: angles.down })).to.deep.equal([0.7, 0.7, 0.7, 0.3]);
    expect(elevationsOf({ startelA: angles.up, stopelA: angles.down, elangles: angles.plain })).to.deep.equal(
      angles.plain,
    );
    expect(elevationsOf({ elangles: [359.9, 0, 0.1, 0.2] })).to.deep.equal([-0.1, 0, 0.1, 0.2]);
  });

  it('that are too few, or half of which is absent, do not count', () => {
    expect(elevationsOf({ elangles: [1, 2] })).to.equal(undefined);
    expect(elevationsOf({ startelA: angles.up })).to.equal(undefined);
    expect(elevationsOf({ elangles: [1, 2, 3, NaN] })).to.equal(undefined);
  });
});

const group = (
  attributes: Readonly<Record<string, AttributeValue>>,
  groups: Readonly<Record<string, DataGroup>> = {},
  array: DataArray | null = null,
): DataGroup => ({
  path: '/dataset1',
  attributes: new Map(Object.entries(attributes)),
  names: Object.keys(groups),
  group: (name) => groups[name] ?? null,
  array: () => array,
});
const gates: DataArray = {
  path: '/gates',
  shape: [4, 3],
  type: 'uint8',
  attributes: new Map(),
  readRows: () => new Uint8Array(12),
  readTexts: () => [],
};
const numbers = (of: Readonly<Record<string, number>>): Record<string, Float64Array<ArrayBuffer>> =>
  Object.fromEntries(Object.entries(of).map(([name, number]) => [name, Float64Array.of(number)]));

describe('units that a version of ODIM_H5 changed', () => {
  const sweepOf = (version: string, where: Readonly<Record<string, number>>, { how = {}, quantity = 'DBZH' } = {}) =>
    readOdimSweep(
      group({}),
      group(
        {},
        {
          where: group(numbers({ elangle: 0.5, ...where })),
          how: group(numbers(how)),
          data1: group({}, { what: group({ quantity }) }, gates),
        },
      ),
      version,
    )!;

  it('rstart is kilometres up to 2.3 and metres from 2.4 on, as xradar 0.12 reads it', () => {
    // open_odim_datatree on ../shared/data/reports/12-odim-variants, range[0]: rstart-km-22, rstart-m-24, rstart-m-24-small.
    for (const [version, rstart, firstGate] of [
      ['2.2', 2, 2250],
      ['2.4', 2000, 2250],
      ['2.4', 250, 500],
    ] as const) {
      const sweep = sweepOf(version, { rstart, rscale: 500 });
      expect(sweep.gridOf('DBZH')!.firstGate, `${version} ${rstart}`).to.equal(firstGate);
      expect(sweep.left).to.deep.equal([]);
    }
    for (const version of ['2.0', '2.1', '2.3'])
      expect(sweepOf(version, { rstart: 1, rscale: 250 }).gridOf('DBZH')!.firstGate).to.equal(1125);
  });

  it('a value that makes sense in the other unit alone is taken so, and said to be', () => {
    const metres = sweepOf('2.2', { rstart: 250, rscale: 500 });
    expect(metres.gridOf('DBZH')!.firstGate).to.equal(500);
    expect(metres.left).to.deep.equal(['rstart 250 is taken as metres, though ODIM_H5 2.2 has it in kilometres']);
    const kilometres = sweepOf('2.4', { rstart: 1, rscale: 500 });
    expect(kilometres.gridOf('DBZH')!.firstGate).to.equal(1250);
    expect(kilometres.left).to.deep.equal(['rstart 1 is taken as kilometres, though ODIM_H5 2.4 has it in metres']);
    // What is no part of a gate in kilometres is a correction in metres.
    expect(sweepOf('2.4', { rstart: 3.7, rscale: 500 }).gridOf('DBZH')!.firstGate).to.equal(253.7);
    expect(() => sweepOf('2.4', { rstart: 2e6, rscale: 500 }).gridOf('DBZH')).to.throw(
      'in metres, as ODIM_H5 2.4 has it',
    );
  });

  it('heights are kilometres up to 2.3 and metres from 2.4 on', () => {
    for (const [version, unit] of [
      ['2.3', 'km'],
      ['2.4', 'm'],
    ])
      expect(sweepOf(version, { rscale: 500 }, { quantity: 'HGHT' }).found[0].unit).to.equal(unit);
  });

  it("velocities fold where the frequency says so, which took the wavelength's place", () => {
    const old = sweepOf('2.2', { rscale: 500 }, { how: { wavelength: 5.349, highprf: 600 } }).nyquist!;
    expect(old).to.be.closeTo(8.0235, 1e-4);
    expect(
      sweepOf('2.4', { rscale: 500 }, { how: { frequency: 299_792_458 / 0.05349, highprf: 600 } }).nyquist,
    ).to.be.closeTo(old, 1e-9);
  });
});

/** What is read from a sweep of four radials whose group `how` says this. */
function elevationsOf(how: Readonly<Record<string, readonly number[]>>): number[] | undefined {
  const dataset = group(
    {},
    {
      where: group({ elangle: Float64Array.of(0.5) }),
      how: group(Object.fromEntries(Object.entries(how).map(([name, numbers]) => [name, Float64Array.from(numbers)]))),
      data1: group({}, { what: group({ quantity: 'DBZH' }) }, gates),
    },
  );
  const { elevations } = readOdimSweep(group({}), dataset)!;
  return elevations && Array.from(elevations, (elevation) => Number(elevation.toFixed(9)));
}

describe('what an ODIM_H5 file says of its own parts', () => {
  type Texts = Readonly<Record<string, string>>;
  const parts = (how: Texts = {}, elangle = 0.5, ofData: Texts = {}, product = 'SCAN'): Record<string, DataGroup> => ({
    what: group({ product }),
    how: group(how),
    where: group(numbers({ elangle, rscale: 500 })),
    data1: group({}, { what: group({ quantity: 'DBZH' }), how: group(ofData) }, gates),
  });
  const dataset = (product: string, how: Texts = {}, elangle = 0.5, ofData: Texts = {}): DataGroup =>
    group({}, parts(how, elangle, ofData, product));
  const read = (datasets: Readonly<Record<string, DataGroup>>): RadarFile =>
    readOdimTree(
      group(
        { Conventions: 'ODIM_H5/V2_2' },
        { what: group({ object: 'PVOL' }), how: group(numbers({ beamwH: 1.2, beamwV: 0.9 })), ...datasets },
      ),
      Budget.ofFile(2 ** 20),
    );

  it('leaves out what is no scan, and a sweep whose radar calls itself faulty', () => {
    const sound = dataset('SCAN', {}, 1.5);
    const file = read({
      dataset1: dataset('SCAN', { malfunc: 'True', radar_msg: 'TR limiter' }),
      dataset2: dataset('VP'),
      dataset3: sound,
    });
    expect(file.sweeps).to.have.length(2);
    const { sweeps, left, details } = buildPolarVolume(file, {}).radar!;
    expect(sweeps.map(({ elevation }) => elevation)).to.deep.equal([1.5]);
    expect(left).to.deep.equal([
      'sweep 1 at 0.5° is left out: its radar says that it is faulty (how/malfunc: TR limiter)',
    ]);
    expect(details.join()).to.contain('no scan but VP');
  });

  it('says of a faulty sweep nothing that matters where a sound one shows the same air, and of one quantity alone what is said of it', () => {
    const faulty = { malfunc: 'True' };
    const { sweeps, left, details } = buildPolarVolume(
      read({ dataset1: dataset('SCAN', faulty), dataset2: dataset('SCAN', { malfunc: 'False' }) }),
      {},
    ).radar!;
    expect([sweeps.length, left]).to.deep.equal([1, []]);
    expect(details[0]).to.contain('left out: its radar says that it is faulty');
    const parts = read({
      dataset1: dataset('SCAN', {}, 0.5, faulty),
      dataset2: dataset('SCAN', faulty, 1.5, { malfunc: 'False' }),
    });
    expect(buildPolarVolume(parts, {}).radar!.sweeps.map(({ elevation }) => elevation)).to.deep.equal([1.5]);
  });

  it('shows sweeps that are all faulty, and says so', () => {
    const { sweeps, left } = buildPolarVolume(
      read({ dataset1: dataset('SCAN', { malfunc: 'true ' }), dataset2: dataset('SCAN', { malfunc: 'True' }, 1.5) }),
      {},
    ).radar!;
    expect(sweeps).to.have.length(2);
    expect(left).to.deep.equal([
      'all sweeps are faulty, as their radar says (how/malfunc): they are shown all the same',
    ]);
  });

  it('says which fields of quality it does not use', () => {
    const quality = group({}, { how: group({ task: 'se.smhi.detector.poo' }) });
    expect(read({ dataset1: group({}, { ...parts(), quality1: quality, quality2: group({}) }) }).details).to.deep.equal(
      ['2 fields of quality are not used (se.smhi.detector.poo, no how/task)'],
    );
  });

  it("takes the beam's height before its width: sweeps reach that far", () => {
    expect(read({ dataset1: dataset('SCAN') }).beamWidth).to.equal(0.9);
  });
});

describe('ODIM_H5 files that are refused', () => {
  /** A fixture with one text written over another of the same length. */
  const patched = async (name: string, from: string, to: string): Promise<Uint8Array<ArrayBuffer>> => {
    const bytes = await fetchFixture(`radar/${name}`);
    const text = new TextDecoder('latin1').decode(bytes);
    const at = text.indexOf(from);
    expect(at, from).to.be.greaterThan(0);
    bytes.set(new TextEncoder().encode(to), at);
    return bytes;
  };

  it('name other objects in words', async () => {
    const error = await expectError(readOdim(await patched('odim-2.0.h5', 'PVOL', 'COMP')));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('COMP, a composite of radars').and.to.contain('PVOL').and.to.contain('wradlib');
  });

  it('say what is not HDF5, and what is cut', async () => {
    expect((await expectError(readOdim(new Uint8Array(5000)))).code).to.equal('format/unknown');
    const bytes = await fetchFixture('radar/odim-2.0.h5');
    const error = await expectError(readOdim(bytes.slice(0, bytes.length - 1)));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message)
      .to.contain(`${bytes.length - 1} bytes`)
      .and.to.contain(`${bytes.length}`);
  });

  it('say what an HDF5 file holds that is no radar scan', async () => {
    const bytes = await patched('odim-2.1.h5', 'ODIM_H5/V2_1', 'else_H5/V2_1');
    const error = await expectError(readHdf5Radar(await withoutWhat(bytes)));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('dataset1').and.to.contain('ODIM_H5').and.to.contain('OME-Zarr');
  });

  it('say that a chunk is damaged, by its checksum', async () => {
    const bytes = await fetchFixture('radar/odim-2.0.h5');
    // The largest run without zeros is compressed data.
    const at = longestRun(bytes);
    bytes[at] ^= 0x10;
    const radar = await readOdim(bytes);
    const error = await expectError((async () => radar.sweeps.map((sweep) => sweep.read('DBZH')))());
    expect(error.code).to.equal('format/corrupt');
  });
});

/** The groups' names 'what' become 'whot'. */
async function withoutWhat(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const text = new TextDecoder('latin1').decode(bytes);
  for (let at = text.indexOf('what\0'); at >= 0; at = text.indexOf('what\0', at + 1)) bytes[at + 2] = 0x6f;
  return bytes;
}

/** The middle of the longest run of bytes that are not 0. */
function longestRun(bytes: Uint8Array): number {
  let best = { length: 0, middle: 0 };
  let start = 0;
  for (let at = 0; at < bytes.length; at++) {
    if (bytes[at] !== 0) continue;
    if (at - start > best.length) best = { length: at - start, middle: (at + start) >> 1 };
    start = at + 1;
  }
  return best.middle;
}
