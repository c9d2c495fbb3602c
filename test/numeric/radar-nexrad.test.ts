import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../src/formats/radar/build-polar-volume.ts';
import { readNexrad } from '../../src/formats/radar/nexrad.ts';
import type { RadarFile } from '../../src/formats/radar/radar-file.ts';
import { beamToLocal, standardEarthRadius } from '../../src/radar/polar-geometry.ts';
import { expectError, fetchFixture } from '../helpers/decode.ts';
import { gateValues } from '../helpers/radar.ts';
import { fetchSharedData } from '../helpers/shared-data.ts';

/** What Py-ART says of a file; made by test/fixtures/make-nexrad-fixtures.py. */
interface Expected {
  path: string;
  site: [name: string, latitude: number | null, longitude: number | null, height: number | null];
  time: string;
  sweeps: {
    elevation: number;
    rays: number;
    time: string;
    nyquist: number | null;
    azimuths: [ray: number, azimuth: number][];
    moments: Record<string, [gates: number, firstGate: number, gateLength: number]>;
  }[];
  /** `gates`: sweep, radial and gate of one value after another. */
  moments: Record<string, { unit: string; gates: number[]; values: (number | null)[] }>;
  positions: { sweep: number; moment: string; ray: number; gate: number; x: number; y: number; z: number }[];
}

const readList = async (name: string): Promise<Expected[]> =>
  (JSON.parse(new TextDecoder().decode(await fetchFixture(name))) as { files: Expected[] }).files;
const fixtures = await readList('nexrad-fixtures.json');
const shared = await readList('nexrad-shared.json');

/** Of seven digits, as the expected numbers have; and Py-ART's own arithmetic, which is float32. */
const tolerance = (value: number): number => 2e-6 * Math.max(1, Math.abs(value));

function compare(radar: RadarFile, expected: Expected): void {
  const [name, latitude, longitude, height] = expected.site;
  expect(radar.format).to.equal('NEXRAD Level II');
  expect(radar.site).to.deep.equal(latitude === null ? { name } : { name, latitude, longitude, height });
  expect(radar.time).to.equal(expected.time);
  expect(radar.partial).to.equal(undefined);
  expect(radar.moments.map((moment) => [moment.name, moment.unit])).to.have.deep.members(
    Object.entries(expected.moments).map(([moment, { unit }]) => [moment, unit]),
  );
  expect(radar.sweeps.length).to.equal(expected.sweeps.length);
  radar.sweeps.forEach((sweep, i) => {
    const wanted = expected.sweeps[i];
    expect(sweep.elevation, `elevation ${i}`).to.be.closeTo(wanted.elevation, 2e-6 * Math.max(1, wanted.elevation));
    expect(sweep.azimuths.length, `rays ${i}`).to.equal(wanted.rays);
    for (const [ray, azimuth] of wanted.azimuths) expect(sweep.azimuths[ray], `azimuth ${i}, ${ray}`).to.be.closeTo(azimuth, 1e-5);
    expect(sweep.time).to.equal(wanted.time);
    if (wanted.nyquist === null) expect(sweep.nyquist).to.equal(undefined);
    else expect(sweep.nyquist).to.be.closeTo(wanted.nyquist, 1e-6);
    const grids = Object.fromEntries(sweep.moments.map((moment) => {
      const { gates, firstGate, gateLength } = sweep.read(moment)!;
      return [moment, [gates, firstGate, gateLength]];
    }));
    expect(grids).to.deep.equal(wanted.moments);
  });
  for (const moment of Object.keys(expected.moments)) compareValues(radar, expected, moment);
}

function compareValues(radar: RadarFile, expected: Expected, moment: string): void {
  const data = radar.sweeps.map((sweep) => sweep.read(moment));
  const numbers = data.map((sweep) => (sweep ? gateValues(sweep) : new Float64Array()));
  const { gates, values } = expected.moments[moment];
  values.forEach((value, n) => {
    const [sweep, ray, gate] = gates.slice(3 * n, 3 * n + 3);
    const got = numbers[sweep][ray * data[sweep]!.gates + gate];
    const where = `${moment}, sweep ${sweep}, ray ${ray}, gate ${gate}: ${got} for ${value}`;
    if (value === null) expect(Number.isNaN(got), where).to.equal(true);
    else expect(Math.abs(got - value), where).to.be.at.most(tolerance(value));
  });
}

/** Largest distance between our gates and Py-ART's, metres. */
function comparePositions(radar: RadarFile, { positions }: Expected): number {
  return Math.max(...positions.map(({ sweep, moment, ray, gate, x, y, z }) => {
    const { elevation, azimuths, read } = radar.sweeps[sweep];
    const { firstGate, gateLength } = read(moment)!;
    const local = beamToLocal({ range: firstGate + gate * gateLength, azimuth: azimuths[ray], elevation }, standardEarthRadius);
    return Math.max(Math.hypot(local[0] - x, local[1] - y), Math.abs(local[2] - z));
  }));
}

describe('NEXRAD Level II against Py-ART', () => {
  for (const expected of fixtures) {
    it(expected.path, async () => {
      const radar = await readNexrad(await fetchFixture(expected.path));
      compare(radar, expected);
      expect(comparePositions(radar, expected)).to.be.at.most(1);
    });
  }
});

