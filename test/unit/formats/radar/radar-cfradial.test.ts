import { expect } from '@esm-bundle/chai';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import { readCfradial2 } from '../../../../src/formats/radar/cfradial2.ts';
import { readHdf5Radar } from '../../../../src/formats/radar/hdf5-radar.ts';
import { momentKindOf, normaliseUnit } from '../../../../src/formats/radar/moment-kind.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { expectError, fetchFixture } from '../../../helpers/decode.ts';
import { compareRadar, gateValues, readExpected } from '../../../helpers/radar.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';

const isCfradial = ({ path }: { path: string }): boolean => path.includes('cfradial');
const fixtures = (await readExpected('radar-fixtures.json')).filter(isCfradial);
const shared = (await readExpected('radar-shared.json')).filter(isCfradial);

const read = (bytes: Uint8Array<ArrayBuffer>, path: string): Promise<RadarFile> =>
  path.includes('cfradial2') ? readCfradial2(bytes) : readCfradial1(bytes);

describe('CfRadial against Py-ART and xradar', () => {
  for (const expected of fixtures) {
    it(`${expected.path} (${expected.source})`, async () =>
      compareRadar(await read(await fetchFixture(expected.path), expected.path), expected));
  }

  it('classic, 64-bit offsets, 64-bit data, NetCDF-4, radials of different lengths and CfRadial 2 are there', () => {
    expect(fixtures.map(({ path }) => path)).to.have.length(6);
  });
});

describe('CfRadial files of the shared data against Py-ART', () => {
  for (const expected of shared) {
    it(expected.path, async function () {
      compareRadar(await readCfradial1(new Uint8Array(await fetchSharedData(this, expected.path))), expected);
    });
  }
});

describe('CfRadial as stored', () => {
  const load = async (name: string): Promise<RadarFile> => read(await fetchFixture(`radar/${name}`), name);

  it('names version, site and moments with unit and kind', async () => {
    const radar = await load('cfradial1-classic.nc');
    expect(radar.format).to.equal('CfRadial 1.3');
    expect(radar.site.name).to.equal('Testfeld');
    expect(radar.moments).to.deep.equal([
      { name: 'DBZ', unit: 'dBZ', kind: 'reflectivity' },
      { name: 'VEL', unit: 'm/s', kind: 'velocity' },
      { name: 'WIDTH', unit: 'm/s', kind: 'spectrum-width' },
    ]);
    expect((await load('cfradial2.nc')).format).to.equal('CfRadial 2');
  });

  it('keeps packed numbers in 8 and 16 bits', async () => {
    const [sweep] = (await load('cfradial1-cdf5.nc')).sweeps;
    expect(sweep.read('DBZ')?.samples).to.be.instanceOf(Uint16Array);
    expect(sweep.read('VEL')?.samples).to.be.instanceOf(Uint16Array);
    expect(sweep.read('ZDR')?.samples).to.be.instanceOf(Uint8Array);
    expect(sweep.read('WIDTH')?.samples).to.be.instanceOf(Float32Array);
    expect(sweep.read('no such moment')).to.equal(null);
  });

  it('reads the same from NetCDF-3 and NetCDF-4, whole and by records', async () => {
    const [first, ...others] = await Promise.all(
      ['cfradial1-classic.nc', 'cfradial1-records.nc', 'cfradial1-nc4.nc', 'cfradial1-cdf5.nc'].map(load),
    );
    for (const other of others) {
      for (const [i, sweep] of first.sweeps.entries()) {
        for (const moment of ['DBZ', 'VEL', 'WIDTH']) {
          expect(gateValues(other.sweeps[i].read(moment)!), `${moment}, sweep ${i}`).to.deep.equal(
            gateValues(sweep.read(moment)!),
          );
        }
      }
    }
  });

  it('knows the elevation of each radial', async () => {
    for (const name of ['cfradial1-classic.nc', 'cfradial1-ragged.nc', 'cfradial2.nc']) {
      for (const sweep of (await load(name)).sweeps) {
        expect(sweep.elevations).to.have.length(sweep.azimuths.length);
        // The fixture's radials are a hundredth of a degree above their sweep, in float32.
        for (const elevation of sweep.elevations!) expect(elevation, name).to.be.closeTo(sweep.elevation + 0.01, 1e-6);
      }
    }
  });

  it('fills radials that end early with no data', async () => {
    const [whole, ragged] = await Promise.all(['cfradial1-classic.nc', 'cfradial1-ragged.nc'].map(load));
    const data = ragged.sweeps[1].read('DBZ')!;
    const values = gateValues(data);
    const wanted = gateValues(whole.sweeps[1].read('DBZ')!);
    let ended = 0;
    values.forEach((value, i) => {
      // The fixture's radial n has n % 9 + 14 gates; the second sweep begins with radial 20.
      const isBeyond = i % data.gates >= ((Math.floor(i / data.gates) + 20) % 9) + 14;
      if (isBeyond) ended++;
      expect(value, `gate ${i}`).to.deep.equal(isBeyond ? NaN : wanted[i]);
    });
    expect(ended).to.be.greaterThan(50);
  });

  it('knows NetCDF-4 files by what they hold', async () => {
    for (const name of ['cfradial1-nc4.nc', 'cfradial2.nc']) {
      const bytes = await fetchFixture(`radar/${name}`);
      expect((await readHdf5Radar(bytes)).sweeps).to.have.length(3);
    }
  });
});

