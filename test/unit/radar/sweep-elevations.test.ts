import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../src/formats/radar/build-polar-volume.ts';
import { elevationAt, spanOfSweep, sweepsAround } from '../../../src/radar/sweep-elevations.ts';
import { polarScenes, radarVolume, syntheticRadar } from '../../helpers/synthetic-radar.ts';
import type { SweepOptions } from '../../helpers/synthetic-radar.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** A beam so wide that radials a quarter of the circle apart are neighbours. */
const sweepOf = (options: Partial<SweepOptions>, beamWidth = 4) =>
  radarVolume({ sweeps: [{ elevation: 1, ...options }], beamWidth }).grid.sweeps[0];

describe('the elevations of radials', () => {
  it("are kept where they are not the sweep's, and left out where they are", () => {
    expect(sweepOf({}).elevations).to.equal(undefined);
    expect(sweepOf({ rayElevation: () => 1.0009 }).elevations).to.equal(undefined);
    const own = sweepOf({ azimuths: [200, 290, 20, 110], rayElevation: (azimuth) => 1 + azimuth / 1000 });
    expect(Array.from(own.elevations!, (e) => Number(e.toFixed(6)))).to.deep.equal([1.02, 1.11, 1.2, 1.29]);
  });

  it('stay with their radials where some are scanned again, missing or not numbers', () => {
    const azimuths = Array.from({ length: 36 }, (_, i) => 10 * i + 5).filter((azimuth) => azimuth !== 45);
    const { azimuths: sorted, elevations } = sweepOf({
      azimuths: [...azimuths, 5.5],
      rayElevation: (azimuth) => (azimuth === 105 ? NaN : 1 + azimuth / 1000),
    });
    sorted.forEach((azimuth, ray) => {
      // 5.5 came after 5; what is missing at 45 has the mean of its neighbours; 105 has the sweep's.
      expect(elevations![ray]).to.be.closeTo(azimuth === 105 ? 1 : 1 + azimuth / 1000, 1e-9);
    });
    expect([sorted[0], sorted[4]]).to.deep.equal([5.5, 45]);
  });

  it('hold on beyond the ends of a sector', () => {
    const { azimuths, elevations } = sweepOf({ azimuths: [100, 101, 102], rayElevation: (azimuth) => azimuth / 100 });
    expect([...azimuths]).to.deep.equal([99, 100, 101, 102, 103]);
    expect([...elevations!]).to.deep.equal([1, 1, 1.01, 1.02, 1.02]);
  });

  it("go no farther than the next sweep's, and as far as they like beyond the outermost", () => {
    const wild = { rayElevation: (azimuth: number) => (azimuth < 180 ? -30 : 60) };
    const { sweeps } = buildPolarVolume(
      syntheticRadar({
        sweeps: [
          { elevation: 1, ...wild },
          { elevation: 3, ...wild },
          { elevation: 7, ...wild },
        ],
      }),
      {},
    ).grid;
    expect(sweeps.map(spanOfSweep)).to.deep.equal([
      [-30, 3],
      [1, 7],
      [3, 60],
    ]);
  });

  it('are linear from radial to radial, across north too', () => {
    const sweep = sweepOf({ azimuths: [10, 100, 190, 280], rayElevation: (_azimuth, ray) => [1, 2, 4, 5][ray] });
    for (const [azimuth, elevation] of [
      [10, 1],
      [55, 1.5],
      [100, 2],
      [145, 3],
      [280, 5],
      [325, 3],
      [0, 1 + 4 / 9],
    ]) {
      expect(elevationAt(sweep, azimuth)).to.be.closeTo(elevation, 1e-12);
    }
    expect(elevationAt(sweepOf({}), 77)).to.equal(1);
  });

  it('of only a few sweeps can be next to a point, and these are found', () => {
    const random = randomNumbers(66);
    for (const name of ['rays of their own elevations', 'sweeps that cross', 'sixty sweeps', 'one sweep']) {
      const { sweeps } = radarVolume(polarScenes[name]).grid;
      const spans = sweeps.map(spanOfSweep);
      for (let i = 0; i < 3000; i++) {
        const azimuth = 360 * random();
        const elevation = -1 + 14 * random();
        const from = elevation - 0.3 * random();
        const [first, last] = sweepsAround(sweeps, spans, [from, elevation + 0.3 * random()]);
        expect(last - first, name).to.be.below(8);
        const all = sweeps.map((sweep) => elevationAt(sweep, azimuth));
        const below = Math.max(...all.filter((one) => one <= elevation));
        const above = Math.min(...all.filter((one) => one > elevation));
        const near = all.slice(first, last + 1);
        if (Number.isFinite(below)) expect(near, name).to.include(below);
        if (Number.isFinite(above)) expect(near, name).to.include(above);
      }
    }
  });
});
