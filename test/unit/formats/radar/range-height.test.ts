import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { arrangeRangeHeight } from '../../../../src/formats/radar/range-height.ts';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import { readCfradial2 } from '../../../../src/formats/radar/cfradial2.ts';
import type { Mixing } from '../../../../src/formats/radar/moment-kind.ts';
import type { RadarSweep } from '../../../../src/formats/radar/radar-file.ts';
import { interpolateBeam, nearestGate } from '../../../../src/radar/interpolate-polar.ts';
import { beamToLocal, localToBeam } from '../../../../src/radar/polar-geometry.ts';
import type { PolarVolume } from '../../../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';

const expected = JSON.parse(new TextDecoder().decode(await fetchFixture('range-height.json'))) as {
  readonly source: string;
  readonly gates: readonly [number, number, number, number, number, number, number | null][];
};
const load = async (): Promise<PolarVolume> =>
  (await decodeBytes(await fetchFixture('radar/range-height.nc'), 'range-height.nc')) as PolarVolume;

describe('a file of range-height scans alone', () => {
  it(`has its gates where ${expected.source} has them, with the same values`, async () => {
    const { samples, grid, slope, intercept } = await load();
    let [valid, empty] = [0, 0];
    for (const [sweep, radial, gate, x, y, z, value] of expected.gates) {
      const beam = localToBeam([x, y, z], grid.earthRadius);
      const where = `sweep ${sweep}, radial ${radial}, gate ${gate}`;
      const between = slope * interpolateBeam(samples, grid, beam) + intercept;
      if (value === null) expect(Number.isNaN(between), where).to.equal(true);
      else {
        expect(slope * samples[nearestGate(samples, grid, beam)] + intercept, where).to.be.closeTo(value, 1e-3);
        expect(between, where).to.be.closeTo(value, 0.05);
      }
      if (value === null) empty++;
      else valid++;
    }
    expect([valid, empty]).to.deep.equal([110, 10]);
  });

  it('is as wide as its beam, and no scan reaches another', async () => {
    const { samples, grid } = await load();
    const at = (azimuth: number, elevation = 22): number =>
      interpolateBeam(
        samples,
        grid,
        localToBeam(beamToLocal({ range: 4250, azimuth, elevation }, grid.earthRadius), grid.earthRadius),
      );
    expect(grid.beamWidth).to.be.closeTo(1.2, 1e-6);
    for (const middle of [30, 250]) {
      const isSeen = [-20, -2, -0.7, -0.5, 0.5, 0.7, 2, 20].map((turn) => Number.isFinite(at(middle + turn)));
      expect(isSeen, `${middle} degrees`).to.deep.equal([false, false, false, true, true, false, false, false]);
    }
    expect(Number.isFinite(at(210)), 'beyond the zenith').to.equal(true);
    expect(Number.isNaN(at(0))).to.equal(true);
  });

  it('says how it is drawn, and lists elevations as sweeps', async () => {
    const { radar } = await load();
    expect(radar!.details).to.include('range-height scans: each is drawn as wide as its beam, 1.2°');
    expect(radar!.left).to.deep.equal([]);
    expect(radar!.sweeps[0].elevation).to.be.closeTo(1.5, 1e-5);
    expect(radar!.sweeps.every(({ elevation }, i, all) => i === 0 || elevation > all[i - 1].elevation)).to.equal(true);
  });

  it('is refused where the file has neither, and left out next to sweeps of constant elevation', async () => {
    const bytes = await fetchFixture('radar/range-height.nc');
    const text = new TextDecoder('latin1').decode(bytes);
    for (let at = text.indexOf('rhi\0'); at >= 0; at = text.indexOf('rhi\0', at + 1))
      bytes.set(new TextEncoder().encode('idle'), at);
    const error = await expectError(readCfradial1(bytes));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('range-height');
  });
});

it('CfRadial 2: sweeps that call themselves range-height scans are arranged as such', async () => {
  const bytes = await fetchFixture('radar/cfradial2.nc');
  const text = new TextDecoder('latin1').decode(bytes);
  for (const mode of ['azimuth_surveillance', 'sector'])
    for (let at = text.indexOf(mode); at >= 0; at = text.indexOf(mode, at + 1))
      bytes.set(new TextEncoder().encode('rhi'.padEnd(mode.length, '\0')), at);
  const { sweeps, details } = await readCfradial2(bytes);
  expect(details!.join()).to.contain('range-height scans');
  expect(sweeps.every(({ elevations }) => elevations !== undefined)).to.equal(true);
  const values = sweeps.flatMap((sweep) => [...sweep.read(sweep.moments[0])!.samples]);
  expect(values.filter((value) => value > 0).length).to.be.greaterThan(0);
});

