// What CfRadial says of gates, radials and sweeps that are no data: read from files.
import { nearestOnly } from '../../../../src/volume/polar-grid.ts';
import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { buildNetcdf3 } from '../../../helpers/netcdf3-builder.ts';
import type { Netcdf3Variable } from '../../../helpers/netcdf3-builder.ts';
import { gateValues } from '../../../helpers/radar.ts';

type Attributes = NonNullable<Netcdf3Variable['attributes']>;

/** A scan of as many radials as there are rows in `data`, all of one sweep, or of as many sweeps as there are modes. */
function scan(
  data: Float64Array | Int16Array | Uint8Array,
  attributes: Attributes,
  { gates = data.length, modes = ['azimuth_surveillance'], more = [] as Netcdf3Variable[] } = {},
): Promise<RadarFile> {
  const radials = data.length / gates;
  const perSweep = radials / modes.length;
  const [time, range, sweep, signs] = [0, 1, 2, 3];
  const numbers = (
    name: string,
    dimension: number,
    values: readonly number[],
    of: Attributes = {},
  ): Netcdf3Variable => ({ name, dimensions: [dimension], data: Float64Array.from(values), attributes: of });
  const text = new TextEncoder().encode(modes.map((mode) => mode.padEnd(32, '\0')).join(''));
  return readCfradial1(
    buildNetcdf3(
      [radials, gates, modes.length, 32],
      [
        numbers(
          'azimuth',
          time,
          Array.from({ length: radials }, (_, i) => 10 * i),
        ),
        numbers(
          'elevation',
          time,
          Array.from({ length: radials }, (_, i) => 0.5 + Math.floor(i / perSweep)),
        ),
        numbers(
          'range',
          range,
          Array.from({ length: gates }, (_, i) => 250 + 500 * i),
          { units: 'meters' },
        ),
        numbers(
          'fixed_angle',
          sweep,
          modes.map((_, i) => 0.5 + i),
        ),
        numbers(
          'sweep_start_ray_index',
          sweep,
          modes.map((_, i) => i * perSweep),
        ),
        numbers(
          'sweep_end_ray_index',
          sweep,
          modes.map((_, i) => (i + 1) * perSweep - 1),
        ),
        { name: 'sweep_mode', dimensions: [sweep, signs], data: text, isText: true },
        ...more,
        { name: 'DBZ', dimensions: [time, range], data, attributes: { units: 'dBZ', ...attributes } },
      ],
    ),
  );
}

const valuesOf = async (...args: Parameters<typeof scan>): Promise<(number | null)[]> =>
  Array.from(gateValues((await scan(...args)).sweeps[0].read('DBZ')!), (value) =>
    Number.isFinite(value) ? value : null,
  );