describe('CfRadial files that are refused', () => {
  it('say what is no NetCDF, what is another, and what is cut', async () => {
    expect((await expectError(readCfradial1(new Uint8Array(5000)))).code).to.equal('format/unknown');
    expect((await expectError(readCfradial2(await fetchFixture('radar/odim-2.0.h5')))).code).to.equal(
      'format/unsupported',
    );
    expect((await expectError(readCfradial1(await fetchFixture('radar/odim-2.0.h5')))).code).to.equal(
      'format/unsupported',
    );
    const bytes = await fetchFixture('radar/cfradial1-classic.nc');
    const error = await expectError(readCfradial1(bytes.slice(0, bytes.length - 8)));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message)
      .to.contain('ends early')
      .and.to.contain(`${bytes.length - 8} bytes`);
  });

  it('refuse a list that is longer than the file, before it is read', async () => {
    const bytes = await fetchFixture('radar/cfradial1-classic.nc');
    new DataView(bytes.buffer).setUint32(12, 0x7fffffff); // Dimensions.
    expect((await expectError(readCfradial1(bytes))).code).to.equal('format/corrupt');
  });

  it('leave out range-height scans next to sweeps of constant elevation', async () => {
    const bytes = await fetchFixture('radar/cfradial1-classic.nc');
    const text = new TextDecoder('latin1').decode(bytes);
    bytes.set(new TextEncoder().encode('rhi\0'), text.indexOf('sector\0'));
    const { sweeps, left } = await readCfradial1(bytes);
    expect(sweeps.map(({ elevation }) => elevation)).to.deep.equal([0.5, 1.5]);
    expect(left!.join()).to.contain('1 of 3 sweeps are left out').and.to.contain('(sweep_mode: rhi)');
  });
});

describe('what a moment is', () => {
  const kinds: [string, string | undefined, string, string][] = [
    // name, standard name, unit, kind
    ['DBZH', undefined, 'dBZ', 'reflectivity'],
    ['TH', undefined, '', 'reflectivity'],
    ['REF', undefined, 'dBZ', 'reflectivity'],
    ['corrected_reflectivity', undefined, 'dBZ', 'reflectivity'],
    ['x', 'equivalent_reflectivity_factor', 'dBZ', 'reflectivity'],
    ['VRADH', undefined, 'm/s', 'velocity'],
    ['VEL', undefined, 'm s-1', 'velocity'],
    ['mean_doppler_velocity', undefined, 'm/s', 'velocity'],
    ['x', 'radial_velocity_of_scatterers_away_from_instrument', 'meters_per_second', 'velocity'],
    ['WRADH', undefined, 'm/s', 'spectrum-width'],
    ['SW', undefined, '', 'spectrum-width'],
    ['spectral_width', undefined, 'm/s', 'spectrum-width'],
    ['ZDR', undefined, 'dB', 'differential-reflectivity'],
    ['x', 'log_differential_reflectivity_hv', 'dB', 'differential-reflectivity'],
    ['PHIDP', undefined, 'degrees', 'differential-phase'],
    ['PHI', undefined, '', 'differential-phase'],
    ['RHOHV', undefined, '', 'correlation'],
    ['RHO', undefined, '', 'correlation'],
    ['KDP', undefined, 'degrees/km', 'other'],
    ['specific_differential_phase', undefined, 'degrees/km', 'other'],
    ['SNR', undefined, 'dB', 'other'],
    ['velocity_texture', undefined, 'm/s', 'other'],
    ['reflectivity', undefined, 'mm6/m3', 'other'],
    ['QCFLAGS', undefined, '', 'other'],
    ['CLASS', undefined, '', 'kinds'],
  ];
  for (const [name, standardName, unit, kind] of kinds) {
    it(`${name} ${standardName ?? ''} ${unit}: ${kind}`, () => {
      expect(momentKindOf({ name, unit, ...(standardName ? { standardName } : {}) })).to.equal(kind);
    });
  }

  it('units in one spelling', () => {
    for (const unit of ['m/s', 'm s-1', 'meters_per_second', 'meters per second', 'm.s-1', 'ms-1'])
      expect(normaliseUnit(unit), unit).to.equal('m/s');
    expect(['DBZ', 'dBz', 'unitless', '1', 'degree', 'degrees/km', 'furlongs'].map(normaliseUnit)).to.deep.equal([
      'dBZ',
      'dBZ',
      '',
      '',
      'degrees',
      'degrees/km',
      'furlongs',
    ]);
  });
});
