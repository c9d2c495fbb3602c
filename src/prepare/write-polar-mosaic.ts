import type { GrayImage } from '../volume/mosaic.ts';
import type { Manifest } from '../formats/manifest/manifest.ts';
import type { ManifestSweep, PolarMosaicSettings } from '../formats/base/radar-settings.ts';
import { ownElevations } from '../formats/radar/arrange-elevations.ts';
import { checkBeamWidth } from '../formats/radar/beam-width.ts';
import { chooseMoment, chooseSweeps } from '../formats/radar/choose-sweeps.ts';
import type { ChosenSweep } from '../formats/radar/choose-sweeps.ts';
import { isFolding } from '../formats/radar/moment-kind.ts';
import type { RadarFile, RadarMoment, RadarSweep, SweepData } from '../formats/radar/radar-file.ts';
import { ErrorSum } from './measure-error.ts';

/** Maximum error of the written angles, degrees. */
const finestAngle = 1e-5;

/** The largest value of a 16-bit pixel. */
const highestPixel = 65535;

/** An image, and a manifest that lacks only the name of the image. */
export interface WrittenMosaic {
  readonly image: GrayImage;
  /** In JSON, `mosaic` is a text: 'COLUMNSxROWS'. */
  readonly manifest: Omit<Manifest, 'image' | 'mosaic' | 'labels'> & {
    readonly mosaic: string;
    readonly labels?: PolarMosaicSettings['labels'];
  };
  /** Largest difference between a value of the file and the value in the mosaic; 0 where integers are kept as they are. */
  readonly rounding: number;
  /** Root mean square of these differences. */
  readonly rms: number;
}

/**
 * Write one moment of a radar file as a mosaic: the sweeps that a volume of the file would show, one tile each, in the order of their
 * elevations; radials and gates as they are in the file. Integers are kept. Floats, and integers on scales that differ, become 16-bit
 * pixels: 65,534 equal steps from the smallest value to the largest, or steps of 1 where all are whole numbers.
 * @param moment - its name in the file; where undefined, the reflectivity that the largest number of sweeps have
 * @throws {VolumeViewError} as a volume of the file does
 */
export function writePolarMosaic(file: RadarFile, moment?: string): WrittenMosaic {
  const chosenMoment = chooseMoment(file, moment);
  const { chosen } = chooseSweeps(file, chosenMoment.name, checkBeamWidth(file.beamWidth));
  const { pixels, slope, intercept, rounding, rms, isWide } = makePixels(chosen.map(({ data }) => data));
  const width = Math.max(...chosen.map(({ data }) => data.gates));
  const height = Math.max(...chosen.map(({ sweep }) => sweep.azimuths.length));
  const columns = Math.max(1, Math.min(chosen.length, Math.round(Math.sqrt((chosen.length * height) / width))));
  const rows = Math.ceil(chosen.length / columns);
  const data = new (isWide ? Uint16Array : Uint8Array)(columns * width * rows * height);
  chosen.forEach(({ data: { gates }, sweep }, i) => {
    const first = Math.floor(i / columns) * height * columns * width + (i % columns) * width;
    for (let radial = 0; radial < sweep.azimuths.length; radial++) {
      data.set(pixels[i].subarray(radial * gates, (radial + 1) * gates), first + radial * columns * width);
    }
  });
  return {
    image: { width: columns * width, height: rows * height, data },
    manifest: {
      mosaic: `${columns}x${rows}`,
      slices: chosen.length,
      slope,
      intercept,
      ...describe(file, chosenMoment, chosen, { width, height }),
    },
    rounding,
    rms,
  };
}

interface Pixels {
  /** One array for each sweep, 0 for no data. */
  readonly pixels: readonly (Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>)[];
  readonly slope: number;
  readonly intercept: number;
  readonly rounding: number;
  readonly rms: number;
  readonly isWide: boolean;
}

function makePixels(sweeps: readonly SweepData[]): Pixels {
  const [{ slope, intercept }] = sweeps;
  const kept = sweeps.map(({ samples }) => samples).filter((samples) => !(samples instanceof Float32Array));
  const isSame = sweeps.every((data) => data.slope === slope && data.intercept === intercept);
  if (isSame && kept.length === sweeps.length) {
    return {
      pixels: kept,
      slope,
      intercept,
      rounding: 0,
      rms: 0,
      isWide: kept.some((samples) => samples instanceof Uint16Array),
    };
  }
  return quantise(sweeps);
}

