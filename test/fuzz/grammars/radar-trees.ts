import type { Random } from '../random.ts';

// Radar scans as trees of groups, arrays and attributes, as ODIM_H5 and CfRadial arrange them: what HDF5 and NetCDF then store.

export type NumberName = 'i1' | 'u1' | 'i2' | 'u2' | 'i4' | 'u4' | 'f4' | 'f8';
export type TreeValue = string | { readonly type: NumberName; readonly numbers: readonly number[] };

export interface TreeArray {
  readonly shape: readonly number[];
  /** Text: an array of characters, as NetCDF stores it. */
  readonly type: NumberName | 'text';
  readonly numbers: readonly number[];
  readonly attributes: Readonly<Record<string, TreeValue>>;
}

export interface TreeGroup {
  readonly attributes: Readonly<Record<string, TreeValue>>;
  readonly groups: Readonly<Record<string, TreeGroup>>;
  readonly arrays: Readonly<Record<string, TreeArray>>;
}

const group = (
  attributes: TreeGroup['attributes'],
  groups: TreeGroup['groups'] = {},
  arrays: TreeGroup['arrays'] = {},
): TreeGroup => ({ attributes, groups, arrays });
const real = (value: number): TreeValue => ({ type: 'f8', numbers: [value] });
const text = (value: string, length = value.length): TreeArray => ({
  type: 'text',
  shape: [length],
  numbers: Array.from(value.padEnd(length, '\0'), (c) => c.charCodeAt(0)),
  attributes: {},
});
const list = (type: NumberName, numbers: readonly number[], attributes: TreeArray['attributes'] = {}): TreeArray => ({
  type,
  shape: [numbers.length],
  numbers,
  attributes,
});
const count = (length: number, make: (i: number) => number): number[] => Array.from({ length }, (_, i) => make(i));

/** Gates of a sweep: some weather, and gaps. */
function gatesOf(
  random: Random,
  type: NumberName,
  shape: readonly number[],
  attributes: TreeArray['attributes'],
): TreeArray {
  const length = shape.reduce((product, n) => product * n, 1);
  const high = type === 'f4' || type === 'f8' ? 60 : 100;
  const offset = random.int(0, 99);
  return {
    type,
    shape,
    numbers: count(length, (i) =>
      (i * 7 + offset) % 5 === 0 ? 0 : random.isWild() ? random.number(1) : (i * 13 + offset) % high,
    ),
    attributes,
  };
}

/** An ODIM_H5 volume. Source: ODIM_H5 2.4 */
export function makeOdim(random: Random): TreeGroup {
  const names = Array.from({ length: random.int(1, 3) }, (_, i) => `dataset${random.or(i + 1, 1, 0, 99999)}`);
  const [rays, gates] = [random.int(1, 12), random.int(1, 9)];
  const type = random.pick(['u1', 'u1', 'u2', 'f4', 'i2', 'f8'] as const);
  const azimuths = count(rays, (ray) => random.number((360 * ray) / rays));
  const datasets = names.map((_, i) => {
    const shape = [rays, gates];
    const data = group(
      {},
      {
        what: group({
          quantity: random.or('DBZH', 'VRADH', '', 'x'.repeat(300)),
          gain: real(random.number(0.5)),
          offset: real(random.number(-32)),
          nodata: real(random.number(255)),
          undetect: real(random.number(0)),
        }),
      },
      { data: gatesOf(random, type, shape, {}) },
    );
    const where = group({
      elangle: real(random.number(0.5 + random.or(i, 0, 1e-4, 1e-9))),
      nrays: real(random.number(rays)),
      nbins: real(random.number(gates)),
      rscale: real(random.number(500)),
      rstart: real(random.number(0)),
      a1gate: real(random.number(0)),
    });
    const how = group(
      random.chance(0.5)
        ? {
            startazA: { type: 'f8', numbers: azimuths },
            stopazA: { type: 'f8', numbers: azimuths.map((a) => a + 360 / rays) },
          }
        : { NI: real(random.number(30)), elangles: { type: 'f8', numbers: azimuths.map(() => random.number(0.5)) } },
    );
    return group(
      {},
      {
        what: group({ product: 'SCAN', startdate: '20200101', starttime: random.or('120000', '999999', '1') }),
        where,
        how,
        data1: data,
      },
    );
  });
  return group(
    { Conventions: random.or('ODIM_H5/V2_2', 'CF-1.7', 'x'.repeat(2000)) },
    {
      what: group({
        object: random.or('PVOL', 'SCAN', 'RHI', 'constructor'),
        version: 'H5rad 2.2',
        date: '20200101',
        time: '120000',
        source: random.or('WMO:06477,PLC:Here', ':,:,'.repeat(50)),
      }),
      where: group({ lat: real(random.number(50)), lon: real(random.number(5)), height: real(random.number(100)) }),
      how: group({ beamwidth: real(random.number(1)), wavelength: real(random.number(5.3)) }),
      ...Object.fromEntries(datasets.map((dataset, i) => [names[i], dataset])),
    },
  );
}

