import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { chooseSweeps } from '../../../../src/formats/radar/choose-sweeps.ts';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import { readNexrad } from '../../../../src/formats/radar/nexrad.ts';
import { readPolarMosaic } from '../../../../src/formats/radar/polar-mosaic.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { layOutRadials } from '../../../../src/radar/polar-layout.ts';
import { buildPolarTable } from '../../../../src/radar/polar-table.ts';
import { describeVolume } from '../../../../src/viewer/model/volume-info.ts';
import type { PolarGrid, Sweep } from '../../../../src/volume/polar-grid.ts';
import { decodeBytes, expectError } from '../../../helpers/decode.ts';
import { Hdf5Builder, nowhere, types } from '../../../helpers/hdf5-builder.ts';
import { contiguous } from '../../../helpers/hdf5-builder.ts';
import { buildNetcdf3 } from '../../../helpers/netcdf3-builder.ts';
import type { Netcdf3Variable } from '../../../helpers/netcdf3-builder.ts';
import { buildEmptyRecords, buildNexrad } from '../../../helpers/nexrad-builder.ts';
import { evenAzimuths, radarVolume, syntheticRadar } from '../../../helpers/synthetic-radar.ts';
import type { SweepOptions } from '../../../helpers/synthetic-radar.ts';

const errorOf = async (run: () => unknown): Promise<Error & { code: string }> => expectError((async () => run())());

/** ODIM_H5 whose scans all lead to one array that was never written. */
function unwritten(
  sweeps: number,
  lengths: readonly [number, number],
  where: (i: number) => Record<string, number>,
): Uint8Array<ArrayBuffer> {
  const builder = new Hdf5Builder();
  const data = builder.array(types.uint8, lengths, [contiguous(nowhere, 0)]);
  return builder.buildOdim(Array.from({ length: sweeps }, (_, i) => builder.odimSweep(data, where(i))));
}

/** CfRadial 1 in NetCDF-3: sweeps of some radials each, of all of one variable. */
function cfradial(
  sweeps: readonly { from: number; to: number; elevation: number }[],
  radials: number,
  gates: number,
  more: readonly Netcdf3Variable[] = [],
): Uint8Array<ArrayBuffer> {
  const along = { radials: 0, gates: 1, sweeps: 2 };
  const doubles = (name: string, dimension: number, numbers: readonly number[]): Netcdf3Variable => ({
    name,
    dimensions: [dimension],
    data: Float64Array.from(numbers),
  });
  return buildNetcdf3(
    [radials, gates, sweeps.length],
    [
      doubles('azimuth', along.radials, evenAzimuths(radials)),
      doubles(
        'range',
        along.gates,
        Array.from({ length: gates }, (_, i) => 500 + 1000 * i),
      ),
      doubles(
        'sweep_start_ray_index',
        along.sweeps,
        sweeps.map(({ from }) => from),
      ),
      doubles(
        'sweep_end_ray_index',
        along.sweeps,
        sweeps.map(({ to }) => to),
      ),
      doubles(
        'fixed_angle',
        along.sweeps,
        sweeps.map(({ elevation }) => elevation),
      ),
      { name: 'DBZ', dimensions: [along.radials, along.gates], data: new Uint8Array(radials * gates).fill(7) },
      ...more,
    ],
  );
}

