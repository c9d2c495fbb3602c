import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { readNexrad } from '../../../../src/formats/radar/nexrad.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { beamToLocal, standardEarthRadius } from '../../../../src/radar/polar-geometry.ts';
import { expectError, fetchFixture } from '../../../helpers/decode.ts';
import { buildNexrad } from '../../../helpers/nexrad-builder.ts';
import type { BuiltRadial } from '../../../helpers/nexrad-builder.ts';
import { gateValues } from '../../../helpers/radar.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';

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
    for (const [ray, azimuth] of wanted.azimuths)
      expect(sweep.azimuths[ray], `azimuth ${i}, ${ray}`).to.be.closeTo(azimuth, 1e-5);
    expect(sweep.time).to.equal(wanted.time);
    if (wanted.nyquist === null) expect(sweep.nyquist).to.equal(undefined);
    else expect(sweep.nyquist).to.be.closeTo(wanted.nyquist, 1e-6);
    const grids = Object.fromEntries(
      sweep.moments.map((moment) => {
        const { gates, firstGate, gateLength } = sweep.read(moment)!;
        return [moment, [gates, firstGate, gateLength]];
      }),
    );
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
  return Math.max(
    ...positions.map(({ sweep, moment, ray, gate, x, y, z }) => {
      const { elevation, azimuths, read } = radar.sweeps[sweep];
      const { firstGate, gateLength } = read(moment)!;
      const local = beamToLocal(
        { range: firstGate + gate * gateLength, azimuth: azimuths[ray], elevation },
        standardEarthRadius,
      );
      return Math.max(Math.hypot(local[0] - x, local[1] - y), Math.abs(local[2] - z));
    }),
  );
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
    expect(radar.sweeps[0].read('REF')!.samples.slice(0, count)).to.deep.equal(
      whole.sweeps[0].read('REF')!.samples.slice(0, count),
    );
  });

  it('make volumes: of the two scans of the lowest elevation, one is shown', async function () {
    const radar = await readNexrad(new Uint8Array(await fetchSharedData(this, shared[1].path)));
    const volume = buildPolarVolume(radar, { moment: 'VEL' });
    expect(volume.grid.sweeps.length).to.equal(14);
    expect([volume.radar?.left.length, volume.radar?.details.length]).to.deep.equal([0, 2]);
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
    for (const [name, means, step] of [
      ['message-31.ar2v', [0.53, 0.49, -1.25], 1e-6],
      ['message-1.gz', [0.4], 360 / 65536],
    ] as const) {
      const { sweeps } = await readNexrad(await fetchFixture(`nexrad/${name}`));
      means.forEach((mean, i) => {
        const { azimuths, elevations } = sweeps[i];
        expect(elevations).to.have.length(azimuths.length);
        elevations!.forEach((elevation, ray) =>
          expect(elevation, name).to.be.closeTo(mean + 0.02 * Math.cos(ray), step),
        );
      });
    }
  });

  it('gives moments their kinds', async () => {
    const { moments } = await readNexrad(await fetchFixture('nexrad/message-31.ar2v'));
    expect(Object.fromEntries(moments.map(({ name, kind }) => [name, kind]))).to.deep.equal({
      REF: 'reflectivity',
      VEL: 'velocity',
      SW: 'spectrum-width',
      ZDR: 'differential-reflectivity',
      PHI: 'differential-phase',
      RHO: 'correlation',
      CFP: 'other',
    });
  });

  it('packed or not, the same', async () => {
    const [packed, plain] = await Promise.all(
      ['message-31', 'message-31-plain'].map(async (name) => readNexrad(await fetchFixture(`nexrad/${name}.ar2v`))),
    );
    packed.sweeps.forEach((sweep, i) => {
      for (const moment of sweep.moments) expect(plain.sweeps[i].read(moment)).to.deep.equal(sweep.read(moment));
    });
  });
});

describe('NEXRAD Level II files with more than one volume', () => {
  // A volume of the cuts 0.5 and 1.5 degrees, and a whole one of five, each with its header: ../shared/data/reports/14-nexrad-variants, gen.py.
  // Py-ART 2.3.0 on the second one alone (whole.ar2v): 5 sweeps of 360 radials at 0.5, 1.5, 2.401, 3.4 and 4.301 degrees.
  it('give the more complete one, and say what is left', async () => {
    const radar = await readNexrad(await fetchFixture('nexrad/restarted.ar2v'));
    expect(radar.sweeps.map(({ elevation }) => Number(elevation.toFixed(3)))).to.deep.equal([
      0.5, 1.5, 2.401, 3.4, 4.301,
    ]);
    expect(radar.partial).to.equal(undefined);
    expect(radar.left).to.have.length(1);
    expect(radar.left![0]).to.match(
      /^of the 2 volumes .* with 2 sweeps is left out; .* with 5 sweeps, the more complete one, is shown$/,
    );
    expect(buildPolarVolume(radar, {}).radar!.left).to.deep.equal(radar.left);
  });

  it('are found by their radials where there is no second header, and by that header where they are not packed', async () => {
    const volume = (cuts: number): BuiltRadial[] =>
      Array.from({ length: cuts * 36 }, (_, i) => ({
        azimuth: 10 * (i % 36),
        elevation: Math.floor(i / 36),
        cut: 1 + Math.floor(i / 36),
        gates: 8,
        status: i === 0 ? 3 : i === cuts * 36 - 1 ? 4 : 1,
      }));
    const without = await readNexrad(buildNexrad([...volume(1), ...volume(3)]));
    expect([without.sweeps.length, without.left!.length]).to.deep.equal([3, 1]);
    const [first, second] = [buildNexrad(volume(3)), buildNexrad(volume(1))];
    const both = new Uint8Array(first.length + second.length);
    both.set(first);
    both.set(second, first.length);
    const plain = await readNexrad(both);
    expect([plain.sweeps.length, plain.left!.length, plain.partial]).to.deep.equal([3, 1, undefined]);
  });

  it('radials that the radar marks as bad, or did not send, hold nothing', async () => {
    const radials = Array.from({ length: 36 }, (_, i): BuiltRadial => ({
      azimuth: 10 * i,
      elevation: 1,
      cut: 1,
      gates: 8,
      code: 100,
      status: (i === 5 ? 0x80 : 0) + (i === 35 ? 4 : 1),
      blanked: i === 7,
    }));
    const radar = await readNexrad(buildNexrad(radials));
    expect(radar.left).to.deep.equal([
      '2 of 36 radials are left out: the radar marks them as bad, or as not sent (spot blanking)',
    ]);
    const { samples, gates } = radar.sweeps[0].read('REF')!;
    for (let radial = 0; radial < 36; radial++)
      expect(samples[radial * gates], `${radial}`).to.equal(radial === 5 || radial === 7 ? 0 : 100);
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
