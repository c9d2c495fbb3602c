import { expect } from '@esm-bundle/chai';
import { readManifest } from '../../../src/formats/manifest/manifest.ts';
import { readPng } from '../../../src/formats/images/png.ts';
import { buildPolarVolume } from '../../../src/formats/radar/build-polar-volume.ts';
import { readPolarMosaic } from '../../../src/formats/radar/polar-mosaic.ts';
import type { PolarMosaicSettings } from '../../../src/formats/base/radar-settings.ts';
import { encodePng } from '../../../src/prepare/radar-mosaic.ts';
import type { RadarFile } from '../../../src/formats/radar/radar-file.ts';
import { readCfradial1 } from '../../../src/formats/radar/cfradial1.ts';
import { readHdf5Radar } from '../../../src/formats/radar/hdf5-radar.ts';
import { readNexrad } from '../../../src/formats/radar/nexrad.ts';
import { writePolarMosaic } from '../../../src/prepare/write-polar-mosaic.ts';
import type { DecodedPolarVolume, DecodedVolume } from '../../../src/formats/base/decoded-volume.ts';
import { expectError, fetchFixture } from '../../helpers/decode.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';
import { polarScenes, syntheticRadar } from '../../helpers/synthetic-radar.ts';

/** Through a PNG and JSON text, as a page gets them. */
async function roundTrip(file: RadarFile, moment: string): Promise<{ mosaic: RadarFile; rounding: number }> {
  const { image, manifest, rounding } = writePolarMosaic(file, moment);
  const png = await readPng(new Uint8Array(encodePng(image)));
  expect(png.data.constructor).to.equal(image.data.constructor);
  const read = readManifest(new TextEncoder().encode(JSON.stringify({ image: 'x.png', ...manifest })));
  const { slope = 1, intercept = 0, unit = '', elevations = [] } = read;
  return { mosaic: readPolarMosaic(png, 'PNG', { ...read, elevations, slope, intercept, unit }), rounding };
}

function valueAt({ samples, slope, intercept }: DecodedVolume, i: number): number {
  const isEmpty = samples instanceof Float32Array ? Number.isNaN(samples[i]) : samples[i] === 0;
  return isEmpty ? NaN : slope * samples[i] + intercept;
}

/** The two give the same gates at the same positions, and so the same picture. */
function compareVolumes(got: DecodedPolarVolume, wanted: DecodedPolarVolume, rounding: number): void {
  expect(got).to.deep.include({ unit: wanted.unit });
  const [polar, original] = [got.grid, wanted.grid];
  expect(polar.beamWidth).to.equal(original.beamWidth);
  expect(polar.sweeps.length).to.equal(original.sweeps.length);
  polar.sweeps.forEach(({ azimuths, elevations, ...sweep }, i) => {
    const { azimuths: places, elevations: heights, ...geometry } = original.sweeps[i];
    expect(sweep, `sweep ${i}`).to.deep.equal(geometry);
    expect(azimuths.length).to.equal(places.length);
    expect(elevations?.length).to.equal(heights?.length);
    heights?.forEach((elevation, ray) =>
      expect(elevations![ray], `sweep ${i}, ray ${ray}`).to.be.closeTo(elevation, 1e-5),
    );
    places.forEach((azimuth, ray) => expect(azimuths[ray], `sweep ${i}, ray ${ray}`).to.be.closeTo(azimuth, 1e-5));
  });
  expect(got.samples.length).to.equal(wanted.samples.length);
  let farthest = 0;
  let largest = 0;
  for (let i = 0; i < got.samples.length; i++) {
    const [a, b] = [valueAt(got, i), valueAt(wanted, i)];
    if (Number.isNaN(a) !== Number.isNaN(b)) throw new Error(`gate ${i} got ${a} for ${b}`);
    if (Number.isNaN(a)) continue;
    farthest = Math.max(farthest, Math.abs(a - b));
    largest = Math.max(largest, Math.abs(b));
  }
  // Where a volume's samples are floats, they have float32's rounding.
  expect(farthest).to.be.at.most(rounding === 0 ? 0 : rounding * (1 + 1e-6) + largest * 2 ** -23);
  if (rounding === 0 && original.foldFrom !== undefined) expect(polar.foldFrom).to.equal(original.foldFrom);
}

async function check(file: RadarFile): Promise<number> {
  for (const { name, kind } of file.moments) {
    const { mosaic, rounding } = await roundTrip(file, name);
    expect(mosaic.site).to.deep.equal(file.site);
    expect(mosaic.time).to.equal(file.time);
    if (kind === 'velocity' || kind === 'reflectivity') expect(mosaic.moments[0]).to.include({ name, kind });
    compareVolumes(buildPolarVolume(mosaic, {}), buildPolarVolume(file, { moment: name }), rounding);
  }
  return file.moments.length;
}

describe('a radar file and the mosaic that is written of it hold the same', () => {
  const readers: Record<string, (bytes: Uint8Array<ArrayBuffer>) => Promise<RadarFile>> = {
    'nexrad/message-31.ar2v': readNexrad,
    'nexrad/message-1.gz': readNexrad,
    'radar/odim-2.0.h5': readHdf5Radar,
    'radar/odim-2.1.h5': readHdf5Radar,
    'radar/odim-2.2.h5': readHdf5Radar,
    'radar/odim-2.4-scan.h5': readHdf5Radar,
    'radar/cfradial1-classic.nc': readCfradial1,
    'radar/cfradial1-ragged.nc': readHdf5Radar,
  };
  for (const [path, read] of Object.entries(readers)) {
    it(path, async () => expect(await check(await read(await fetchFixture(path)))).to.be.greaterThan(0));
  }

  for (const [name, options] of Object.entries(polarScenes)) {
    it(name, async () => expect(await check(syntheticRadar(options))).to.equal(1));
  }

  it('radar/nexrad/KLIX20050828_180149.gz', async function () {
    expect(
      await check(await readNexrad(new Uint8Array(await fetchSharedData(this, 'radar/nexrad/KLIX20050828_180149.gz')))),
    ).to.equal(3);
  });

  it('radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5', async function () {
    const bytes = new Uint8Array(
      await fetchSharedData(this, 'radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5'),
    );
    const { mosaic } = await roundTrip(await readHdf5Radar(bytes), 'DBZH');
    compareVolumes(buildPolarVolume(mosaic, {}), buildPolarVolume(await readHdf5Radar(bytes), { moment: 'DBZH' }), 0);
  });
});

