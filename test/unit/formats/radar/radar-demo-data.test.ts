import { expect } from '@esm-bundle/chai';
import { readManifest } from '../../../../src/formats/manifest/manifest.ts';
import { readPng } from '../../../../src/formats/images/png.ts';
import { readPolarMosaic } from '../../../../src/formats/radar/polar-mosaic.ts';
import type { RadarFile, RadarSweep } from '../../../../src/formats/radar/radar-file.ts';
import { beamToLocal, standardEarthRadius } from '../../../../src/radar/polar-geometry.ts';
import { fetchFile } from '../../../helpers/decode.ts';
import { gateValues } from '../../../helpers/radar.ts';

async function load(name: string): Promise<RadarFile & { title: string }> {
  const manifest = readManifest(await fetchFile(`/demos/data/${name}.json`));
  const { slope = 1, intercept = 0, unit = '', elevations = [], title = '' } = manifest;
  const image = await readPng(await fetchFile(`/demos/data/${manifest.image}`));
  return { ...readPolarMosaic(image, 'PNG', { ...manifest, elevations, slope, intercept, unit }), title };
}

const clocks = ['1500', '1510', '1520'];
const scans = await Promise.all(clocks.map(async (clock) => load(`storm-radar-${clock}`)));
const velocities = await Promise.all(clocks.map(async (clock) => load(`storm-radar-${clock}-velocity`)));

/** Values of a sweep and where they are, those that are there. */
function* echoes(sweep: RadarSweep, moment: string): Generator<{ value: number; x: number; y: number; z: number }> {
  const data = sweep.read(moment)!;
  const values = gateValues(data);
  for (let ray = 0; ray < sweep.azimuths.length; ray++) {
    for (let gate = 0; gate < data.gates; gate++) {
      const value = values[ray * data.gates + gate];
      if (Number.isNaN(value)) continue;
      const range = data.firstGate + gate * data.gateLength;
      const [x, y, z] = beamToLocal(
        { range, azimuth: sweep.azimuths[ray], elevation: sweep.elevation },
        standardEarthRadius,
      );
      yield { value, x, y, z };
    }
  }
}

const mean = (numbers: readonly number[]): number => numbers.reduce((sum, n) => sum + n, 0) / numbers.length;

describe("the demos' radar scans", () => {
  it("are synthetic and say so; as large as the paper's, ten minutes apart", () => {
    [...scans, ...velocities].forEach((scan, i) => {
      expect(scan.title).to.contain('synthetic');
      expect(scan.site.name).to.contain('synthetic');
      expect(scan.time).to.equal(`2011-06-20T15:${i % 3}0:00Z`);
      expect(scan.sweeps.map(({ azimuths }) => azimuths.length)).to.deep.equal(Array.from({ length: 14 }, () => 360));
      expect(scan.sweeps[13].read(scan.moments[0].name)).to.include({ gates: 400, gateLength: 500, firstGate: 250 });
    });
    expect(scans[0].moments).to.deep.equal([{ name: 'DBZH', unit: 'dBZ', kind: 'reflectivity' }]);
    expect(velocities[0].moments).to.deep.equal([{ name: 'VRADH', unit: 'm/s', kind: 'velocity' }]);
  });

  it('have hail, and no echo below what a radar sees', () => {
    for (const { sweeps } of scans) {
      const all = sweeps.flatMap((sweep) => [...echoes(sweep, 'DBZH')]);
      expect(all.reduce((max, { value }) => Math.max(max, value), -99)).to.be.within(60, 75);
      // A tenth to a quarter of the gates: below the threshold, most hold nothing.
      expect(all.length / (14 * 360 * 400)).to.be.within(0.05, 0.25);
      expect(
        all.filter(({ value, x, y }) => !(value >= -36.5 + 20 * Math.log10(Math.hypot(x, y) / 1000) - 0.1)),
      ).to.deep.equal([]);
    }
  });

  it('move: the strongest echoes go east, 13 m/s', () => {
    const [first, , last] = scans.map(({ sweeps }) =>
      mean([...echoes(sweeps[0], 'DBZH')].filter(({ value, y }) => value > 55 && y < -20_000).map(({ x }) => x)),
    );
    expect((last - first) / 1200).to.be.within(10, 16);
  });

  it('have a bright band where snow melts', () => {
    const rain = scans[0].sweeps
      .slice(3, 9)
      .flatMap((sweep) => [...echoes(sweep, 'DBZH')])
      .filter(({ x, y }) => Math.hypot(x + 66_000, y - 78_000) < 30_000);
    const at = (low: number, high: number): number =>
      mean(rain.filter(({ z }) => z > low && z < high).map(({ value }) => value));
    expect(at(3300, 3900)).to.be.greaterThan(at(2000, 2800) + 2);
    expect(at(3300, 3900)).to.be.greaterThan(at(4700, 5500) + 4);
  });

  it('have velocities that fold at 16 m/s, and a storm that turns', () => {
    for (const { sweeps } of velocities) {
      let folds = 0;
      for (const sweep of sweeps) {
        expect(sweep.nyquist).to.equal(16);
        const values = gateValues(sweep.read('VRADH')!);
        for (let i = 1; i < values.length; i++) if (Math.abs(values[i] - values[i - 1]) > 24) folds++;
        expect(values.filter((value) => Math.abs(value) > 16 + 1e-9)).to.have.length(0);
      }
      expect(folds).to.be.greaterThan(100);
    }
    // Low down, toward and away side by side in the supercell, which the mean wind alone does not make.
    const couplet = [...echoes(velocities[0].sweeps[0], 'VRADH')]
      .filter(({ x, y }) => Math.hypot(x + 28_000, y + 62_500) < 9000)
      .map(({ value }) => value);
    expect(Math.max(...couplet)).to.be.greaterThan(8);
    expect(Math.min(...couplet)).to.be.lessThan(-12);
  });

  it('have velocities that are unfolded: the same except for whole turns', async () => {
    const { moments, sweeps } = await load('storm-radar-1500-unfolded');
    expect(moments).to.deep.equal([{ name: 'VRADDH', unit: 'm/s', kind: 'velocity' }]);
    const unfolded = sweeps.flatMap((sweep) => [...gateValues(sweep.read('VRADDH')!)]);
    const folded = velocities[0].sweeps.flatMap((sweep) => [...gateValues(sweep.read('VRADH')!)]);
    // Half a step of either file.
    const rounding = 0.25 + 0.063 + 1e-9;
    const isSame = (value: number, i: number): boolean =>
      Number.isNaN(value)
        ? Number.isNaN(folded[i])
        : Math.abs((value - folded[i]) / 32 - Math.round((value - folded[i]) / 32)) * 32 <= rounding;
    expect(unfolded.every(isSame)).to.equal(true);
    expect(unfolded.filter((value) => Math.abs(value) > 17).length).to.be.greaterThan(10_000);
    // No gate is far from its neighbour along the beam, as it is at a fold.
    expect(unfolded.filter((value, i) => i % 400 > 0 && Math.abs(value - unfolded[i - 1]) > 24).length).to.be.lessThan(
      20,
    );
  });
});