describe('NEXRAD Level II files of the shared data against Py-ART', () => {
  for (const expected of shared) {
    it(expected.path, async function () {
      const radar = await readNexrad(new Uint8Array(await fetchSharedData(this, expected.path)));
      for (const { values } of Object.values(expected.moments)) expect(values.length).to.equal(1000);
      compare(radar, expected);
      expect(expected.positions.length).to.equal(100);
      expect(comparePositions(radar, expected)).to.be.at.most(1);
    });
  }

  it('a file that is cut short gives the radials up to there', async function () {
    const bytes = new Uint8Array(await fetchSharedData(this, shared[0].path));
    const radar = await readNexrad(bytes.slice(0, Math.floor(bytes.length / 2)));
    expect(radar.partial).to.contain('was cut short').and.to.contain('elevation');
    expect(radar.sweeps.length).to.be.within(2, 10);
    const whole = await readNexrad(bytes);
    const count = radar.sweeps[0].azimuths.length * 1832;
    expect(radar.sweeps[0].read('REF')!.samples.slice(0, count)).to.deep.equal(whole.sweeps[0].read('REF')!.samples.slice(0, count));
  });

  it('make volumes: of the two scans of the lowest elevation, one is shown', async function () {
    const radar = await readNexrad(new Uint8Array(await fetchSharedData(this, shared[1].path)));
    const volume = buildPolarVolume(radar, { moment: 'VEL' });
    expect(volume.grid.sweeps.length).to.equal(14);
    expect(volume.radar?.left.length).to.equal(2);
    expect(volume.grid.foldFrom).to.be.closeTo(25.37 * 2, 0.5);
  });
});

describe('NEXRAD Level II as stored', () => {
  it('keeps 8 and 16 bits, with 0 for below threshold and for folded range', async () => {
    const [surveillance, , last] = (await readNexrad(await fetchFixture('nexrad/message-31.ar2v'))).sweeps;
    const reflectivity = surveillance.read('REF')!;
    expect(reflectivity).to.include({ slope: 0.5, intercept: -33 });
    expect(reflectivity.samples).to.be.instanceOf(Uint8Array);
    expect(reflectivity.samples.includes(0)).to.equal(true);
    expect(reflectivity.samples.includes(1)).to.equal(false);
    expect(surveillance.read('PHI')!.samples).to.be.instanceOf(Uint16Array);
    expect(surveillance.read('VEL')).to.equal(null);
    // Power that a filter took away is not negative: lower codes are no values.
    expect(Math.min(...last.read('CFP')!.samples.filter((code) => code > 0))).to.equal(8);
  });

  it('knows the elevation of each radial', async () => {
    // As test/fixtures/make-nexrad-fixtures.py makes them; angles of message 1 are 65,536ths of a turn.
    for (const [name, means, step] of [['message-31.ar2v', [0.53, 0.49, -1.25], 1e-6], ['message-1.gz', [0.4], 360 / 65536]] as const) {
      const { sweeps } = await readNexrad(await fetchFixture(`nexrad/${name}`));
      means.forEach((mean, i) => {
        const { azimuths, elevations } = sweeps[i];
        expect(elevations).to.have.length(azimuths.length);
        elevations!.forEach((elevation, ray) => expect(elevation, name).to.be.closeTo(mean + 0.02 * Math.cos(ray), step));
      });
    }
  });

  it('gives moments their kinds', async () => {
    const { moments } = await readNexrad(await fetchFixture('nexrad/message-31.ar2v'));
    expect(Object.fromEntries(moments.map(({ name, kind }) => [name, kind]))).to.deep.equal({
      REF: 'reflectivity', VEL: 'velocity', SW: 'spectrum-width', ZDR: 'differential-reflectivity', PHI: 'differential-phase', RHO: 'correlation', CFP: 'other',
    });
  });

  it('packed or not, the same', async () => {
    const [packed, plain] = await Promise.all(['message-31', 'message-31-plain'].map(async (name) => readNexrad(await fetchFixture(`nexrad/${name}.ar2v`))));
    packed.sweeps.forEach((sweep, i) => {
      for (const moment of sweep.moments) expect(plain.sweeps[i].read(moment)).to.deep.equal(sweep.read(moment));
    });
  });
});

describe('NEXRAD Level II files that are not whole', () => {
  it('cut between two records: says that the volume was not over', async () => {
    const bytes = await fetchFixture('nexrad/message-31.ar2v');
    const view = new DataView(bytes.buffer);
    let end = 24;
    for (let record = 0; record < 4; record++) end += 4 + Math.abs(view.getInt32(end));
    const radar = await readNexrad(bytes.slice(0, end));
    expect(radar.sweeps.map(({ azimuths }) => azimuths.length)).to.deep.equal([36, 18]);
    expect(radar.partial).to.contain('before its radar says that it is over');
    const within = await readNexrad(bytes.slice(0, end + 100));
    expect(within.sweeps.map(({ azimuths }) => azimuths.length)).to.deep.equal([36, 18]);
    expect(within.partial).to.contain('cut short').and.to.contain('record 5 needs');
  });

  it('unpacked: gives all whole radials', async () => {
    const bytes = await fetchFixture('nexrad/message-31-plain.ar2v');
    const radar = await readNexrad(bytes.slice(0, bytes.length - 10));
    expect(radar.sweeps.map(({ azimuths }) => azimuths.length)).to.deep.equal([36, 36, 19]);
    expect(radar.partial).to.contain('lacks 10 bytes');
  });

  it('of another format, or without radials', async () => {
    const other = await expectError(readNexrad(new TextEncoder().encode('something else altogether')));
    expect(other.code).to.equal('format/unknown');
    const bytes = await fetchFixture('nexrad/message-31.ar2v');
    const empty = await expectError(readNexrad(bytes.slice(0, 24)));
    expect(empty.code).to.equal('format/corrupt');
    expect(empty.message).to.contain('no radials');
  });

  it('with a damaged record: a checksum says so', async () => {
    const bytes = await fetchFixture('nexrad/message-31.ar2v');
    bytes[bytes.length - 200] ^= 4;
    const error = await expectError(readNexrad(bytes));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('bzip2');
  });
});
