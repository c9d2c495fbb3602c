import { expect } from '@esm-bundle/chai';
import { arrangeRadials } from '../../../../src/formats/radar/arrange-radials.ts';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { boxIndexToWorld, standardEarthRadius } from '../../../../src/radar/polar-geometry.ts';
import { evenAzimuths, radarVolume, syntheticRadar } from '../../../helpers/synthetic-radar.ts';

const list = (numbers: ArrayLike<number>): number[] => Array.from(numbers, (x) => Number(x.toFixed(6)));

describe('the radials of a sweep', () => {
  it('are sorted, wherever the antenna began', () => {
    const { azimuths, radials } = arrangeRadials([200, 290, 20, 110], 4);
    expect(list(azimuths)).to.deep.equal([20, 110, 200, 290]);
    expect([...radials]).to.deep.equal([2, 3, 0, 1]);
  });

  it('scanned again count as the last time', () => {
    const around = evenAzimuths(36);
    const { azimuths, radials } = arrangeRadials([...around, 5.5, 15.2], 1);
    expect(azimuths).to.have.length(36);
    expect(radials[0]).to.equal(36);
    expect(radials[1]).to.equal(37);
    // Across north, too: 359.7 (the 35th of them), 359.9 and 0.1.
    const seam = arrangeRadials([0.1, ...evenAzimuths(35, 10), 359.9], 1);
    expect(seam.radials).to.have.length(35);
    expect(seam.radials.at(-1)).to.equal(36);
    expect([...seam.radials]).not.to.include(0);
  });

  it('stand alone where they are farther apart than 25 beams, as none sees what is between them', () => {
    const { azimuths, radials } = arrangeRadials([0, 30, 60, 180], 1);
    expect(list(azimuths)).to.deep.equal([0, 1, 29, 30, 31, 59, 60, 61, 179, 180, 181, 359]);
    expect([...radials]).to.deep.equal([0, -1, -1, 1, -1, -1, 2, -1, -1, 3, -1, -1]);
  });

  it('have one without data where one is missing', () => {
    const { azimuths, radials } = arrangeRadials(
      evenAzimuths(36).filter((a) => a !== 45),
      1,
    );
    expect(azimuths).to.have.length(36);
    expect(azimuths[4]).to.be.closeTo(45, 1e-9);
    expect(radials[4]).to.equal(-1);
  });

  it('of a sector have one without data at each end, across north too', () => {
    const { azimuths, radials } = arrangeRadials([359.5, 0, 0.5], 1);
    expect(list(azimuths)).to.deep.equal([0, 0.5, 1, 359, 359.5]);
    expect([...radials]).to.deep.equal([1, 2, -1, -1, 0]);
  });

  it('that stand alone are as wide as the beam', () => {
    const { azimuths, radials } = arrangeRadials([0], 1.5);
    expect(list(azimuths)).to.deep.equal([0, 1.5, 358.5]);
    expect([...radials]).to.deep.equal([0, -1, -1]);
  });

  it('stay as they are where they are uneven, and azimuths of no number are left out', () => {
    const uneven = [0.1, 10.9, 19.8, 31, 39.5];
    expect(list(arrangeRadials([...uneven, NaN, Infinity], 1).azimuths.slice(0, 5))).to.deep.equal(uneven);
    expect(arrangeRadials([NaN], 1).azimuths).to.have.length(0);
    expect(list(arrangeRadials([-10, 370, 720.5, -1e-15], 1).azimuths).every((a) => a >= 0 && a < 360)).to.equal(true);
  });
});

