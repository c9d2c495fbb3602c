import { big, concat } from '../bytes.ts';
import { oneFile } from '../fuzz-case.ts';
import type { FuzzCase } from '../fuzz-case.ts';
import { bzip2, bzip2OfRuns } from '../grammars/bzip2-writer.ts';

const headOfNexrad = big().text('AR2V0006.736').u32(18262, 0).text('KABC').finish();
const record = (packed: Uint8Array): Uint8Array => concat([big().u32(packed.length).finish(), packed]);

/** A radial of message 31 with one moment of so many gates. */
function radial(i: number, gates: number, cut: number): Uint8Array {
  const moment = big()
    .text('DREF')
    .u32(0)
    .u16(gates, 2125, 250, 0, 0)
    .u8(0, 8)
    .f32(2, 66)
    .put(new Uint8Array(gates).fill(80))
    .pad(2)
    .finish();
  const body = big()
    .text('KABC')
    .u32(1000)
    .u16(18262, i)
    .f32((i * 0.3) % 360)
    .u8(0, 0)
    .u16(0)
    .u8(1, i === 0 ? 0 : 1, cut, 0)
    .f32(cut / 2)
    .u8(0, 0)
    .u16(1)
    .u32(36)
    .put(moment)
    .finish();
  return big()
    .zeros(12)
    .u16((16 + body.length) / 2)
    .u8(0, 31)
    .u16(0, 18262)
    .u32(0)
    .u16(1, 1)
    .put(body)
    .finish();
}

type Variable = readonly [
  name: string,
  dimensions: readonly number[],
  type: 'f4' | 'i4' | 'i1',
  numbers: ArrayLike<number>,
];

/** A file of NetCDF-3. */
function netcdf3(lengths: readonly number[], variables: readonly Variable[]): Uint8Array<ArrayBuffer> {
  const [codes, bytes] = [
    { i1: 1, i4: 4, f4: 5 },
    { i1: 1, i4: 4, f4: 4 },
  ];
  const write = (begins: readonly number[]): Uint8Array<ArrayBuffer> => {
    const out = big().text('CDF').u8(1).u32(0, 10, lengths.length);
    lengths.forEach((length, i) => out.u32(2).text(`d${i}`).pad(4).u32(length));
    out.u32(0, 0, 11, variables.length);
    variables.forEach(([name, dimensions, type], i) =>
      out
        .u32(name.length)
        .text(name)
        .pad(4)
        .u32(dimensions.length, ...dimensions, 0, 0, codes[type], 0, begins[i] ?? 0),
    );
    return out.finish();
  };
  let at = write([]).length;
  const begins = variables.map(([, , type, { length }]) => {
    const begin = at;
    at += Math.ceil((length * bytes[type]) / 4) * 4;
    return begin;
  });
  const body = big();
  for (const [, , type, numbers] of variables) {
    for (let i = 0; i < numbers.length; i++) {
      if (type === 'f4') body.f32(numbers[i]);
      else if (type === 'i4') body.u32(numbers[i]);
      else body.u8(numbers[i]);
    }
    body.pad(4);
  }
  return concat([write(begins), body.finish()]);
}

/** Sweeps of CfRadial 1, each of which is all radials of the file. */
function overlappingSweeps(sweeps: number, radials: number, gates: number): FuzzCase {
  const each = (length: number, make: (i: number) => number): number[] => Array.from({ length }, (_, i) => make(i));
  return oneFile(
    'scan.nc',
    netcdf3(
      [sweeps, radials, gates],
      [
        ['fixed_angle', [0], 'f4', each(sweeps, (i) => (i * 90) / sweeps)],
        ['sweep_start_ray_index', [0], 'i4', each(sweeps, () => 0)],
        ['sweep_end_ray_index', [0], 'i4', each(sweeps, () => radials - 1)],
        ['range', [2], 'f4', each(gates, (i) => 250 + 500 * i)],
        ['azimuth', [1], 'f4', each(radials, (i) => (360 * i) / radials)],
        ['DBZ', [1, 2], 'i1', new Uint8Array(radials * gates).fill(7)],
      ],
    ),
  );
}

export const radarCases: Readonly<Record<string, () => FuzzCase>> = {
  'nexrad: 3,000 records of bzip2 with nothing in them': () =>
    oneFile('KABC_V06', concat([headOfNexrad, ...Array.from({ length: 3000 }, () => record(bzip2(new Uint8Array())))])),
  'nexrad: 20 records of bzip2 that unpack to 46 MB each': () => {
    const bomb = record(bzip2OfRuns(1, 179_999));
    return oneFile('KABC_V06', concat([headOfNexrad, ...Array.from({ length: 20 }, () => bomb)]));
  },
  'nexrad: one long radial among 1,000 short ones, in each of three cuts': () => {
    const cuts = [1, 2, 3].flatMap((cut) =>
      Array.from({ length: 1000 }, (_, i) => radial(i, i === 0 ? 60_000 : 1, cut)),
    );
    return oneFile('KABC_V06', concat([headOfNexrad, ...cuts]));
  },
  'netcdf3: 400 sweeps that are the same 20,000 radials': () => overlappingSweeps(400, 20_000, 2),
  'netcdf3: 64 sweeps that are the same 400 radials of 2,000 gates': () => overlappingSweeps(64, 400, 2000),
  'netcdf3: radials that crowd in a degree, for the table of azimuths': () => {
    const [sweeps, radials] = [90, 10_000];
    const each = (length: number, make: (i: number) => number): number[] => Array.from({ length }, (_, i) => make(i));
    return oneFile(
      'scan.nc',
      netcdf3(
        [sweeps, radials + sweeps, 1],
        [
          ['fixed_angle', [0], 'f4', each(sweeps, (i) => i)],
          ['sweep_start_ray_index', [0], 'i4', each(sweeps, (i) => (i === 0 ? 0 : radials + i))],
          ['sweep_end_ray_index', [0], 'i4', each(sweeps, (i) => (i === 0 ? radials - 1 : radials + i))],
          ['range', [2], 'f4', [250]],
          ['ray_start_range', [1], 'f4', each(radials + sweeps, () => 250)],
          ['ray_gate_spacing', [1], 'f4', each(radials + sweeps, () => 500)],
          [
            'azimuth',
            [1],
            'f4',
            each(radials + sweeps, (i) => (i < radials ? (i < 50 ? i * 7 : 359 + i / radials / 1000) : 0)),
          ],
          ['DBZ', [1, 2], 'i1', new Uint8Array(radials + sweeps).fill(7)],
        ],
      ),
    );
  },
};
