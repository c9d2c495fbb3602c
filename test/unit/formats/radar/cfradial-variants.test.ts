// CfRadial as different programs write it: packed coordinates, units of time, ranges of each radial, modes that are not said.
import { expect } from '@esm-bundle/chai';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import { parseTimeUnits } from '../../../../src/formats/radar/cf-time.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { decodeBytes, expectError } from '../../../helpers/decode.ts';
import { buildNetcdf3 } from '../../../helpers/netcdf3-builder.ts';
import type { Netcdf3Variable } from '../../../helpers/netcdf3-builder.ts';
import { gateValues } from '../../../helpers/radar.ts';

/** Two sweeps of four radials of three gates. A variable that is given replaces the usual one of its name. */
const [time, range, sweep, signs, points] = [0, 1, 2, 3, 4];
const radials = 8;
const gates = 3;

const doubles = (
  name: string,
  dimensions: readonly number[],
  values: readonly number[],
  attributes: NonNullable<Netcdf3Variable['attributes']> = {},
): Netcdf3Variable => ({ name, dimensions, data: Float64Array.from(values), attributes });

const modes = (...names: readonly string[]): Netcdf3Variable => ({
  name: 'sweep_mode',
  dimensions: [sweep, signs],
  data: new TextEncoder().encode(names.map((name) => name.padEnd(32, '\0')).join('')),
  isText: true,
});

const list = (count: number, value: (i: number) => number): number[] =>
  Array.from({ length: count }, (_, i) => value(i));
const dbz = list(radials * gates, (i) => i);

function build(given: readonly Netcdf3Variable[], without: readonly string[] = []): Uint8Array<ArrayBuffer> {
  const usual = [
    doubles(
      'azimuth',
      [time],
      list(radials, (i) => 90 * (i % 4) + 10),
    ),
    doubles(
      'elevation',
      [time],
      list(radials, (i) => (i < 4 ? 1 : 3)),
    ),
    doubles('range', [range], [250, 750, 1250], { units: 'meters' }),
    doubles('fixed_angle', [sweep], [1, 3]),
    doubles('sweep_start_ray_index', [sweep], [0, 4]),
    doubles('sweep_end_ray_index', [sweep], [3, 7]),
    modes('azimuth_surveillance', 'azimuth_surveillance'),
    doubles('DBZ', [time, range], dbz, { units: 'dBZ' }),
  ];
  const names = new Set([...given.map(({ name }) => name), ...without]);
  return buildNetcdf3(
    [radials, gates, 2, 32, radials * gates],
    [...usual.filter(({ name }) => !names.has(name)), ...given],
  );
}

const read = (...args: Parameters<typeof build>): Promise<RadarFile> => readCfradial1(build(...args));

describe('packed coordinates of CfRadial', () => {
  it('are unpacked as fields are', async () => {
    const packing = { scale_factor: [0.01], add_offset: [5] };
    const { sweeps, site } = await read([
      {
        name: 'azimuth',
        dimensions: [time],
        data: Int16Array.from(list(radials, (i) => 1000 * i)),
        attributes: packing,
      },
      {
        name: 'elevation',
        dimensions: [time],
        data: Int16Array.from(list(radials, (i) => i - 300)),
        attributes: packing,
      },
      { name: 'range', dimensions: [range], data: Int16Array.of(1, 3, 5), attributes: { scale_factor: [250] } },
      { name: 'fixed_angle', dimensions: [sweep], data: Int16Array.of(-298, -294), attributes: packing },
      { name: 'latitude', dimensions: [], data: Int16Array.of(4500), attributes: packing },
    ]);
    expect(sweeps.map(({ azimuths }) => [...azimuths])).to.deep.equal([
      [5, 15, 25, 35],
      [45, 55, 65, 75],
    ]);
    sweeps[0].elevations!.forEach((one, i) => expect(one).to.be.closeTo(2 + i / 100, 1e-9));
    expect(sweeps[1].elevation).to.be.closeTo(2.06, 1e-9);
    expect(sweeps[0].gridOf('DBZ')).to.deep.equal({ firstGate: 250, gateLength: 500, gates });
    expect(site.latitude).to.equal(50);
  });

  it('have no value where they hold their fill value, and may be unsigned', async () => {
    const { sweeps } = await read([
      doubles('elevation', [time], [1, -9999, 1, 1, 3, 3, 3, 3], { _FillValue: [-9999] }),
      {
        name: 'azimuth',
        dimensions: [time],
        data: Int16Array.from(list(radials, (i) => 8192 * i)),
        attributes: { _Unsigned: 'true', scale_factor: [360 / 65536] },
      },
    ]);
    expect([...sweeps[0].elevations!]).to.deep.equal([1, NaN, 1, 1]);
    expect([...sweeps[1].azimuths]).to.deep.equal([180, 225, 270, 315]);
  });
});