/** A CfRadial 1 scan: one group. Source: CfRadial 1.4 */
export function makeCfradial1(random: Random): TreeGroup {
  const overlaps = random.isHostile(); // All sweeps are all radials.
  const [sweeps, rays, gates] = overlaps
    ? [random.pick([3, 60, 1000]), random.pick([1, 5, 60]), random.pick([2, 40])]
    : [random.int(1, 3), random.int(1, 8), random.int(2, 9)];
  const radials = overlaps ? rays * 10 : sweeps * rays;
  const type = random.pick(['i2', 'u1', 'f4', 'i1'] as const);
  const isRagged = random.chance(0.3);
  const lengths = count(radials, () => random.size(gates));
  const packing = {
    units: 'dBZ',
    scale_factor: real(random.number(0.01)),
    add_offset: real(random.number(0)),
    _FillValue: real(random.number(-32768)),
  };
  const moment = isRagged
    ? gatesOf(random, type, [radials * gates], packing)
    : gatesOf(random, type, [radials, gates], packing);
  return group(
    { Conventions: 'CF/Radial', version: random.or('1.3', '2.0', '') },
    {},
    {
      sweep_number: list(
        'i4',
        count(sweeps, (i) => i),
      ),
      sweep_mode: {
        type: 'text',
        shape: [sweeps, 32],
        numbers: count(sweeps * 32, (i) => 'azimuth_surveillance'.charCodeAt(i % 32) || 0),
        attributes: {},
      },
      fixed_angle: list(
        'f4',
        count(sweeps, (i) => random.number(overlaps ? (90 * i) / sweeps : 0.5 + i)),
      ),
      sweep_start_ray_index: list(
        'i4',
        count(sweeps, (i) => random.size(overlaps ? 0 : i * rays)),
      ),
      sweep_end_ray_index: list(
        'i4',
        count(sweeps, (i) => random.size(overlaps ? radials - 1 : i * rays + rays - 1)),
      ),
      time: list(
        'f8',
        count(radials, (i) => random.number(i)),
        { units: random.or('seconds since 2020-01-01T00:00:00Z', 'days since 1e9', '') },
      ),
      range: list(
        'f4',
        count(gates, (i) => random.number(250 + 500 * i)),
        { units: 'meters', meters_between_gates: real(random.number(500)) },
      ),
      azimuth: list(
        'f4',
        count(radials, (i) => random.number(((i % rays) * 360) / rays)),
      ),
      elevation: list(
        'f4',
        count(radials, (i) => random.number(0.5 + Math.floor(i / rays))),
      ),
      latitude: list('f8', [random.number(50)]),
      longitude: list('f8', [random.number(5)]),
      altitude: list('f8', [random.number(100)]),
      time_coverage_start: text(random.or('2020-01-01T00:00:00Z', '9'.repeat(300)), 32),
      ...(random.chance(0.3)
        ? {
            nyquist_velocity: list(
              'f4',
              count(radials, () => random.number(20)),
            ),
            ray_start_range: list(
              'f4',
              count(radials, () => random.number(250)),
            ),
            ray_gate_spacing: list(
              'f4',
              count(radials, () => random.number(500)),
            ),
          }
        : {}),
      ...(isRagged
        ? {
            ray_n_gates: list('i4', lengths),
            ray_start_index: list(
              'i4',
              count(radials, (i) => random.size(i * gates)),
            ),
          }
        : {}),
      DBZ: moment,
    },
  );
}