function quantise(sweeps: readonly SweepData[]): Pixels {
  let [low, high, isWhole] = [Infinity, -Infinity, true];
  for (const data of sweeps) {
    eachValue(data, (value) => {
      low = Math.min(low, value);
      high = Math.max(high, value);
      isWhole &&= Number.isInteger(value);
    });
  }
  if (high < low) [low, high] = [0, 0];
  // Whole numbers, such as kinds of echo, are kept as they are.
  const isKept = isWhole && high - low < highestPixel;
  const slope = high > low && !isKept ? (high - low) / (highestPixel - 1) : 1;
  // The smallest value is pixel 1: 0 means no data.
  const intercept = low - slope;
  const sum = new ErrorSum();
  const pixels = sweeps.map((data) => {
    const written = new Uint16Array(data.samples.length);
    eachValue(data, (value, i) => {
      written[i] = Math.round((value - intercept) / slope);
      sum.add(slope * written[i] + intercept - value);
    });
    return written;
  });
  return { pixels, slope, intercept, rounding: isKept ? 0 : slope / 2, rms: sum.error.rms, isWide: true };
}

/** Visit every gate that has data. */
function eachValue({ samples, slope, intercept }: SweepData, visit: (value: number, index: number) => void): void {
  const isFloat = samples instanceof Float32Array;
  for (let i = 0; i < samples.length; i++) {
    if (isFloat ? Number.isFinite(samples[i]) : samples[i] !== 0) visit(slope * samples[i] + intercept, i);
  }
}

type Described = Omit<WrittenMosaic['manifest'], 'mosaic' | 'slices' | 'slope' | 'intercept'>;

/** The fields of the manifest. A field that is the same for all tiles is written once. */
function describe(
  file: RadarFile,
  moment: RadarMoment,
  chosen: readonly ChosenSweep[],
  tile: { width: number; height: number },
): Described {
  const ranges = chosen.map(({ data }) => [data.firstGate, data.gateLength] as const);
  const directions = chosen.map(({ sweep }) => describeAzimuths(sweep.azimuths));
  const nyquists = chosen.map(({ sweep }) => (isFolding(moment) ? sweep.nyquist : undefined));
  const range = sameOf(ranges);
  const azimuth = sameOf(directions.map((direction) => direction.azimuth));
  const nyquist = sameOf(nyquists);
  const sweeps = chosen.map(({ sweep, data }, i): ManifestSweep => ({
    ...(sweep.azimuths.length === tile.height ? {} : { rays: sweep.azimuths.length }),
    ...(data.gates === tile.width ? {} : { gates: data.gates }),
    ...(range ? {} : { range: ranges[i] }),
    ...(azimuth ? {} : directions[i]),
    ...describeElevations(sweep),
    ...(nyquist === undefined && nyquists[i] !== undefined ? { nyquist: nyquists[i] } : {}),
    ...(sweep.time === undefined ? {} : { time: sweep.time }),
  }));
  return {
    unit: moment.unit,
    moment: moment.name,
    elevations: chosen.map(({ sweep }) => sweep.elevation),
    ...(range ? { range } : {}),
    ...(azimuth ? { azimuth } : {}),
    ...(file.beamWidth === undefined ? {} : { beamWidth: file.beamWidth }),
    ...(nyquist === undefined ? {} : { nyquist }),
    ...(moment.kind === 'kinds' && {
      labels: (moment.numbers ?? []).map((id) => ({ id })),
    }),
    site: file.site,
    ...(file.time === undefined ? {} : { time: file.time }),
    ...(sweeps.some((sweep) => Object.keys(sweep).length > 0) ? { sweeps } : {}),
  };
}

/** The first radial and the step where radials are evenly spaced, else all radials. */
function describeAzimuths(azimuths: Float64Array): Pick<ManifestSweep, 'azimuth' | 'azimuths'> {
  const [first] = azimuths;
  const around = 360 / azimuths.length;
  const steps = [around, Math.round(around), azimuths.length > 1 ? azimuths[1] - first : 1, -around];
  const step = steps.find((one) => one !== 0 && azimuths.every((azimuth, i) => isSameAngle(azimuth, first + i * one)));
  if (step !== undefined) return { azimuth: [first, step] };
  return { azimuths: writeAngles(azimuths) };
}

/** The elevation of each radial, where they differ from that of the sweep. */
function describeElevations(sweep: RadarSweep): Pick<ManifestSweep, 'elevations'> {
  const elevations = ownElevations(sweep);
  return elevations ? { elevations: writeAngles(elevations) } : {};
}

function writeAngles(angles: Float64Array): number[] {
  return Array.from(angles, (angle) => Number(angle.toFixed(5)));
}

function isSameAngle(a: number, b: number): boolean {
  const apart = Math.abs(a - b) % 360;
  return Math.min(apart, 360 - apart) < finestAngle;
}

/** The value that is the same in all, compared as JSON; undefined where they differ. */
function sameOf<T>(values: readonly T[]): T | undefined {
  const [first] = values;
  return values.every((value) => JSON.stringify(value) === JSON.stringify(first)) ? first : undefined;
}