describe('units of a CF time', () => {
  // cftime 1.6 for Python, but for a zone of one digit, as CF conventions 1.11, 4.4 have it, which it does not read.
  for (const [units, from, unit] of [
    ['seconds since 2024-05-01T12:00:00Z', '2024-05-01T12:00:00.000Z', 1000],
    ['seconds since 2024-05-01T12:00:00+02:00', '2024-05-01T10:00:00.000Z', 1000],
    ['seconds since 2024-05-01 12:00:00 -0530', '2024-05-01T17:30:00.000Z', 1000],
    ['seconds since 1992-10-8 15:15:42.5 -6:00', '1992-10-08T21:15:42.500Z', 1000],
    ['msecs since 2024-05-01 12:00:00 UTC', '2024-05-01T12:00:00.000Z', 1],
    ['ms since 2024-05-01', '2024-05-01T00:00:00.000Z', 1],
    ['s since 2024-05-01', '2024-05-01T00:00:00.000Z', 1000],
    ['mins since 2024-5-1 1:2:3', '2024-05-01T01:02:03.000Z', 60_000],
    ['hr since 2024-05-01 12:00', '2024-05-01T12:00:00.000Z', 3_600_000],
    ['Days since 2024-05-01', '2024-05-01T00:00:00.000Z', 86_400_000],
    ['nanoseconds since 1970-01-01', '1970-01-01T00:00:00.000Z', 1e-6],
  ] as const)
    it(units, () => {
      const parsed = parseTimeUnits(units)!;
      expect([new Date(parsed.from).toISOString(), parsed.unit]).to.deep.equal([from, unit]);
    });

  it('others are none', () => {
    for (const units of ['seconds', 'months since 2024-05-01', 'seconds since noon', ''])
      expect(parseTimeUnits(units)).to.equal(undefined);
  });
});

describe('ranges of the radials of CfRadial', () => {
  const perSweep = (first: number, second: number): number[] => list(radials, (i) => (i < 4 ? first : second));

  it('may differ between sweeps: two numbers for each radial, or a row', async () => {
    const numbers = [
      doubles('ray_start_range', [time], perSweep(250, 1), { units: 'meters' }),
      doubles('ray_gate_spacing', [time], perSweep(500, 100), { units: 'meters' }),
    ];
    const row = doubles(
      'range',
      [time, range],
      list(radials * gates, (i) => (i < 12 ? 0.25 + 0.5 * (i % gates) : 0.001 + 0.1 * (i % gates))),
      { units: 'km' },
    );
    for (const given of [numbers, [row]]) {
      const { sweeps, moments } = await read(given);
      expect(moments.map(({ name }) => name)).to.deep.equal(['DBZ']);
      const grids = sweeps.map(({ gridOf }) => gridOf('DBZ')!);
      for (const [i, [firstGate, gateLength]] of [
        [250, 500],
        [1, 100],
      ].entries()) {
        expect(grids[i].firstGate).to.be.closeTo(firstGate, 1e-9);
        expect(grids[i].gateLength).to.be.closeTo(gateLength, 1e-9);
      }
      expect([...gateValues(sweeps[1].read('DBZ')!)]).to.deep.equal(dbz.slice(12));
    }
  });

  it('that differ within a sweep are refused', async () => {
    const numbers = [
      doubles('ray_start_range', [time], [250, 250, 750, 250, 250, 250, 250, 250]),
      doubles('ray_gate_spacing', [time], perSweep(500, 500)),
    ];
    const { code, message } = await expectError(decodeBytes(build(numbers), 'scan.nc'));
    expect(code).to.equal('format/unsupported');
    expect(message).to.contain('gates of 500 m from 750 m on and others with gates of 500 m from 250 m on');
  });

  it('radials of different lengths may lie in any order', async () => {
    // The last radial lies first, and nothing is at 5, 6 and 15.
    const starts = [21, 18, 16, 12, 10, 7, 3, 0];
    const lengths = [3, 3, 2, 3, 2, 3, 2, 3];
    const { sweeps } = await read(
      [
        doubles('ray_n_gates', [time], lengths),
        doubles('ray_start_index', [time], starts),
        doubles(
          'VEL',
          [points],
          list(radials * gates, (i) => 100 + i),
          { units: 'm/s' },
        ),
      ],
      ['DBZ'],
    );
    const values = sweeps.map((one) => [...gateValues(one.read('VEL')!)]);
    expect(values).to.deep.equal([
      [121, 122, 123, 118, 119, 120, 116, 117, NaN, 112, 113, 114],
      [110, 111, NaN, 107, 108, 109, 103, 104, NaN, 100, 101, 102],
    ]);
  });

  it('radials of different lengths that lie outside of the values are refused', async () => {
    const given = [
      doubles('ray_n_gates', [time], [3, 3, 3, 3, 3, 3, 3, 3]),
      doubles('ray_start_index', [time], [-1, 3, 6, 9, 12, 15, 18, 21]),
      doubles('VEL', [points], dbz),
    ];
    const { code, message } = await expectError(decodeBytes(build(given, ['DBZ']), 'scan.nc'));
    expect(code).to.equal('format/corrupt');
    expect(message).to.contain('outside of /VEL');
  });
});