describe('radar files that ask for more than they hold', () => {
  it('64 scans of one array that was never written: gates are counted before they are read', async () => {
    const bytes = unwritten(64, [1000, 4000], (i) => ({ elangle: i, rscale: 250 }));
    const error = await expectError(decodeBytes(bytes, 'scan.h5'));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('of memory in addition to');
  });

  it('of scans at one elevation one is read', () => {
    const file = syntheticRadar({
      sweeps: Array.from({ length: 50 }, (_, i) => ({ elevation: 1 + i / 1e4, gates: 20 + (i === 30 ? 1 : 0) })),
    });
    let reads = 0;
    const counted: RadarFile = {
      ...file,
      sweeps: file.sweeps.map((sweep) => ({ ...sweep, read: (moment) => (reads++, sweep.read(moment)) })),
    };
    const { chosen, details } = chooseSweeps(counted, 'DBZH', 1);
    expect(chosen.map(({ sweep }) => sweep)).to.deep.equal([counted.sweeps[30]]);
    expect(details).to.have.length(49);
    expect(reads).to.equal(1);
  });

  it('an empty sweep stands back for one with data, however far it reaches', () => {
    const empty: SweepOptions = { elevation: 1, gates: 40, stored: () => 0 };
    const file = syntheticRadar({ sweeps: [empty, { elevation: 1.1, gates: 10 }, { ...empty, elevation: 5 }] });
    const { chosen, details } = chooseSweeps(file, 'DBZH', 1);
    expect(chosen.map(({ sweep }) => sweep.elevation)).to.deep.equal([1.1, 5]);
    expect(details).to.deep.equal(['sweep 1 at 1° is left out for sweep 2 at 1.1°']);
  });

  it('sweeps that overlap: angles and gates count for each', async () => {
    const whole = { from: 0, to: 7999 };
    const bytes = cfradial(
      Array.from({ length: 2000 }, (_, i) => ({ ...whole, elevation: i / 25 })),
      8000,
      2,
    );
    const error = await errorOf(() => readCfradial1(bytes));
    expect(error.code).to.equal('format/too-large');
    const some = cfradial(
      Array.from({ length: 300 }, (_, i) => ({ ...whole, elevation: i / 4 })),
      8000,
      2,
    );
    // 2.4 million radials in a table on the GPU.
    expect((await expectError(decodeBytes(some, 'scan.nc'))).message).to.contain('sweeps of up to 8000 radials');
  });

  it('sweeps by the thousand share the list of their moments', async () => {
    const moments = Array.from({ length: 300 }, (_, i): Netcdf3Variable => ({
      name: `M${i}`,
      dimensions: [0, 1],
      data: new Uint8Array(4),
    }));
    const bytes = cfradial(
      Array.from({ length: 700 }, (_, i) => ({ from: 0, to: 1, elevation: i / 4 - 88 })),
      2,
      2,
      moments,
    );
    const { sweeps } = await readCfradial1(bytes);
    expect(new Set(sweeps.map((sweep) => sweep.moments)).size).to.equal(1);
    const error = await expectError(decodeBytes(bytes, 'scan.nc'));
    expect(error.message).to.contain('at most 512');
  });

  it('one long radial does not make all others as long', async () => {
    const radials = Array.from({ length: 1110 }, (_, i) => ({
      azimuth: (i * 360) / 1110,
      elevation: 1,
      cut: 1,
      gates: i === 0 ? 60_000 : 1,
    }));
    const bytes = buildNexrad(radials);
    const error = await expectError(decodeBytes(bytes, 'radar.ar2v'));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('sweep 1 at 1°');
  });

  it('radials of NEXRAD without end are counted', async () => {
    const bytes = buildNexrad(Array.from({ length: 200 }, (_, i) => ({ azimuth: i, elevation: 1, cut: 1, gates: 4 })));
    const budget = Budget.ofFile(bytes.length);
    await readNexrad(bytes, budget);
    expect(budget.allowedBytes - budget.leftBytes).to.be.at.least(200 * 512);
    budget.take(budget.leftBytes - 10_000, 'others');
    expect((await errorOf(() => readNexrad(bytes, budget))).code).to.equal('format/too-large');
  });

  it('records without any block take no room to unpack them', async () => {
    const bytes = buildEmptyRecords(50);
    const Original = globalThis.Uint32Array;
    let made = 0;
    globalThis.Uint32Array = new Proxy(Original, {
      construct(target, args: [unknown]) {
        if (typeof args[0] === 'number') made += args[0];
        return Reflect.construct(target, args) as Uint32Array;
      },
    });
    try {
      expect((await errorOf(() => readNexrad(bytes))).message).to.contain('holds no radials');
    } finally {
      globalThis.Uint32Array = Original;
    }
    expect(made).to.be.below(10_000);
  });

  it('few radials of very many gates are too much to look through', async () => {
    const bytes = unwritten(1, [1, 2 ** 23], () => ({ elangle: 1, rscale: 0.1 }));
    const error = await expectError(decodeBytes(bytes, 'scan.h5'));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('steps');
  });

  it('a mosaic has no more radials than a file', async () => {
    const image = { width: 1, height: 100_001, data: new Uint8Array(100_001) };
    const settings = {
      mosaic: { columns: 1, rows: 1 },
      elevations: [1],
      range: [0, 250] as const,
      slope: 1,
      intercept: 0,
      unit: 'dBZ',
    };
    expect((await errorOf(() => readPolarMosaic(image, 'PNG', settings))).message).to.contain('at most 100000');
  });
});

