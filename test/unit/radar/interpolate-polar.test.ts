import { expect } from '@esm-bundle/chai';
import {
  interpolateBeam,
  interpolatePolar,
  interpolateSweep,
  nearestGate,
  polarSampler,
} from '../../../src/radar/interpolate-polar.ts';
import { polarField } from '../../../src/radar/polar-field.ts';
import { beamToLocal } from '../../../src/radar/polar-geometry.ts';
import type { PolarVolume } from '../../../src/volume/volume.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';
import { evenAzimuths, polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';
import type { RadarOptions, SweepOptions } from '../../helpers/synthetic-radar.ts';

/** Stored value at a point, from the radar's geometry. */
function at(volume: PolarVolume, range: number, azimuth: number, elevation: number): number {
  const { samples, grid } = volume;
  return interpolatePolar(samples, grid, beamToLocal({ range, azimuth, elevation }, grid.earthRadius));
}

/** Gates of 1 km from 500 m on, 24 radials: the number says where it is. */
const place = (azimuth: number, gate: number): number => gate + 1 + azimuth;
const floats = (sweep: SweepOptions): SweepOptions => ({
  kind: 'float32',
  slope: 1,
  intercept: 0,
  stored: place,
  ...sweep,
});
const two: RadarOptions = {
  sweeps: [floats({ elevation: 1 }), floats({ elevation: 3, stored: (a, g) => place(a, g) + 10 })],
};

describe('interpolation on a polar grid', () => {
  it('gives each gate its own value', () => {
    for (const name of [
      'five sweeps',
      'rays and gates that differ',
      'uneven azimuths',
      'sixty sweeps',
      'to the poles',
    ]) {
      const volume = radarVolume(polarScenes[name]);
      for (const { elevation, azimuths, firstGate, gateLength, gates, offset } of volume.grid.sweeps) {
        if (Math.abs(elevation) === 90) continue;
        azimuths.forEach((azimuth, ray) => {
          for (const gate of [0, 3, gates - 1]) {
            const expected = volume.samples[offset + ray * gates + gate];
            // A hair off: on the gate itself rounding may choose either neighbour, which changes nothing.
            expect(at(volume, firstGate + gate * gateLength, azimuth, elevation), name).to.be.closeTo(expected, 1e-5);
          }
        });
      }
    }
  });

  it('gives the gates of radials with their own elevations their own values, at these elevations', () => {
    const volume = radarVolume(polarScenes['rays of their own elevations']);
    let off = 0;
    for (const { elevation, elevations, azimuths, firstGate, gateLength, gates, offset } of volume.grid.sweeps) {
      azimuths.forEach((azimuth, ray) => {
        off = Math.max(off, Math.abs(elevations![ray] - elevation));
        for (const gate of [0, 3, gates - 1]) {
          const got = at(volume, firstGate + gate * gateLength, azimuth, elevations![ray]);
          expect(got).to.be.closeTo(volume.samples[offset + ray * gates + gate], 1e-4);
        }
      });
    }
    expect(off).to.be.above(0.39);
  });

  it('is linear between the elevations that two sweeps have at an azimuth, and reaches half a beam beyond', () => {
    // Radials 15 degrees apart, from 7.5 on: the lower sweep rises from 1 to 1.4 between 67.5 and 82.5 degrees.
    const lower = floats({
      elevation: 1,
      stored: () => 10,
      rayElevation: (azimuth) => (azimuth > 75 && azimuth < 90 ? 1.4 : 1),
    });
    const volume = radarVolume({ sweeps: [lower, floats({ elevation: 3, stored: () => 20 })], beamWidth: 1 });
    expect(at(volume, 5500, 67.5, 2)).to.be.closeTo(15, 1e-6);
    expect(at(volume, 5500, 82.5, 2.2)).to.be.closeTo(15, 1e-6);
    expect(at(volume, 5500, 75, 1.2)).to.be.closeTo(10, 1e-6);
    expect(at(volume, 5500, 75, 2.1)).to.be.closeTo(15, 1e-6);
    expect(at(volume, 5500, 75, 0.7 + 1e-6)).to.be.closeTo(10, 1e-6);
    expect(at(volume, 5500, 75, 0.7 - 1e-6)).to.deep.equal(NaN);
    expect(at(volume, 5500, 67.5, 0.5 + 1e-6)).to.be.closeTo(10, 1e-6);
    expect(at(volume, 5500, 67.5, 3.5 + 1e-6)).to.deep.equal(NaN);
  });

  it('takes the nearest sweeps where two cross', () => {
    // Between 67.5 and 82.5 degrees the first sweep is above the second one.
    const crossing =
      (inside: number, elsewhere: number) =>
      (azimuth: number): number =>
        azimuth > 60 && azimuth < 90 ? inside : elsewhere;
    const volume = radarVolume({
      sweeps: [
        floats({ elevation: 1, stored: () => 10, rayElevation: crossing(1.8, 1) }),
        floats({ elevation: 2, stored: () => 20, rayElevation: crossing(1.2, 2) }),
        floats({ elevation: 4, stored: () => 40 }),
      ],
      beamWidth: 1,
    });
    expect(at(volume, 5500, 75, 1.2)).to.be.closeTo(20, 1e-6);
    expect(at(volume, 5500, 75, 1.5)).to.be.closeTo(15, 1e-6);
    expect(at(volume, 5500, 75, 1.8)).to.be.closeTo(10, 1e-6);
    expect(at(volume, 5500, 75, 2.9)).to.be.closeTo(25, 1e-6);
    expect(at(volume, 5500, 75, 0.8)).to.be.closeTo(20, 1e-6);
    expect(at(volume, 5500, 200, 1.5)).to.be.closeTo(15, 1e-6);
  });

  it('is linear in range, in azimuth and in elevation', () => {
    const volume = radarVolume(two);
    expect(at(volume, 5500, 67.5, 1)).to.be.closeTo(6 + 67.5, 1e-6);
    expect(at(volume, 5750, 67.5, 1)).to.be.closeTo(6.25 + 67.5, 1e-6);
    expect(at(volume, 5500, 70, 1)).to.be.closeTo(6 + 70, 1e-6);
    expect(at(volume, 5500, 67.5, 1.5)).to.be.closeTo(6 + 67.5 + 2.5, 1e-6);
    expect(at(volume, 5750, 70, 2.5)).to.be.closeTo(6.25 + 70 + 7.5, 1e-6);
  });

  it('goes on across north', () => {
    const volume = radarVolume({ sweeps: [floats({ elevation: 1, stored: (a) => (a < 180 ? a : a - 360) })] });
    for (const azimuth of [352.5, 356, 359.999, 0, 0.001, 4, 7.5]) {
      expect(at(volume, 5500, azimuth, 1)).to.be.closeTo(azimuth < 180 ? azimuth : azimuth - 360, 1e-6);
    }
  });

  it('holds the outermost values for half a gate, and ends there', () => {
    const volume = radarVolume(two);
    const last = place(67.5, 19);
    expect(at(volume, 19500, 67.5, 1)).to.be.closeTo(last, 1e-6);
    expect(at(volume, 19999, 67.5, 1)).to.be.closeTo(last, 1e-6);
    expect(at(volume, 20001, 67.5, 1)).to.deep.equal(NaN);
    expect(at(volume, 1, 67.5, 1)).to.be.closeTo(place(67.5, 0), 1e-6);
    const far = radarVolume({ sweeps: [floats({ elevation: 1, firstGate: 3000 })] });
    expect(at(far, 2501, 67.5, 1)).to.be.closeTo(place(67.5, 0), 1e-6);
    expect(at(far, 2499, 67.5, 1)).to.deep.equal(NaN);
  });

  it('reaches half a beam below the lowest and above the highest sweep, and no further', () => {
    for (const beamWidth of [0.5, 1]) {
      const volume = radarVolume({ ...two, beamWidth });
      const half = beamWidth / 2;
      expect(at(volume, 5500, 67.5, 1 - half + 1e-6)).to.be.closeTo(73.5, 1e-6);
      expect(at(volume, 5500, 67.5, 1 - half - 1e-6)).to.deep.equal(NaN);
      expect(at(volume, 5500, 67.5, 3 + half - 1e-6)).to.be.closeTo(83.5, 1e-6);
      expect(at(volume, 5500, 67.5, 3 + half + 1e-6)).to.deep.equal(NaN);
      expect(at(volume, 5500, 67.5, 45), 'cone of silence').to.deep.equal(NaN);
    }
  });

  it('is defined at the antenna, on its axis and at the poles', () => {
    const sampler = (options: RadarOptions): ((local: [number, number, number]) => number) => {
      const { samples, grid } = radarVolume(options);
      return (local) => interpolatePolar(samples, grid, local);
    };
    const flat = sampler({ sweeps: [floats({ elevation: 0 })] });
    // Half way between the radials at 352.5 and 7.5 degrees.
    expect(flat([0, 0, 0])).to.be.closeTo((place(352.5, 0) + place(7.5, 0)) / 2, 1e-6);
    const steep = sampler({ sweeps: [floats({ elevation: 45 }), floats({ elevation: 90 })] });
    expect(steep([0, 0, 5500])).to.be.closeTo((place(352.5, 5) + place(7.5, 5)) / 2, 1e-6);
    expect(steep([0, 0, 20001])).to.deep.equal(NaN);
    expect(sampler(two)([0, 0, 5500]), 'cone of silence').to.deep.equal(NaN);
    const down = sampler({ sweeps: [floats({ elevation: -90 }), floats({ elevation: 0 })] });
    expect(down([0, 0, -5500])).to.be.closeTo((place(352.5, 5) + place(7.5, 5)) / 2, 1e-6);
  });

  it('lets no-data gates bleed into nothing: they leave the value of the valid ones, up to half way', () => {
    const stored = (_a: number, gate: number): number => (gate < 10 ? 100 : 0);
    for (const kind of ['uint8', 'uint16', 'float32'] as const) {
      const volume = radarVolume({
        sweeps: [{ elevation: 1, kind, stored: (a, g) => (kind === 'float32' ? stored(a, g) || NaN : stored(a, g)) }],
      });
      expect(at(volume, 9500, 67.5, 1)).to.equal(100);
      expect(at(volume, 9999, 67.5, 1)).to.equal(100);
      expect(at(volume, 10001, 67.5, 1)).to.deep.equal(NaN);
    }
  });

  it('lets a sweep that reaches farther stand alone where the other has ended, up to half way', () => {
    const volume = radarVolume({ sweeps: [floats({ elevation: 1, gates: 40 }), floats({ elevation: 3 })] });
    expect(at(volume, 30500, 67.5, 1.99)).to.be.closeTo(place(67.5, 30), 1e-6);
    expect(at(volume, 30500, 67.5, 2.01)).to.deep.equal(NaN);
  });

  describe('across gaps between sweeps', () => {
    /** As ../shared/data/reports/12-odim-variants/birdbath.h5: 33 dBZ from 2.75 to 10 km in the sweep that looks straight up, alone. */
    const birdbath = (beamWidth?: number, own = 0): PolarVolume =>
      radarVolume({
        sweeps: [1.5, 12, 25, 90].map((elevation) =>
          floats({
            elevation,
            gateLength: 250,
            firstGate: 125,
            gates: 100,
            azimuths: evenAzimuths(360),
            stored: (_azimuth, gate) => (elevation === 90 && gate > 10 && gate < 40 ? 33 : NaN),
            ...(own ? { rayElevation: (azimuth: number) => elevation - own * (azimuth % 2) } : {}),
          }),
        ),
        ...(beamWidth === undefined ? {} : { beamWidth }),
      });

    for (const own of [0, 0.1]) {
      it(`a vertical beam stays one, half a beam to each side${own ? ', where radials have elevations of their own' : ''}`, () => {
        // Py-ART 2.3.0, grid_from_radars with cells of 250 m at 6.5 km: 33 dBZ in one column of cells. Before, it reached down to 57.5 degrees: 4 km.
        const volume = birdbath(1, own);
        for (const azimuth of [0.5, 77, 300.5]) {
          expect(at(volume, 6500, azimuth, 89.6 - own)).to.equal(33);
          for (const elevation of [89.4 - own, 80, 60, 57.6, 40, 26])
            expect(at(volume, 6500, azimuth, elevation), `${elevation}`).to.deep.equal(NaN);
        }
      });
    }

    it('are bridged up to 25 beam widths', () => {
      expect(at(birdbath(2.7), 6500, 77, 60)).to.equal(33);
      expect(at(birdbath(2.5), 6500, 77, 60)).to.deep.equal(NaN);
      // Sweden's and Finland's highest sweeps, with their beams: 24 to 40 and 25 to 45.
      for (const [low, high, beamWidth] of [
        [24, 40, 0.9],
        [25, 45, 0.95],
        [14.6, 19.5, 0.95],
        [23.9, 32, 2],
      ]) {
        const volume = radarVolume({
          sweeps: [floats({ elevation: low, stored: () => 10 }), floats({ elevation: high, stored: () => 20 })],
          beamWidth,
        });
        expect(at(volume, 5500, 67.5, (low + high) / 2), `${low} to ${high}`).to.be.closeTo(15, 1e-6);
      }
      // A narrow beam, as a lidar's, is not cut into sheets.
      const narrow = radarVolume({
        sweeps: [floats({ elevation: 5, stored: () => 10 }), floats({ elevation: 9, stored: () => 20 })],
        beamWidth: 0.05,
      });
      expect(at(narrow, 5500, 67.5, 7)).to.be.closeTo(15, 1e-6);
    });

    it('hold no data for pictures, cells and the box either', () => {
      const volume = birdbath(1);
      const { low, high } = volume.macrocells;
      const filled = low.filter((value, i) => value <= high[i]).length;
      // A column of cells over the antenna: no wider than two cells to each side.
      expect(filled).to.be.within(1, 16 * volume.macrocells.dimensions[2]);
      // The box without the sweep that looks up is as wide.
      const without = radarVolume({
        sweeps: [1.5, 12, 25].map((elevation) =>
          floats({ elevation, gateLength: 250, firstGate: 125, gates: 100, azimuths: evenAzimuths(360) }),
        ),
        beamWidth: 1,
      });
      expect(volume.grid.box.high[0]).to.be.closeTo(without.grid.box.high[0], 1e-6);
      // The last gate with data, and one more, as for all sweeps.
      expect(volume.grid.box.high[2]).to.be.closeTo(10_250, 1e-6);
    });
  });

  it('takes a sweep with different radials and gates by its own', () => {
    const volume = radarVolume({
      sweeps: [
        floats({ elevation: 1 }),
        floats({
          elevation: 3,
          azimuths: evenAzimuths(15),
          gateLength: 700,
          firstGate: 900,
          gates: 30,
          stored: (a, g) => a + (900 + 700 * g + 500) / 1000,
        }),
      ],
    });
    // Both hold azimuth + range in km + 0.5.
    expect(at(volume, 8000, 100, 1.7)).to.be.closeTo(100 + 8.5, 1e-4);
    expect(at(volume, 12345, 222, 2.6)).to.be.closeTo(222 + 12.845, 1e-4);
  });

  it('ends half a radial beyond the edges of a sector and next to missing radials', () => {
    const sector = radarVolume({ sweeps: [floats({ elevation: 1, azimuths: [359.5, 0, 0.5], stored: () => 7 })] });
    expect(at(sector, 5500, 359.26, 1)).to.equal(7);
    expect(at(sector, 5500, 359.24, 1)).to.deep.equal(NaN);
    expect(at(sector, 5500, 0.74, 1)).to.equal(7);
    expect(at(sector, 5500, 0.76, 1)).to.deep.equal(NaN);
    expect(at(sector, 5500, 180, 1)).to.deep.equal(NaN);
    const missing = radarVolume({
      sweeps: [floats({ elevation: 1, azimuths: evenAzimuths(24).filter((a) => a !== 67.5), stored: () => 7 })],
    });
    expect(at(missing, 5500, 59.9, 1)).to.equal(7);
    expect(at(missing, 5500, 60.1, 1)).to.deep.equal(NaN);
    expect(at(missing, 5500, 74.9, 1)).to.deep.equal(NaN);
    expect(at(missing, 5500, 75.1, 1)).to.equal(7);
  });

  it('takes kinds of echo from the nearest gate with data, exactly', () => {
    const volume = radarVolume(polarScenes['kinds of echo']);
    const { samples, grid } = volume;
    const random = randomNumbers(7);
    const kinds = new Set<number>();
    for (let i = 0; i < 4000; i++) {
      const beam = { range: 500 + 20_000 * random(), azimuth: 360 * random(), elevation: 12 * random() };
      const [value, nearest] = [interpolateBeam(samples, grid, beam), nearestGate(samples, grid, beam)];
      if (Number.isNaN(value)) continue;
      kinds.add(value);
      expect(value).to.equal(samples[nearest]);
    }
    expect(kinds.size).to.be.above(6);
    // Of 10 and 140, 1.2 km from one and 0.8 km from the other, on a cone of one sweep too.
    const two = radarVolume({
      sweeps: [{ elevation: 1, gateLength: 2000, firstGate: 1000, stored: (_a, gate) => (gate < 3 ? 10 : 140) }],
      moments: [['HCA', 'kinds']],
    });
    for (const [range, kind] of [
      [5900, 10],
      [6200, 140],
    ]) {
      expect(at(two, range, 40, 1)).to.equal(kind);
      expect(interpolateSweep(two.samples, two.grid, 0, { range, azimuth: 40, elevation: 1 })).to.equal(kind);
    }
    const field = polarField(two);
    expect([field.isFolded(10, 140), field.isFolded(10, 20)]).to.deep.equal([true, true]);
  });

  it('averages no velocities across a fold', () => {
    // Steps of 0.5 m/s; 20 m/s are 40 steps: 10 and 240 are on two sides.
    const stored = (azimuth: number, gate: number): number => (gate < 5 ? 120 : azimuth < 180 ? 10 : 240);
    const sweeps: SweepOptions[] = [{ elevation: 1, nyquist: 20, stored }];
    const folding = radarVolume({ sweeps, moments: [['VRAD', 'velocity']] });
    const smooth = radarVolume({ sweeps });
    expect(at(smooth, 8500, 179, 1)).to.be.within(11, 239);
    expect(at(folding, 8500, 179, 1)).to.equal(10);
    expect(at(folding, 8500, 181, 1)).to.equal(240);
    expect(at(folding, 2500, 180, 1)).to.equal(120);
    // A fold outside of what is around a point does not matter: 10 alone.
    expect(at(folding, 8500, 90, 1)).to.equal(10);
    // Below the lowest sweep the one above it has no weight.
    const tall = radarVolume({
      sweeps: [
        { elevation: 1, nyquist: 20, stored: (_a, gate) => 100 + gate },
        { elevation: 3, nyquist: 20, stored: () => 255 },
      ],
      moments: [['VRAD', 'velocity']],
    });
    expect(at(tall, 5750, 67.5, 0.8)).to.be.closeTo(105.25, 1e-6);
  });

  it('of a constant field is that constant wherever there are data', () => {
    const random = randomNumbers(80);
    for (const [name, { sweeps, ...rest }] of Object.entries(polarScenes)) {
      const volume = radarVolume({
        ...rest,
        sweeps: sweeps.map((sweep) => ({
          ...sweep,
          stored: (a, g, r) =>
            sweep.stored && !(sweep.stored(a, g, r) > 0) ? (sweep.kind === 'float32' ? NaN : 0) : 77,
        })),
      });
      const valueAt = polarSampler(volume);
      let found = 0;
      for (let i = 0; i < 5000; i++) {
        const value = valueAt([random(), random(), random()]);
        if (Number.isNaN(value)) continue;
        found++;
        expect(value, name).to.equal(77);
      }
      expect(found, name).to.be.above(5);
    }
  });
});
