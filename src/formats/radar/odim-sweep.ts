import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import type { AttributeValue, DataArray, DataGroup } from '../base/data-tree.ts';
import { packGates } from './gate-samples.ts';
import { momentKindOf } from './moment-kind.ts';
import { odimUnit } from './odim-units.ts';
import {
  findAttribute,
  findNumber,
  findText,
  isInMetres,
  joinTime,
  listGroups,
  requireNumber,
} from './odim-attributes.ts';
import type { Lineage } from './odim-attributes.ts';
import type { RadarMoment, RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { anyFileBytes, refuseSweep } from './radar-limits.ts';

/**
 * Memory for a radial's angles while they are read, as numbers or as text; and the maximum number of characters for the
 * two angles in such a text.
 */
const bytesPerRadial = 128;
const longestPair = 64;

export interface OdimSweep extends RadarSweep {
  readonly found: readonly RadarMoment[];
}

/** A moment's values in the file. */
interface Stored {
  readonly array: DataArray;
  readonly lineage: Lineage;
}

/**
 * Reads one scan: a group 'dataset…' of a file; null if it holds no moments.
 * @param version - of ODIM_H5, such as '2.2': units depend on it
 * @param budget - the angles of its radials are taken from it
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function readOdimSweep(
  root: DataGroup,
  dataset: DataGroup,
  version = '2.2',
  budget = Budget.ofFile(anyFileBytes),
): OdimSweep | null {
  const stored = findMoments(root, dataset);
  const [first] = stored.values();
  if (!first) return null;
  const lineage = [dataset, root];
  const [radials] = first.array.shape;
  budget.take(radials * bytesPerRadial, `the angles of ${dataset.path}`);
  const time = joinTime(findText(lineage, 'what', 'startdate'), findText(lineage, 'what', 'starttime'));
  const nyquist = readNyquist(first.lineage);
  const elevations = readElevations(first.lineage, radials);
  return {
    elevation: requireNumber(lineage, 'where', 'elangle', [-90, 180]),
    azimuths: readAzimuths(first.lineage, radials),
    ...(elevations ? { elevations } : {}),
    ...(time ? { time } : {}),
    ...(nyquist === undefined ? {} : { nyquist }),
    moments: [...stored.keys()],
    left: describeRange(first, version),
    faultOf: (moment) => describeFault(stored.get(moment)?.lineage ?? lineage),
    found: [...stored.keys()].map((name) => describe(name, version)),
    gridOf: (moment) => {
      const found = stored.get(moment);
      return found ? readGrid(found, version) : null;
    },
    read: (moment) => {
      const found = stored.get(moment);
      return found ? readGates(found, version) : null;
    },
  };
}

/** The arrays of a scan by their quantity; of two with one name, the first. */
function findMoments(root: DataGroup, dataset: DataGroup): Map<string, Stored> {
  const stored = new Map<string, Stored>();
  for (const group of listGroups(dataset, 'data')) {
    const array = group.array('data');
    const lineage = [group, dataset, root];
    const quantity = findText(lineage, 'what', 'quantity');
    if (!array || !quantity || stored.has(quantity)) continue;
    checkShape(array, lineage);
    const [radials] = array.shape;
    const [known] = stored.values();
    if (known && known.array.shape[0] !== radials) {
      throw new VolumeViewError(
        'format/corrupt',
        `${array.path} got ${radials} radials; expected ${known.array.shape[0]}, as ${known.array.path} has`,
      );
    }
    stored.set(quantity, { array, lineage });
  }
  return stored;
}

function checkShape(array: DataArray, lineage: Lineage): void {
  const [radials, gates] = array.shape;
  if (array.shape.length !== 2) {
    throw new VolumeViewError(
      'format/corrupt',
      `${array.path} got ${array.shape.length} axes; expected 2, radials and gates`,
    );
  }
  refuseSweep(array.path, radials, gates);
  const stated = [findNumber(lineage, 'where', 'nrays') ?? radials, findNumber(lineage, 'where', 'nbins') ?? gates];
  if (stated[0] === radials && stated[1] === gates) return;
  throw new VolumeViewError(
    'format/corrupt',
    `${array.path} got ${radials} radials of ${gates} gates; expected ${stated.join(' of ')}, as where/nrays and where/nbins say`,
  );
}

function describe(name: string, version: string): RadarMoment {
  const unit = odimUnit(name, isInMetres(version));
  return { name, unit, kind: momentKindOf({ name, unit }) };
}

/**
 * Middles of the radials: between each one's start and stop angles, if the file has them; else in equal steps from
 * north or from `astart`, where the first radial starts.
 */
function readAzimuths(lineage: Lineage, radials: number): Float64Array<ArrayBuffer> {
  const [starts, stops] = readAngles(lineage, radials) ?? [];
  const azimuths = new Float64Array(radials);
  const sector = readSector(lineage);
  for (let radial = 0; radial < radials; radial++) {
    const middle =
      starts && stops
        ? starts[radial] + turnTo(stops[radial] - starts[radial]) / 2
        : sector.from + ((radial + 0.5) * sector.width) / radials;
    azimuths[radial] = wrap(middle);
  }
  return azimuths;
}

/** Angles at which each radial starts and stops; in version 2.0 as a text, '0:1,1:2,…'. */
function readAngles(lineage: Lineage, radials: number): readonly [Float64Array, Float64Array] | null {
  const starts = findAttribute(lineage, 'how', ['startazA']);
  const stops = findAttribute(lineage, 'how', ['stopazA']);
  if (isAngles(starts, radials)) return [starts, isAngles(stops, radials) ? stops : nextStarts(starts)];
  const text = findText(lineage, 'how', 'azangles');
  if (text === undefined || text.length > radials * longestPair) return null;
  const pairs = text.split(',').map((pair) => pair.split(':').map(Number));
  if (pairs.length !== radials) return null;
  const both = [0, 1].map((side) => Float64Array.from(pairs, (pair) => pair[side]));
  return both.every((angles) => isAngles(angles, radials)) ? [both[0], both[1]] : null;
}

/** Elevations of the radials: the file's, or half way between those at which each starts and stops. */
function readElevations(lineage: Lineage, radials: number): Float64Array<ArrayBuffer> | undefined {
  const stated = findAttribute(lineage, 'how', ['elangles']);
  if (isAngles(stated, radials)) return Float64Array.from(stated, turnTo);
  const starts = findAttribute(lineage, 'how', ['startelA']);
  const stops = findAttribute(lineage, 'how', ['stopelA']);
  if (!isAngles(starts, radials) || !isAngles(stops, radials)) return undefined;
  return Float64Array.from(starts, (start, radial) => turnTo(start + turnTo(stops[radial] - start) / 2));
}

/** If the file has only start angles, each radial stops where the next starts; the last is as wide as the one before. */
function nextStarts(starts: Float64Array): Float64Array {
  const last = starts.length - 1;
  return starts.map((start, radial) =>
    radial < last ? starts[radial + 1] : start + (last > 0 ? turnTo(start - starts[last - 1]) : 360),
  );
}

function isAngles(value: AttributeValue | undefined, radials: number): value is Float64Array {
  return (
    value instanceof Float64Array &&
    value.length === radials &&
    value.every((angle) => Number.isFinite(angle) && Math.abs(angle) <= 720)
  );
}

/** Where the first radial starts, and the angle that all cover: the whole circle, or the sector of an AZIM object. */
function readSector(lineage: Lineage): { from: number; width: number } {
  const from = findNumber(lineage, 'where', 'startaz');
  const to = findNumber(lineage, 'where', 'stopaz');
  if (from !== undefined && to !== undefined && Number.isFinite(from + to))
    return { from, width: wrap(to - from) || 360 };
  const start = findNumber(lineage, 'how', 'astart') ?? 0;
  return { from: Number.isFinite(start) ? start : 0, width: 360 };
}

/**
 * The speed at which velocities fold: the file's, or computed from its wavelength (cm) and pulse rates (Hz); a second
 * pulse rate increases it. Source: Doviak and Zrnić, Doppler Radar and Weather Observations, 1993, chapters 3 and 7
 */
function readNyquist(lineage: Lineage): number | undefined {
  const stated = findNumber(lineage, 'how', 'NI');
  if (stated !== undefined && stated > 0) return stated;
  const wavelength = readWavelength(lineage);
  const high = findNumber(lineage, 'how', 'highprf') ?? NaN;
  const low = findNumber(lineage, 'how', 'lowprf') ?? 0;
  const rate = low > 0 && low < high ? (high * low) / (high - low) : high;
  const nyquist = (wavelength * rate) / 4;
  return nyquist > 0 && nyquist < 1000 ? nyquist : undefined;
}

const lightSpeed = 299_792_458;

/** Wavelength in metres: from the frequency (Hz), which replaced it in 2.4, or from centimetres. */
function readWavelength(lineage: Lineage): number {
  const frequency = findNumber(lineage, 'how', 'frequency');
  const centimetres = findNumber(lineage, 'how', 'wavelength');
  if (centimetres !== undefined && centimetres > 0) return centimetres / 100;
  return frequency !== undefined && frequency > 0 ? lightSpeed / frequency : NaN;
}

/** Degrees from a start to a stop, -180 to 180: radars turn in either direction. */
function turnTo(degrees: number): number {
  return wrap(degrees + 180) - 180;
}

function wrap(degrees: number): number {
  const rest = degrees % 360;
  // A tiny negative angle becomes 360 itself in floating point.
  return rest < 0 ? (rest + 360) % 360 : rest;
}

/** @throws {VolumeViewError} `format/corrupt` */
function readGrid({ array, lineage }: Stored, version: string): SweepGates {
  const gateLength = requireNumber(lineage, 'where', 'rscale', [0.01, 1e5]);
  const { metres, stated } = readStart(lineage, version, gateLength);
  if (!(Math.abs(metres) < farthestStart)) {
    throw new VolumeViewError(
      'format/corrupt',
      `${array.path} got rstart ${stated}; expected where the first gate begins, in ${isInMetres(version) ? 'metres, as ODIM_H5 2.4 has it' : 'kilometres'}`,
    );
  }
  return { firstGate: metres + gateLength / 2, gateLength, gates: array.shape[1] };
}

/** Metres: no radar's first gate begins farther away. */
const farthestStart = 1e6;

/**
 * A first gate this many kilometres away or more was written in metres; one this few metres away or less, in
 * kilometres.
 */
const implausible = { kilometres: 100, metres: 10 } as const;

/** A start in kilometres is a multiple of the gate length divided by this. */
const partsOfGate = 4;

/** Where the first gate begins. */
interface Start {
  readonly metres: number;
  readonly stated: number;
  /** Whether this contradicts the unit of the file's version. */
  readonly isAssumed: boolean;
}

/**
 * `rstart` is in kilometres up to ODIM_H5 2.3 and in metres from 2.4 on. Some programs write one and declare the other
 * version: a value that is plausible only in the other unit is read in that unit. Sources: ODIM_H5 2.3 and 2.4, table
 * 5; xradar 0.12 goes by the version alone, Py-ART 2.3 and wradlib 2.9 always assume kilometres
 */
function readStart(lineage: Lineage, version: string, gateLength: number): Start {
  const stated = findNumber(lineage, 'where', 'rstart') ?? 0;
  if (!isInMetres(version)) {
    const isAssumed = Math.abs(stated) >= implausible.kilometres;
    return { metres: isAssumed ? stated : 1000 * stated, stated, isAssumed };
  }
  const parts = (1000 * stated * partsOfGate) / gateLength;
  const isAssumed = stated > 0 && stated < implausible.metres && Math.abs(parts - Math.round(parts)) < 1e-3;
  return { metres: isAssumed ? 1000 * stated : stated, stated, isAssumed };
}

function describeRange({ lineage }: Stored, version: string): string[] {
  const { stated, isAssumed } = readStart(lineage, version, findNumber(lineage, 'where', 'rscale') ?? NaN);
  if (!isAssumed) return [];
  const [taken, other] = isInMetres(version) ? ['kilometres', 'metres'] : ['metres', 'kilometres'];
  return [`rstart ${stated} is taken as ${taken}, though ODIM_H5 ${version} has it in ${other}`];
}

/** How a radar says that it is faulty, and so a quantity of a scan not to be used. Source: ODIM_H5 2.0 to 2.4, how/malfunc and how/radar_msg */
function describeFault(lineage: Lineage): string | undefined {
  if (!/^true$/i.test(findText(lineage, 'how', 'malfunc')?.trim() ?? '')) return undefined;
  const words = findText(lineage, 'how', 'radar_msg')?.slice(0, 80);
  return `how/malfunc${words ? `: ${words}` : ''}`;
}

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
function readGates(stored: Stored, version: string): SweepData {
  const { array, lineage } = stored;
  if (array.type === 'text' || array.type === 'other') {
    throw new VolumeViewError('format/unsupported', `${array.path} holds no numbers; expected integers or floats`);
  }
  const grid = readGrid(stored, version);
  const slope = findNumber(lineage, 'what', 'gain') ?? 1;
  const intercept = findNumber(lineage, 'what', 'offset') ?? 0;
  if (!(Number.isFinite(slope) && slope !== 0 && Number.isFinite(intercept))) {
    throw new VolumeViewError(
      'format/corrupt',
      `${array.path} got gain ${slope} and offset ${intercept}; expected finite numbers, the gain not 0`,
    );
  }
  const noData = ['nodata', 'undetect']
    .map((name) => findNumber(lineage, 'what', name))
    .filter((number) => number !== undefined);
  const packed = packGates(array.readRows(0, array.shape[0]), { type: array.type, slope, intercept, noData });
  return { ...grid, ...packed };
}