describe('radar files whose numbers are no places', () => {
  const cases: Record<string, SweepOptions> = {
    'gates beyond the Earth': { elevation: 1, gateLength: 1e12 },
    'gates at 1e308 m': { elevation: 1, firstGate: 1e308, gateLength: 1e308 },
    'gates behind the antenna': { elevation: 1, firstGate: -1e6, gateLength: 1 },
    'values beyond float32': { elevation: 1, slope: 1e300 },
    'a scale of nothing': { elevation: 1, slope: 1e-320 },
  };
  for (const [name, sweep] of Object.entries(cases)) {
    it(`${name}: format/corrupt`, async () => {
      expect((await errorOf(() => radarVolume({ sweeps: [sweep] }))).code).to.equal('format/corrupt');
    });
  }

  it("elevations of NaN or 1e308 are left out, those of radials are the sweep's, azimuths in the millions wrap", () => {
    const { grid, radar } = buildPolarVolume(
      syntheticRadar({
        sweeps: [
          { elevation: NaN },
          { elevation: 1e308 },
          {
            elevation: 2,
            rayElevation: (_, ray) => [NaN, 1e308, -1e9, 2.5][ray % 4],
            azimuths: [...evenAzimuths(24), 3.6e6 + 7, NaN, 1e308],
          },
        ],
      }),
      {},
    );
    expect(grid.sweeps).to.have.length(1);
    expect(radar!.left).to.have.length(2);
    const [sweep] = grid.sweeps;
    expect(sweep.azimuths.every((azimuth) => azimuth >= 0 && azimuth < 360)).to.equal(true);
    expect(sweep.elevations!.every((one) => one >= 2 && one <= 2.5)).to.equal(true);
    expect([...grid.indexToWorld, ...grid.spacing, ...grid.box.low, ...grid.box.high].every(Number.isFinite)).to.equal(
      true,
    );
  });

  it('floats that float32 can not hold are no data, and a fold that no value reaches is none', () => {
    const volume = radarVolume({
      sweeps: [{ elevation: 1, nyquist: 1e308, slope: 1e-3 }],
      moments: [['VRAD', 'velocity']],
    });
    expect(volume.grid.foldFrom).to.equal(undefined);
  });
});

describe('the table of a radar on the GPU', () => {
  const sweepOf = (elevation: number, radials: number, gates: number): Sweep => ({
    elevation,
    azimuths: Float64Array.from(evenAzimuths(radials)),
    firstGate: 500,
    gateLength: 1000,
    gates,
    offset: 0,
  });
  const gridOf = (sweeps: readonly Sweep[]): PolarGrid => ({ sweeps }) as PolarGrid;

  it('is counted before it is made', () => {
    const wide = gridOf([
      sweepOf(0, 20_000, 1),
      ...Array.from({ length: 150 }, (_, i) => sweepOf(0.2 + 0.2 * i, 1, 1)),
    ]);
    expect(buildPolarTable(wide, layOutRadials(wide, 16_384)!, 16_384)).to.equal(null);
    // Few radials, but each sweep begins a row: its numbers go on by thousands.
    const sparse = gridOf(Array.from({ length: 200 }, (_, i) => sweepOf(0.2 * i, 1, 1 + (i % 2))));
    const layout = { ...layOutRadials(sparse, 16_384)!, numbers: 2 ** 22 };
    expect(buildPolarTable(sparse, layout, 16_384)).to.equal(null);
    const small = gridOf([sweepOf(1, 360, 100), sweepOf(2, 360, 100)]);
    expect(buildPolarTable(small, layOutRadials(small, 4096)!, 4096)!.height).to.be.below(10);
    expect(buildPolarTable(small, layOutRadials(small, 4096)!, 1)).to.equal(null);
  });

  it('finds a width in a bounded number of rounds', () => {
    let looked = 0;
    const sweeps = Array.from({ length: 512 }, (_, i) => {
      const sweep = sweepOf(0.1 * i, 2, 0);
      return Object.defineProperty({ ...sweep }, 'gates', { get: () => (looked++, i + 1) });
    });
    expect(layOutRadials(gridOf(sweeps), 16_384)).to.not.equal(null);
    expect(looked).to.be.below(5_000_000);
  });
});

describe('a sweep that is left out for another one', () => {
  it('is reported to the page', () => {
    const volume = radarVolume({ sweeps: [{ elevation: 0.3, gates: 30 }, { elevation: 0.4 }] });
    expect(volume.grid.sweeps).to.have.length(1);
    expect(describeVolume(volume).left).to.deep.equal(['sweep 2 at 0.4° is left out for sweep 1 at 0.3°']);
    expect(describeVolume(radarVolume({ sweeps: [{ elevation: 1 }] })).left).to.deep.equal([]);
  });
});
