import { expect } from '@esm-bundle/chai';
import type { RadarFile, SweepData } from '../../src/formats/radar/radar-file.ts';

/** The data that another program reads from a radar file. test/fixtures/make-radar-fixtures.py writes it, and names the program. */
export interface ExpectedRadar {
  readonly path: string;
  readonly source: string;
  /** Degrees north, degrees east, metres. */
  readonly site: readonly [number, number, number];
  readonly time: string;
  readonly beamWidth: number | null;
  readonly sweeps: readonly ExpectedSweep[];
  /** The sweep, ray and gate of each value, one value after another. */
  readonly gates: readonly number[];
  /** By name: the unit ('m/s' for 'meters_per_second'), and a value for each of `gates`; null for no data. */
  readonly moments: Readonly<Record<string, { readonly unit: string; readonly values: readonly (number | null)[] }>>;
}

export interface ExpectedSweep {
  readonly elevation: number;
  readonly rays: number;
  readonly gates: number;
  /** Some azimuths: ray and azimuth. */
  readonly azimuths: readonly (readonly [number, number])[];
  readonly firstGate: number;
  readonly gateLength: number;
  readonly time: string | null;
  readonly nyquist: number | null;
}

export async function readExpected(name: string): Promise<readonly ExpectedRadar[]> {
  const response = await fetch(`/test/fixtures/${name}`);
  return ((await response.json()) as { files: ExpectedRadar[] }).files;
}

/** Data values in double precision; NaN where there is no data. */
export function gateValues(data: SweepData): Float64Array {
  return Float64Array.from(data.samples, (sample) => valueOf(data, sample));
}

function valueOf({ samples, slope, intercept }: SweepData, sample: number): number {
  const empty = samples instanceof Float32Array ? NaN : 0;
  return sample === empty || Number.isNaN(sample) ? NaN : slope * sample + intercept;
}

/** Half a unit of the seventh digit, to which the expected numbers are rounded, and the rounding of float32. */
const tolerance = (value: number): number => 1e-6 * Math.abs(value) + 1e-6;

/** Compare all data that another program reads from a file: site, times, sweeps, geometry, moments and values. */
export function compareRadar(radar: RadarFile, expected: ExpectedRadar): void {
  compareHead(radar, expected);
  expect(radar.sweeps.length).to.equal(expected.sweeps.length);
  for (const [i, sweep] of radar.sweeps.entries()) {
    const wanted = expected.sweeps[i];
    const where = `sweep ${i}`;
    expect(sweep.elevation, where).to.be.closeTo(wanted.elevation, tolerance(wanted.elevation));
    expect(sweep.azimuths.length, where).to.equal(wanted.rays);
    for (const [ray, azimuth] of wanted.azimuths) {
      const off = Math.abs(((sweep.azimuths[ray] - azimuth + 540) % 360) - 180);
      expect(off, `${where}, ray ${ray}: ${sweep.azimuths[ray]} for ${azimuth}`).to.be.at.most(3e-5); // The rounding of float32 at 360.
    }
    if (wanted.time !== null) expect(sweep.time, where).to.equal(wanted.time);
    if (wanted.nyquist === null) expect(sweep.nyquist, where).to.equal(undefined);
    else expect(sweep.nyquist, where).to.be.closeTo(wanted.nyquist, tolerance(wanted.nyquist));
  }
  for (const [moment, { values }] of Object.entries(expected.moments)) compareValues(radar, expected, moment, values);
}

function compareHead(radar: RadarFile, expected: ExpectedRadar): void {
  const [latitude, longitude, height] = expected.site;
  expect(radar.site.latitude).to.be.closeTo(latitude, tolerance(latitude));
  expect(radar.site.longitude).to.be.closeTo(longitude, tolerance(longitude));
  expect(radar.site.height).to.be.closeTo(height, tolerance(height));
  expect(radar.time).to.equal(expected.time);
  if (expected.beamWidth === null) expect(radar.beamWidth).to.equal(undefined);
  else expect(radar.beamWidth).to.be.closeTo(expected.beamWidth, tolerance(expected.beamWidth));
  expect(radar.moments.map(({ name }) => name)).to.have.members(Object.keys(expected.moments));
  for (const { name, unit } of radar.moments) expect(unit, name).to.equal(expected.moments[name].unit);
  expect(radar.partial).to.equal(undefined);
}

function compareValues(
  radar: RadarFile,
  expected: ExpectedRadar,
  moment: string,
  values: readonly (number | null)[],
): void {
  const data = radar.sweeps.map((sweep) => sweep.read(moment));
  for (const [i, sweep] of data.entries()) {
    expect(sweep !== null, `${moment}, sweep ${i}`).to.equal(radar.sweeps[i].moments.includes(moment));
    if (!sweep) continue;
    const wanted = expected.sweeps[i];
    expect(sweep.gates).to.equal(wanted.gates);
    expect(sweep.samples.length).to.equal(wanted.rays * wanted.gates);
    expect(sweep.firstGate).to.be.closeTo(wanted.firstGate, 0.001);
    expect(sweep.gateLength).to.be.closeTo(wanted.gateLength, 1e-4);
  }
  const places = expected.gates;
  for (const [n, value] of values.entries()) {
    const [sweep, ray, gate] = places.slice(3 * n, 3 * n + 3);
    const read = data[sweep];
    const got = read ? valueOf(read, read.samples[ray * read.gates + gate]) : NaN;
    const where = `${moment}, sweep ${sweep}, ray ${ray}, gate ${gate}: ${got} for ${value}`;
    if (value === null) {
      expect(Number.isNaN(got), where).to.equal(true);
      continue;
    }
    // Py-ART multiplies and adds in float32: if the value is small, the error is the rounding of the offset.
    const rounding = 2 ** -23 * Math.abs(data[sweep]!.intercept);
    expect(Math.abs(got - value), where).to.be.at.most(tolerance(value) + rounding);
  }
}
