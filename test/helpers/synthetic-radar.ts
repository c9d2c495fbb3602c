import { buildPolarVolume } from '../../src/formats/radar/build-polar-volume.ts';
import type { PolarSettings } from '../../src/formats/base/radar-settings.ts';
import { outlinePolar } from '../../src/formats/radar/finish-polar.ts';
import type { DecodedPolarVolume } from '../../src/formats/base/decoded-volume.ts';
import type { MomentKind, RadarFile, RadarSweep, SweepData } from '../../src/formats/radar/radar-file.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { PolarVolume, Volume } from '../../src/volume/volume.ts';
import { randomNumbers } from './synthetic.ts';
import type { SampleKind } from './synthetic.ts';

export interface SweepOptions {
  readonly elevation: number;
  /** The middles of the rays, in the file's order; 24 rays around the circle if absent. */
  readonly azimuths?: readonly number[];
  /** The elevation of each ray; that of the sweep if absent. */
  readonly rayElevation?: (azimuth: number, ray: number) => number;
  readonly firstGate?: number;
  readonly gateLength?: number;
  readonly gates?: number;
  readonly kind?: SampleKind;
  readonly slope?: number;
  readonly intercept?: number;
  readonly nyquist?: number;
  /** The moments of the sweep; all if absent. */
  readonly moments?: readonly string[];
  /** The stored value of a gate, in its own type. If absent: numbers from 1 up that never repeat. */
  readonly stored?: (azimuth: number, gate: number, ray: number) => number;
}

export interface RadarOptions {
  readonly sweeps: readonly SweepOptions[];
  readonly beamWidth?: number;
  readonly moments?: readonly [name: string, kind: MomentKind][];
}

/** Rays at equal distances around the circle, the first one half a step from north. */
export function evenAzimuths(rays: number, first = 180 / rays): number[] {
  return Array.from({ length: rays }, (_, i) => first + (i * 360) / rays);
}

/** A synthetic radar file with the given sweeps. */
export function syntheticRadar({ sweeps, beamWidth, moments = [['DBZH', 'reflectivity']] }: RadarOptions): RadarFile {
  return {
    format: 'synthetic radar',
    site: { name: 'here', latitude: 50, longitude: 6, height: 100 },
    time: '2020-02-07T13:00:00Z',
    moments: moments.map(([name, kind]) => ({ name, unit: kind === 'velocity' ? 'm/s' : 'dBZ', kind })),
    sweeps: sweeps.map((sweep, i) =>
      syntheticSweep(
        sweep,
        moments.map(([name]) => name),
        i,
      ),
    ),
    ...(beamWidth === undefined ? {} : { beamWidth }),
  };
}

function syntheticSweep(options: SweepOptions, all: readonly string[], seed: number): RadarSweep {
  const { elevation, azimuths = evenAzimuths(24), rayElevation, nyquist, moments = all } = options;
  const data = syntheticData(options, azimuths, seed);
  return {
    elevation,
    azimuths: Float64Array.from(azimuths),
    ...(rayElevation ? { elevations: Float64Array.from(azimuths, rayElevation) } : {}),
    moments,
    gridOf: (moment) => (moments.includes(moment) ? data : null),
    read: (moment) => (moments.includes(moment) ? data : null),
    ...(nyquist === undefined ? {} : { nyquist }),
  };
}

function syntheticData(options: SweepOptions, azimuths: readonly number[], seed: number): SweepData {
  const { firstGate = 500, gateLength = 1000, gates = 20, kind = 'uint8', slope = 0.5, intercept = -32 } = options;
  const random = randomNumbers(seed + 100);
  const max = { uint8: 254, uint16: 65534, float32: 1 }[kind];
  const stored = options.stored ?? (() => (kind === 'float32' ? random() : 1 + Math.round(max * random())));
  const samples = new { uint8: Uint8Array, uint16: Uint16Array, float32: Float32Array }[kind](azimuths.length * gates);
  azimuths.forEach((azimuth, ray) => {
    for (let gate = 0; gate < gates; gate++) samples[ray * gates + gate] = stored(azimuth, gate, ray);
  });
  return { firstGate, gateLength, gates, samples, slope, intercept };
}

/** Make the volume from a reader's result, as the worker does. */
export function finishPolar(decoded: DecodedPolarVolume): PolarVolume {
  return { ...outlinePolar(decoded), macrocells: decoded.makeMacrocells() };
}

/** The volume that the reader of such a file would return. */
export function radarVolume(options: RadarOptions, settings: PolarSettings = {}): PolarVolume {
  return finishPolar(buildPolarVolume(syntheticRadar(options), settings));
}

/** Narrow the type of a volume that is known to be a radar volume. */
export function asPolar(volume: Volume): PolarVolume {
  if (!isPolar(volume)) throw new TypeError(`the volume got a ${volume.grid.kind} grid; expected a polar one`);
  return volume;
}

const random = randomNumbers(90);
const jitter = (step: number): number[] =>
  evenAzimuths(360 / step).map((azimuth) => azimuth + 0.6 * step * (random() - 0.5));
/** Forty rays in six degrees. */
const crowd = (first: number): number[] => Array.from({ length: 40 }, (_, i) => first + 0.15 * i);
/** A third of the gates have no data. */
const holes: SweepOptions['stored'] = (azimuth, gate) =>
  (Math.floor(azimuth) * 7 + gate * 13) % 3 === 0 ? 0 : 40 + ((Math.floor(azimuth) * 31 + gate * 17) % 200);