describe('range-height scans', () => {
  const scan = (azimuth: number, elevations: readonly number[], more: Partial<RadarSweep> = {}): RadarSweep => ({
    elevation: azimuth,
    azimuths: new Float64Array(elevations.length).fill(azimuth),
    elevations: Float64Array.from(elevations),
    moments: ['DBZ'],
    gridOf: () => ({ firstGate: 50, gateLength: 100, gates: 2 }),
    read: () => ({
      firstGate: 50,
      gateLength: 100,
      gates: 2,
      samples: Uint8Array.from(elevations.flatMap((elevation) => [elevation, azimuth % 200])),
      slope: 1,
      intercept: 0,
    }),
    ...more,
  });
  const mixings: Readonly<Record<string, Mixing>> = { VEL: 'unless-folded', HCA: 'nearest' };
  const arrange = (...scans: RadarSweep[]) =>
    arrangeRangeHeight(scans, { beamWidth: 1, mixingOf: (name) => mixings[name] ?? 'linear' }, Budget.ofFile(2 ** 22));
  const isData = (sweep: RadarSweep): number[] => [...sweep.read('DBZ')!.samples].filter((value) => value > 0);

  it('on different scales come to one', () => {
    const other = scan(90, [10]);
    const read = (): ReturnType<RadarSweep['read']> => ({ ...other.read('DBZ')!, slope: 2, intercept: -3 });
    const [sweep] = arrange(scan(20, [10]), { ...other, read }).sweeps;
    const { samples, slope, intercept } = sweep.read('DBZ')!;
    const values = [...samples].map((sample) => slope * sample + intercept).filter(Number.isFinite);
    expect(values).to.deep.equal([10, 20, 17, 177]);
  });

  it('fill the sweeps of others with what is between their own radials: linear, but across a fold and of kinds the nearer one', () => {
    const coarse = (moment: string, nyquist: number): number[] => {
      const of = (azimuth: number, elevations: number[], stored: number[]): RadarSweep =>
        scan(azimuth, elevations, {
          moments: [moment],
          nyquist,
          read: () => ({ ...scan(0, elevations).read('')!, samples: Uint8Array.from(stored.flatMap((x) => [x, 0])) }),
        });
      const { sweeps } = arrange(of(20, [10, 14], [100, 140]), of(90, [10, 11, 12, 13, 14], [1, 1, 1, 1, 1]));
      return sweeps.map((sweep) => sweep.read(moment)!.samples[2 * [...sweep.azimuths].indexOf(20)]);
    };
    expect(coarse('DBZ', 30)).to.deep.equal([100, 110, 120, 130, 140]);
    expect(coarse('VEL', 50)).to.deep.equal([100, 110, 120, 130, 140]);
    expect(coarse('VEL', 30)).to.deep.equal([100, 100, 100, 140, 140]);
    expect(coarse('HCA', Infinity)).to.deep.equal([100, 100, 100, 140, 140]);
  });

  it('with gates elsewhere are left out, which is said', () => {
    const { sweeps, left } = arrange(
      scan(20, [10, 20]),
      scan(50, [10], { gridOf: () => ({ firstGate: 60, gateLength: 100, gates: 1 }) }),
      scan(60, [10], { elevations: undefined }),
    );
    expect(sweeps).to.have.length(2);
    expect(left).to.have.length(2);
    expect(left.join()).to.contain('1 range-height scans are left out: they do not say').and.to.contain('other ranges');
  });

  it('nearer than three beams are joined; others are not', () => {
    expect(arrange(scan(20, [10]), scan(22, [10])).sweeps[0].azimuths).to.deep.equal(Float64Array.of(20, 22, 23, 19));
    expect(arrange(scan(20, [10]), scan(25, [10])).sweeps[0].azimuths).to.deep.equal(
      Float64Array.of(20, 21, 24, 25, 26, 19),
    );
  });

  it('read each radial once, whatever their elevations', () => {
    const { sweeps, details } = arrange(
      scan(20, [10, 10.05, 20, 30]),
      scan(90, [11, 19, 33]),
      scan(150, [14.9, 90, 165]),
    );
    const all = sweeps.flatMap((sweep) => isData(sweep)).filter((_, i) => i % 2 === 0);
    all.sort((a, b) => a - b);
    expect(all).to.deep.equal([10, 11, 14, 19, 20, 30, 33, 90, 165]);
    expect(details.join()).to.contain('1 radials are left out');
  });

  it('with thousands of radials have at most 500 elevations', () => {
    const fine = Array.from({ length: 4000 }, (_, i) => (i * 90) / 4000);
    expect(arrange(scan(20, fine)).sweeps.length).to.be.within(200, 500);
  });

  it('of a file made to take long are refused at once', async () => {
    const elevations = Array.from({ length: 450 }, (_, i) => i / 5);
    const many = Array.from({ length: 2000 }, (_, i) => scan(i % 360, elevations));
    const error = await expectError(Promise.resolve().then(() => arrange(...many)));
    expect(error.code).to.equal('format/too-large');
  });

  it('are none without radials of an elevation', () => {
    expect(arrange().sweeps).to.deep.equal([]);
    expect(arrange(scan(20, [NaN, 200])).sweeps).to.deep.equal([]);
  });
});