describe('a radar file as a volume', () => {
  it('holds every gate once, where its sweep says', () => {
    const stored = (azimuth: number, gate: number): number => ((Math.round(azimuth) * 3 + gate) % 251) + 1;
    const volume = radarVolume({
      sweeps: [
        { elevation: 4, stored, gates: 7 },
        { elevation: 0.5, stored, azimuths: evenAzimuths(36).map((a) => 360 - a), gates: 11 },
      ],
    });
    const [low, high] = volume.grid.sweeps;
    expect([low.elevation, high.elevation]).to.deep.equal([0.5, 4]);
    expect([low.offset, high.offset]).to.deep.equal([0, 36 * 11]);
    expect(volume.samples).to.have.length(36 * 11 + 24 * 7);
    for (const { azimuths, gates, offset } of [low, high]) {
      azimuths.forEach((azimuth, ray) => {
        for (let gate = 0; gate < gates; gate++) {
          expect(volume.samples[offset + ray * gates + gate]).to.equal(stored(azimuth, gate));
        }
      });
    }
  });

  it('says what it is', () => {
    const volume = radarVolume({
      sweeps: [{ elevation: 1 }],
      moments: [
        ['TH', 'other'],
        ['DBZH', 'reflectivity'],
        ['VRADH', 'velocity'],
      ],
    });
    expect(volume.radar).to.deep.equal({
      moment: 'DBZH',
      moments: ['TH', 'DBZH', 'VRADH'],
      site: { name: 'here', latitude: 50, longitude: 6, height: 100 },
      time: '2020-02-07T13:00:00Z',
      sweeps: [{ elevation: 1, radials: 24, gates: 20, firstGate: 500, gateLength: 1000 }],
      left: [],
      details: [],
    });
    expect([volume.unit, volume.format, volume.slope, volume.intercept]).to.deep.equal([
      'dBZ',
      'synthetic radar',
      0.5,
      -32,
    ]);
    expect(volume.hasNoData).to.equal(true);
  });

  it('counts no-data gates in neither range nor histogram', () => {
    const volume = radarVolume({ sweeps: [{ elevation: 1, stored: (_a, gate) => (gate % 2 === 0 ? 0 : 100 + gate) }] });
    expect(volume.range).to.deep.equal([0.5 * 101 - 32, 0.5 * 119 - 32]);
    expect(volume.histogram.counts.reduce((a, b) => a + b)).to.equal(24 * 10);
  });

  it('takes the moment that is asked for, or says which there are', () => {
    const radar = syntheticRadar({
      sweeps: [{ elevation: 1 }],
      moments: [
        ['DBZH', 'reflectivity'],
        ['VRADH', 'velocity'],
      ],
    });
    expect(buildPolarVolume(radar, { moment: 'VRADH' }).unit).to.equal('m/s');
    expect(() => buildPolarVolume(radar, { moment: 'ZDR' }))
      .to.throw(VolumeViewError, 'moment got "ZDR"; expected one that the file holds: DBZH, VRADH')
      .with.property('code', 'attribute/invalid');
    const empty = syntheticRadar({ sweeps: [{ elevation: 1, moments: [] }] });
    expect(() => buildPolarVolume(empty, {}))
      .to.throw(VolumeViewError, 'none of its 1 sweeps')
      .with.property('code', 'format/unsupported');
    expect(() => buildPolarVolume({ ...empty, moments: [] }, {}))
      .to.throw(VolumeViewError, 'no quantity')
      .with.property('code', 'format/unsupported');
  });

  it('keeps of sweeps at one elevation the one that holds the moment and reaches farthest', () => {
    const { grid, radar } = radarVolume({
      sweeps: [
        { elevation: 0.48, gates: 30 },
        { elevation: 0.5, gates: 10 },
        { elevation: 0.52, gates: 90, moments: ['VRADH'] },
        { elevation: 0.9, gates: 30 },
        { elevation: 0.9, gates: 30, azimuths: evenAzimuths(36) },
        { elevation: 0.9, gates: 30, azimuths: evenAzimuths(36) },
      ],
      moments: [
        ['DBZH', 'reflectivity'],
        ['VRADH', 'velocity'],
      ],
    });
    expect(grid.sweeps.map(({ elevation, gates, azimuths }) => [elevation, gates, azimuths.length])).to.deep.equal([
      [0.48, 30, 24],
      [0.9, 30, 36],
    ]);
    expect(radar!.details).to.deep.equal([
      'sweep 6 at 0.9° is left out for sweep 5 at 0.9°',
      'sweep 4 at 0.9° is left out for sweep 5 at 0.9°',
      'sweep 2 at 0.5° is left out for sweep 1 at 0.48°',
      'sweep 3 at 0.52° holds no DBZH',
    ]);
    expect(radar!.left, 'the same air is shown').to.deep.equal([]);
  });

  it('takes a sweep with data for one that was filled with nothing', () => {
    const sweeps = [
      { elevation: 0.5, gates: 90, stored: () => 0 },
      { elevation: 0.5, gates: 30 },
      { elevation: 3, stored: () => 0 },
    ];
    const { grid, radar } = radarVolume({ sweeps });
    expect(grid.sweeps.map(({ elevation, gates }) => [elevation, gates])).to.deep.equal([
      [0.5, 30],
      [3, 20],
    ]);
    expect(radar!.details).to.deep.equal(['sweep 1 at 0.5° is left out for sweep 2 at 0.5°']);
  });

  it('keeps sweeps of a narrow beam apart that a wide one would merge', () => {
    const sweeps = [{ elevation: 0.5 }, { elevation: 0.6 }];
    expect(radarVolume({ sweeps, beamWidth: 0.3 }).grid.sweeps).to.have.length(2);
    expect(radarVolume({ sweeps, beamWidth: 1 }).grid.sweeps).to.have.length(1);
  });

  it('brings sweeps of several types to one', () => {
    const of = (...kinds: ('uint8' | 'uint16' | 'float32')[]): ReturnType<typeof radarVolume> =>
      radarVolume({
        sweeps: kinds.map((kind, i) => ({
          elevation: 1 + i,
          kind,
          stored: (_a, gate) => (gate === 0 ? (kind === 'float32' ? NaN : 0) : gate),
        })),
      });
    const values = [0, 1, 2, 3];
    for (const [volume, type, empty] of [
      [of('uint8', 'uint8'), Uint8Array, 0],
      [of('uint8', 'uint16'), Uint16Array, 0],
      [of('uint16', 'float32'), Float32Array, NaN],
    ] as const) {
      expect(volume.samples).to.be.instanceOf(type);
      expect([volume.slope, volume.intercept]).to.deep.equal([0.5, -32]);
      for (const { offset } of volume.grid.sweeps) {
        values.forEach((value, gate) =>
          expect(volume.samples[offset + gate]).to.deep.equal(gate === 0 ? empty : value),
        );
      }
    }
  });

  it('brings sweeps of several scales to data values', () => {
    const volume = radarVolume({
      sweeps: [
        { elevation: 1, slope: 0.5, intercept: -32 },
        { elevation: 2, slope: 1, intercept: -20 },
      ].map((sweep) => ({ ...sweep, stored: (_a: number, gate: number) => gate })),
    });
    expect([volume.slope, volume.intercept]).to.deep.equal([1, 0]);
    const [low, high] = volume.grid.sweeps;
    expect(Array.from(volume.samples.slice(low.offset, low.offset + 3))).to.deep.equal([NaN, -31.5, -31]);
    expect(Array.from(volume.samples.slice(high.offset, high.offset + 3))).to.deep.equal([NaN, -19, -18]);
  });

  it('folds velocities only, from the smallest Nyquist velocity on', () => {
    const sweeps = [
      { elevation: 1, nyquist: 26.3 },
      { elevation: 2, nyquist: 8.3 },
    ];
    const fold = (kind: 'velocity' | 'reflectivity', sweepKind: 'uint8' | 'float32' = 'uint8'): number | undefined =>
      radarVolume({ sweeps: sweeps.map((sweep) => ({ ...sweep, kind: sweepKind })), moments: [['V', kind]] }).grid
        .foldFrom;
    // 8.3 m/s are 16.6 stored steps of 0.5 m/s.
    expect(fold('velocity')).to.equal(16.5);
    expect(fold('velocity', 'float32')).to.be.closeTo(16.6, 1e-12);
    expect(fold('reflectivity')).to.equal(undefined);
    expect(radarVolume({ sweeps: [{ elevation: 1 }], moments: [['V', 'velocity']] }).grid.foldFrom).to.equal(undefined);
  });

  it('does not fold velocities that have been unfolded', () => {
    const fold = (name: string): number | undefined =>
      radarVolume({ sweeps: [{ elevation: 1, nyquist: 8.3 }], moments: [[name, 'velocity']] }).grid.foldFrom;
    for (const name of ['VRADDH', 'VRADDV', 'corrected_velocity', 'dealiased_velocity', 'velocity_unfolded'])
      expect(fold(name), name).to.equal(undefined);
    for (const name of ['VRADH', 'VRADV', 'VRAD', 'UVRADH', 'VEL', 'velocity']) expect(fold(name), name).to.equal(16.5);
  });

  it('stands in a box as wide as its gates reach, and as high as there are data', () => {
    const stored = (_azimuth: number, gate: number): number => (gate < 20 ? 9 : 0);
    const options = {
      sweeps: [{ elevation: 0 }, { elevation: 30, stored }].map((sweep) => ({ gates: 100, stored, ...sweep })),
      beamWidth: 2,
    };
    const { grid } = radarVolume(options, { beamModel: 'straight' });
    const { low, high } = grid.box;
    expect(grid.earthRadius).to.equal(Infinity);
    // The last gate ends at 100 km.
    expect([low[0], low[1], high[0], high[1]]).to.deep.equal([-1e5, -1e5, 1e5, 1e5]);
    expect(low[2]).to.be.closeTo(-1e5 * Math.sin(Math.PI / 180), 1e-6);
    // 20 gates and one more, up to half a beam above 30 degrees.
    expect(high[2]).to.be.closeTo(21e3 * Math.sin((31 * Math.PI) / 180), 1e-6);
    expect(grid.dimensions).to.deep.equal([200, 200, Math.ceil((high[2] - low[2]) / 500)]);
    const round = radarVolume(options).grid;
    expect(round.earthRadius).to.equal(standardEarthRadius);
    expect(round.box.high[2]).to.be.above(high[2]);
    // A beam one degree below the horizon is level with the ground 148 km away.
    expect(round.box.low[2]).to.be.above(low[2]);
  });

  it('of a sector stands in the box of the sector, of a circle in a whole one though some radials are missing', () => {
    const boxOf = (azimuths: number[], firstGate = 500) => {
      const { low, high } = radarVolume(
        { sweeps: [{ elevation: 0, azimuths, firstGate, gates: 100 }] },
        { beamModel: 'straight' },
      ).grid.box;
      return [low[0], high[0], low[1], high[1]].map((metres) => Number((metres / 1000).toFixed(2)));
    };
    const from = (first: number, count: number): number[] => Array.from({ length: count }, (_, i) => (first + i) % 360);
    const at = (azimuth: number, range: number): number[] =>
      [range * Math.sin((azimuth * Math.PI) / 180), range * Math.cos((azimuth * Math.PI) / 180)].map((x) =>
        Number(x.toFixed(2)),
      );
    // One radial without data is at each end.
    expect(boxOf(from(40, 3)), 'north-east').to.deep.equal([0, at(43, 100)[0], 0, at(39, 100)[1]]);
    expect(boxOf(from(40, 3), 60_500), 'that begins far away').to.deep.equal([
      at(39, 60)[0],
      at(43, 160)[0],
      at(43, 60)[1],
      at(39, 160)[1],
    ]);
    expect(boxOf(from(350, 21)), 'across north').to.deep.equal([-at(11, 100)[0], at(11, 100)[0], 0, 100]);
    expect(boxOf(from(80, 120)), 'to the east and the south').to.deep.equal([
      at(200, 100)[0],
      100,
      -100,
      at(79, 100)[1],
    ]);
    expect(boxOf(from(10, 340)), 'all but twenty radials').to.deep.equal([-100, 100, -100, 100]);
  });

  it('takes another exaggeration without being decoded again', () => {
    const options = { sweeps: [{ elevation: 1 }] };
    const plain = radarVolume(options);
    const stretched = radarVolume(options, { verticalExaggeration: 4 });
    expect(boxIndexToWorld(plain.grid.box, plain.grid.dimensions, 4)).to.deep.equal(stretched.grid.indexToWorld);
    expect(stretched.grid.spacing[2]).to.be.closeTo(4 * plain.grid.spacing[2], 1e-9);
    expect(stretched.grid.spacing[0]).to.equal(plain.grid.spacing[0]);
  });
});