/** A CfRadial 2 scan: a group for each sweep. Source: CfRadial 2.1 */
export function makeCfradial2(random: Random): TreeGroup {
  const sweeps = random.int(1, 3);
  const groups = Array.from({ length: sweeps }, (_, sweep) => {
    const [rays, gates] = [random.int(1, 10), random.int(1, 9)];
    return group(
      {},
      {},
      {
        azimuth: list(
          'f4',
          count(rays, (i) => random.number((i * 360) / rays)),
        ),
        elevation: list(
          'f4',
          count(rays, () => random.number(0.5 + sweep)),
        ),
        range: list(
          'f4',
          count(gates, (i) => random.number(250 + 500 * i)),
          { units: 'meters', meters_between_gates: real(500) },
        ),
        time: list(
          'f8',
          count(rays, (i) => i),
          { units: 'seconds since 2020-01-01T00:00:00Z' },
        ),
        sweep_fixed_angle: {
          type: 'f4',
          shape: random.or<number[]>([], [1]),
          numbers: [random.number(0.5 + sweep)],
          attributes: {},
        },
        sweep_mode: text('azimuth_surveillance', 32),
        DBZH: gatesOf(random, random.pick(['i2', 'f4', 'u1']), [rays, gates], {
          units: 'dBZ',
          scale_factor: real(random.number(0.01)),
          add_offset: real(random.number(0)),
        }),
      },
    );
  });
  return group(
    { Conventions: 'Cf/Radial-2.0', version: '2.0' },
    Object.fromEntries(groups.map((one, i) => [`sweep_${random.or(i, 0, 1e9)}`, one])),
    {
      latitude: { ...list('f8', [random.number(50)]), shape: [] },
      longitude: { ...list('f8', [random.number(5)]), shape: [] },
    },
  );
}

/** A MINC 2 volume: sizes, scales, axes and places that lie. Source: "MINC 2.0 File Format Reference" */
export function makeMinc(random: Random): TreeGroup {
  const type = random.pick(['i1', 'u1', 'i2', 'u2', 'i4', 'f4', 'f8'] as const);
  const size = [random.int(1, 5), random.int(1, 5), random.int(1, 5)];
  const names = random.or(['zspace', 'yspace', 'xspace'], ['time', 'zspace', 'yspace'], ['xspace']);
  const scaled = size.slice(0, random.pick([0, 1, 2]));
  const product = (lengths: readonly number[]): number => lengths.reduce((all, n) => all * n, 1);
  const scale = (start: number): TreeArray => ({
    type: 'f8',
    shape: scaled.map((n) => random.or(n, n + 1)),
    numbers: count(product(scaled), (i) => random.number(start + i)),
    attributes: {},
  });
  const axis = (name: string): TreeArray => ({
    type: 'i4',
    shape: [],
    numbers: [0],
    attributes: {
      start: real(random.number(5)),
      step: real(random.number(1.5)),
      spacing: random.or('regular__', 'irregular'),
      direction_cosines: {
        type: 'f8',
        numbers: ['xspace', 'yspace', 'zspace'].map((one) => random.number(one === name ? 1 : 0)),
      },
    },
  });
  const image: TreeArray = {
    type,
    shape: size,
    numbers: count(product(size), (i) => (i * 37) % 100),
    attributes: {
      dimorder: random.or(names.join(','), 'vector_dimension', ''),
      ...(random.chance(0.3) ? { valid_range: { type: 'f8', numbers: [random.number(0), random.number(99)] } } : {}),
    },
  };
  const folder = group({}, {}, { image, 'image-max': scale(100), 'image-min': scale(-20) });
  const axes = Object.fromEntries(names.map((name) => [name, axis(name)]));
  return group({}, { 'minc-2.0': group({}, { image: group({}, { '0': folder }), dimensions: group({}, {}, axes) }) });
}