describe('what the antenna of a CfRadial file did', () => {
  const rising = [
    doubles(
      'azimuth',
      [time],
      list(radials, (i) => (i < 4 ? 10 : i < 6 ? 100 : 280)),
    ),
    doubles('elevation', [time], [1, 21, 41, 61, 40, 80, 80, 40]),
    doubles('fixed_angle', [sweep], [10, 100]),
  ];

  it('is known by its angles: a scan that turns in elevation is a range-height scan, whatever its mode says', async () => {
    for (const mode of ['', 'ppi', 'sector']) {
      const { sweeps, details } = await read([...rising, modes(mode, mode)]);
      expect(details!.join()).to.contain('range-height scans');
      // The second scan goes over the zenith.
      expect(sweeps.map(({ elevation }) => elevation)).to.deep.equal([1, 21, 41, 61, 80]);
      const [lowest] = sweeps;
      expect([...lowest.azimuths])
        .to.include(10)
        .and.not.to.include(100);
    }
  });

  it('next to sweeps of constant elevation, such a scan is left out', async () => {
    const given = [
      doubles('azimuth', [time], [10, 100, 190, 280, 30, 30, 30, 30]),
      doubles('elevation', [time], [1, 1, 1, 1, 2, 12, 22, 32]),
      modes('', ''),
    ];
    const { sweeps, left } = await read(given);
    expect(sweeps.map(({ elevation }) => elevation)).to.deep.equal([1]);
    expect(left!.join()).to.contain('1 of 2 sweeps are left out').and.to.contain('sweep_mode: none');
  });

  it('a file of other modes alone is refused, and its modes are named', async () => {
    const { code, message } = await expectError(decodeBytes(build([modes('pointing', 'calibration')]), 'scan.nc'));
    expect(code).to.equal('format/unsupported');
    expect(message).to.contain('sweep_mode pointing, calibration');
  });

  it('where the fixed angle is far from the radials, theirs is the elevation', async () => {
    const { sweeps } = await read([doubles('fixed_angle', [sweep], [0.5, 0])]);
    expect(sweeps.map(({ elevation, left }) => [elevation, left?.join()])).to.deep.equal([
      [0.5, undefined],
      [3, 'the fixed angle 0° of a sweep is not used: its radials are at 3°'],
    ]);
    const volume = await decodeBytes(build([doubles('fixed_angle', [sweep], [0, 0])]), 'scan.nc');
    expect(volume.radar!.sweeps.map(({ elevation }) => elevation)).to.deep.equal([0, 3]);
    expect(volume.radar!.left.join()).to.contain('fixed angle 0°');
  });

  it('elevations that were never filled in say nothing', async () => {
    const { sweeps } = await read([
      doubles(
        'elevation',
        [time],
        list(radials, () => 0),
      ),
    ]);
    expect(sweeps.map(({ elevation }) => elevation)).to.deep.equal([1, 3]);
    expect(sweeps[1].elevations).to.equal(undefined);
  });

  it('a sweep higher than straight up is left out in words', async () => {
    const given = [
      doubles('fixed_angle', [sweep], [1, 100]),
      doubles('elevation', [time], [1, 1, 1, 1, 100, 100, 100, 100]),
    ];
    const { radar } = await decodeBytes(build(given), 'scan.nc');
    expect(radar!.left.join()).to.contain('sweep 2 at 100° is left out: no antenna looks there');
  });
});