const folded: SweepOptions['stored'] = (azimuth, gate) => 1 + Math.round((azimuth * 3 + gate * 11) % 250);
/** Kinds of echo in patches of some gates and radials, from 10 to 140 as in NEXRAD Level III, and a patch without data. */
export const kindsInPatches: SweepOptions['stored'] = (azimuth, gate) =>
  gate > 16 && azimuth > 300 ? 0 : 10 * (1 + ((5 * Math.floor(azimuth / 60) + 9 * Math.floor(gate / 7)) % 14));
/** An elevation that goes up and down by `height` degrees, three times around the circle. */
const wave =
  (elevation: number, height: number, phase = 0) =>
  (azimuth: number): number =>
    elevation + height * Math.sin((3 * azimuth * Math.PI) / 180 + phase);
const lowSweeps: SweepOptions[] = [0.5, 1.5, 3, 6, 12].map((elevation) => ({ elevation }));

/** Sweeps of a real scan: higher sweeps are shorter, because there is no weather so high. */
export const unequalSweeps: RadarOptions = {
  sweeps: [1832, 1192, 916, 617, 410, 308, 192, 131].map((gates, i) => ({
    elevation: 0.5 + 2 * i,
    gates,
    gateLength: 250,
    azimuths: evenAzimuths(i < 1 ? 720 : 360),
    stored: (azimuth, gate) => (gate < 100 ? 1 + (Math.floor(azimuth) % 50) : 0),
  })),
};

/** Difficult scenes for a sampler of polar volumes. */
export const polarScenes: Record<string, RadarOptions> = {
  'five sweeps': { sweeps: lowSweeps },
  '16 bit': { sweeps: lowSweeps.map((sweep) => ({ ...sweep, kind: 'uint16' })) },
  float: { sweeps: lowSweeps.map((sweep) => ({ ...sweep, kind: 'float32', slope: 1, intercept: 0 })) },
  'floats without data': {
    sweeps: lowSweeps.map((sweep) => ({
      ...sweep,
      kind: 'float32',
      slope: 1,
      intercept: 0,
      stored: (a, g) => holes(a, g, 0) || NaN,
    })),
  },
  holes: { sweeps: lowSweeps.map((sweep) => ({ ...sweep, stored: holes })) },
  'one sweep': { sweeps: [{ elevation: 2 }], beamWidth: 3 },
  'sixty sweeps': {
    sweeps: Array.from({ length: 60 }, (_, i) => ({
      elevation: 0.3 + 1.5 * i,
      gates: 12,
      azimuths: evenAzimuths(16 + (i % 5)),
    })),
  },
  'to the poles': { sweeps: [-90, -30, 0, 45, 90].map((elevation) => ({ elevation, gates: 8 })) },
  'a sweep straight up': { sweeps: [1.5, 12, 25, 90].map((elevation) => ({ elevation })) },
  'a sweep straight up, with rays of their own elevations': {
    sweeps: [
      ...[1.5, 12, 25].map((elevation, i) => ({ elevation, rayElevation: wave(elevation, 0.3, i) })),
      { elevation: 90 },
    ],
  },
  'rays and gates that differ': {
    sweeps: [
      { elevation: 0.5, azimuths: evenAzimuths(36), gates: 40, gateLength: 500, firstGate: 250 },
      { elevation: 2, azimuths: evenAzimuths(24, 3), gates: 15, gateLength: 1000, firstGate: 3000 },
      { elevation: 8, azimuths: evenAzimuths(18, 0), gates: 9, gateLength: 1500, firstGate: 1200 },
    ],
  },
  'a sector of one degree': {
    sweeps: [1, 2, 4].map((elevation) => ({ elevation, azimuths: [359.6, 359.8, 0, 0.2, 0.4, 0.6] })),
  },
  'one ray': { sweeps: [1, 2].map((elevation) => ({ elevation, azimuths: [200] })), beamWidth: 2 },
  'missing rays': {
    sweeps: lowSweeps.map((sweep, i) => ({
      ...sweep,
      azimuths: evenAzimuths(24).filter((_, ray) => (ray + i) % 7 !== 0),
    })),
  },
  'uneven azimuths': { sweeps: lowSweeps.map((sweep) => ({ ...sweep, azimuths: jitter(10) })) },
  'rays that crowd': {
    sweeps: lowSweeps.map((sweep, i) => ({ ...sweep, azimuths: [...crowd(20 * i + 0.01), ...evenAzimuths(8, 3)] })),
  },
  'gates that fold into rows': {
    sweeps: [97, 41, 23, 12, 5].map((gates, i) => ({
      elevation: 1 + 2 * i,
      gates,
      gateLength: 20_000 / gates,
      azimuths: evenAzimuths(37 + i, i),
    })),
  },
  'rays of their own elevations': {
    sweeps: lowSweeps.map((sweep, i) => ({
      ...sweep,
      azimuths: evenAzimuths(24 + 5 * i),
      rayElevation: wave(sweep.elevation, 0.4, i),
    })),
  },
  'sweeps that cross': {
    sweeps: [1, 1.6, 2.2, 3, 6].map((elevation, i) => ({
      elevation,
      azimuths: evenAzimuths(24 + i, 2),
      rayElevation: wave(elevation, i < 3 ? 0.7 : 0.1, 2 * i),
    })),
  },
  folds: {
    sweeps: lowSweeps.map((sweep) => ({ ...sweep, nyquist: 30, stored: folded })),
    moments: [['VRAD', 'velocity']],
  },
  'kinds of echo': {
    sweeps: lowSweeps.map((sweep) => ({ ...sweep, slope: 1, intercept: 0, stored: kindsInPatches })),
    moments: [['HCA', 'kinds']],
  },
};