describe('a polar mosaic by its attributes', () => {
  // 3 x 2 tiles of 4 gates and 6 radials; five sweeps. A pixel counts sweep, radial and gate.
  const size = { width: 12, height: 12 };
  const at = (tile: number, ray: number, gate: number): number =>
    (Math.floor(tile / 3) * 6 + ray) * 12 + (tile % 3) * 4 + gate;
  const data = new Uint8Array(144);
  for (let tile = 0; tile < 5; tile++)
    for (let ray = 0; ray < 6; ray++)
      for (let gate = 0; gate < 4; gate++) data[at(tile, ray, gate)] = tile * 40 + ray * 5 + gate;
  const image = { ...size, data };
  const settings: PolarMosaicSettings = {
    mosaic: { columns: 3, rows: 2 },
    elevations: [0.5, 1, 2, 4, 8],
    range: [250, 500],
    slope: 0.5,
    intercept: -32,
    unit: 'dBZ',
  };
  const layoutError = async (changes: Partial<PolarMosaicSettings>): Promise<string> => {
    const error = await expectError((async () => readPolarMosaic(image, 'PNG', { ...settings, ...changes }))());
    expect(error.code).to.equal('mosaic/layout');
    return error.message;
  };

  it('has one sweep per tile, radials down and gates to the right', () => {
    const radar = readPolarMosaic(image, 'PNG', { ...settings, moment: 'DBZH' });
    expect(radar).to.deep.include({
      format: 'PNG polar mosaic',
      moments: [{ name: 'DBZH', unit: 'dBZ', kind: 'reflectivity' }],
    });
    radar.sweeps.forEach((sweep, i) => {
      const { samples, ...rest } = sweep.read('DBZH')!;
      expect(rest).to.deep.equal({ firstGate: 250, gateLength: 500, gates: 4, slope: 0.5, intercept: -32 });
      expect(samples.length).to.equal(24);
      samples.forEach((sample, n) => expect(sample).to.equal(i * 40 + Math.floor(n / 4) * 5 + (n % 4)));
      expect(sweep.read('VRAD')).to.equal(null);
    });
  });

  it('goes around from north where no azimuth is given, and from where it is', () => {
    expect([...readPolarMosaic(image, 'PNG', settings).sweeps[0].azimuths]).to.deep.equal([30, 90, 150, 210, 270, 330]);
    const turned = readPolarMosaic(image, 'PNG', { ...settings, azimuth: [358, -1.5] });
    expect([...turned.sweeps[4].azimuths]).to.deep.equal([358, 356.5, 355, 353.5, 352, 350.5]);
  });

  it('may differ from tile to tile', () => {
    const sweeps = [
      {},
      {
        rays: 3,
        gates: 2,
        range: [100, 50] as const,
        azimuths: [350, 10.5, 20],
        elevations: [1, 1.5, 2],
        nyquist: 8,
        time: '2020-02-07T13:00:00Z',
      },
    ];
    const radar = readPolarMosaic(image, 'PNG', { ...settings, unit: 'm/s', nyquist: 7, sweeps });
    expect(radar.moments[0].kind).to.equal('velocity');
    const [first, second] = radar.sweeps;
    expect(first.nyquist).to.equal(7);
    expect(second).to.include({ nyquist: 8, time: '2020-02-07T13:00:00Z' });
    expect([...second.azimuths]).to.deep.equal([350, 10.5, 20]);
    expect([...second.elevations!]).to.deep.equal([1, 1.5, 2]);
    expect(second.read('value')).to.deep.include({
      firstGate: 100,
      gateLength: 50,
      gates: 2,
      samples: Uint8Array.from([40, 41, 45, 46, 50, 51]),
    });
  });

  it('says what is missing or does not fit', async () => {
    expect(await layoutError({ mosaic: undefined }))
      .to.contain('mosaic="COLUMNSxROWS"')
      .and.to.contain('5 elevations');
    expect(await layoutError({ range: undefined })).to.contain('range="FIRST GATE-LENGTH"');
    expect(await layoutError({ range: [250, 0] })).to.contain('"250 0"');
    expect(await layoutError({ slices: 4 }))
      .to.contain('slices got 4')
      .and.to.contain('5 angles');
    expect(await layoutError({ mosaic: { columns: 2, rows: 2 } })).to.contain('5 angles; expected at most 4');
    expect(await layoutError({ mosaic: { columns: 5, rows: 1 } }))
      .to.contain('2.4 x 12')
      .and.to.contain('whole pixels');
    expect(await layoutError({ sweeps: [{ rays: 7 }] })).to.contain('7 radials');
    expect(await layoutError({ sweeps: [{ rays: 2, azimuths: [1] }] })).to.contain('1 azimuths and 2 radials');
    expect(await layoutError({ sweeps: [{ rays: 2, elevations: [1] }] })).to.contain('1 elevations and 2 radials');
    expect(await layoutError({ sweeps: [{}, {}, {}, {}, {}, {}] })).to.contain('6 tiles');
  });
});