describe('what a variable calls valid', () => {
  // netCDF4 1.7.5 for Python, auto mask: which Py-ART 2.3 reads with. xradar 0.12, by xarray, masks fill values alone.
  const shorts = Int16Array.of(-5, 0, 10, 100, 200);
  for (const [name, data, attributes, expected] of [
    ['valid_min and valid_max', shorts, { valid_min: [0], valid_max: [100] }, [null, 0, 10, 100, null]],
    ['valid_range', shorts, { valid_range: [0, 100] }, [null, 0, 10, 100, null]],
    ['valid_range before the others', shorts, { valid_range: [0, 100], valid_min: [10] }, [null, 0, 10, 100, null]],
    [
      'packed numbers, as they are stored',
      shorts,
      { valid_min: [0], valid_max: [100], scale_factor: [0.5], add_offset: [-32] },
      [null, -32, -27, 18, null],
    ],
    ['one that the type can not hold says nothing', shorts, { valid_min: [0.5] }, [-5, 0, 10, 100, 200]],
    ['nor one beyond the type', shorts, { valid_max: [100_000] }, [-5, 0, 10, 100, 200]],
    ['a text says nothing', shorts, { valid_min: '0' }, [-5, 0, 10, 100, 200]],
    ['a range of one number says nothing', shorts, { valid_range: [0] }, [-5, 0, 10, 100, 200]],
    ['floats', Float64Array.of(-40, -32, 0, 95, 96), { valid_min: [-32], valid_max: [95] }, [null, -32, 0, 95, null]],
    [
      'fill values too',
      Int16Array.of(-32768, -9999, 5, 300),
      { _FillValue: [-32768], valid_min: [-100], valid_max: [200] },
      [null, null, 5, null],
    ],
    ['several missing values', Float64Array.of(-9999, -8888, 2), { missing_value: [-9999, -8888] }, [null, null, 2]],
    [
      'unsigned bytes',
      Uint8Array.of(255, 0, 1, 128, 127),
      { _Unsigned: 'true', _FillValue: [0], valid_range: [1, -2] },
      [null, null, 1, 128, 127],
    ],
  ] as const) {
    it(name, async () => expect(await valuesOf(data, attributes)).to.deep.equal(expected));
  }

  it('a range that holds no number says nothing: netCDF4 would leave nothing of the file', async () => {
    expect(await valuesOf(shorts, { valid_min: [100], valid_max: [-100] })).to.deep.equal([-5, 0, 10, 100, 200]);
  });

  it('flags whose meaning is that there are no data, which netCDF4 leaves to who reads', async () => {
    expect(
      await valuesOf(Int16Array.of(0, 1, 2, 3), { flag_values: [0, 1, 2, 3], flag_meanings: 'rain snow no_data hail' }),
    ).to.deep.equal([0, 1, null, 3]);
    expect(
      await valuesOf(Int16Array.of(0, 1, 2, 3), { flag_values: [0, 1], flag_meanings: 'rain no_data snow' }),
      'of another number',
    ).to.deep.equal([0, 1, 2, 3]);
  });

  it('several flags that stand for something make kinds of echo of a variable, which are not mixed', async () => {
    const kindsOf = async (flags: Attributes) => (await scan(Int16Array.of(0, 1, 2, 3), flags)).moments[0];
    const kinds = { flag_values: [0, 1, 2, 3], flag_meanings: 'no_data rain snow hail' };
    expect(await kindsOf(kinds)).to.deep.equal({ name: 'DBZ', unit: 'dBZ', kind: 'kinds', numbers: [1, 3] });
    const { grid } = buildPolarVolume(await scan(Int16Array.of(0, 1, 2, 3), kinds), {});
    expect(grid.foldFrom).to.equal(nearestOnly);
    expect((await kindsOf({ flag_values: [0, 1], flag_meanings: 'no_data rain' })).kind).to.equal('reflectivity');
  });

  it('is said, and changes nothing that needs a sign', async () => {
    const { radar } = buildPolarVolume(
      await scan(Int16Array.of(-5, 0, 10, 200), { valid_min: [0], valid_max: [100] }, { gates: 2 }),
      {},
    );
    expect(radar!.details).to.deep.equal([
      '2 gates hold no data: their values are outside of what the file calls valid (valid_min, valid_max, valid_range)',
    ]);
    expect(radar!.left).to.deep.equal([]);
  });
});

describe('what CfRadial says is no part of a scan', () => {
  it('radials of an antenna on its way to another elevation', async () => {
    const transition: Netcdf3Variable = {
      name: 'antenna_transition',
      dimensions: [0],
      data: Uint8Array.of(1, 0, 0, 0, 1, 1),
      attributes: {},
    };
    const file = await scan(
      Float64Array.from({ length: 12 }, (_, i) => 1 + i),
      {},
      { gates: 2, more: [transition] },
    );
    expect(file.sweeps[0].transitions).to.deep.equal(Uint8Array.of(1, 0, 0, 0, 1, 1));
    const { radar, samples } = buildPolarVolume(file, {});
    expect(radar!.sweeps[0].radials).to.equal(3);
    expect([...samples].filter(Number.isFinite)).to.deep.equal([3, 4, 5, 6, 7, 8]);
    expect(radar!.details).to.deep.equal([
      '3 radials are left out: the antenna was on its way between sweeps (antenna_transition)',
    ]);
  });

  it('sweeps of the sun, of a calibration, and up and down', async () => {
    const modes = ['azimuth_surveillance', 'sunscan', 'calibration', 'rhi', 'sector', 'vertical_pointing'];
    const file = await scan(
      Float64Array.from({ length: 24 }, (_, i) => i),
      {},
      { gates: 2, modes },
    );
    expect(file.sweeps.map(({ elevation }) => elevation)).to.deep.equal([0.5, 4.5, 5.5]);
    expect(file.left).to.deep.equal([
      '3 of 6 sweeps are left out: the antenna did not keep its elevation, or did not look at the weather (sweep_mode: sunscan, calibration, rhi)',
    ]);
  });

  it('that a radar moved is said', async () => {
    const mobile: Netcdf3Variable = {
      name: 'platform_is_mobile',
      dimensions: [3],
      data: new TextEncoder().encode('true'.padEnd(32, '\0')),
      isText: true,
    };
    expect((await scan(Float64Array.of(1, 2), {}, { more: [mobile] })).left!.join()).to.contain(
      'moved while it scanned',
    );
  });
});
