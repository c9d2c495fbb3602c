import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { countElements, numberOf, textOf } from '../base/data-tree.ts';
import type { DataArray, DataGroup } from '../base/data-tree.ts';
import { openHdf5 } from '../hdf5/hdf5.ts';
import { isNetcdf3, openNetcdf3 } from '../netcdf/netcdf3.ts';
import { takeDuring } from '../base/take-during.ts';
import { packArray, readValues } from './cf-packing.ts';
import {
  describeMoment,
  describePlatform,
  firstNumber,
  isNumericVariable,
  readElevations,
  readSite,
  readStart,
  readTime,
  readTransitions,
  requireNumbers,
  settleElevations,
  wrapAzimuths,
} from './cfradial-parts.ts';
import { corrupt } from './cfradial-problem.ts';
import { readGatePlace } from './cfradial-ranges.ts';
import type { GatePlace } from './cfradial-parts.ts';
import { checkBeamWidth } from './beam-width.ts';
import { pickRows } from './gate-samples.ts';
import type { PackedGates } from './gate-samples.ts';
import { mixingOf } from './moment-kind.ts';
import type { RadarFile, RadarMoment, RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { refuseManySweeps, refuseSweep } from './radar-limits.ts';
import { chooseByMode } from './sweep-modes.ts';

/** Memory for a radial's angles and, in files whose radials differ in length, for its position, bytes. */
const bytesPerRadial = 16;
const bytesPerRaggedRadial = 16;

/** The range of the file's radials that make up a sweep. */
interface Radials {
  readonly sweep: number;
  readonly from: number;
  readonly count: number;
}

/** Radials and, read when it is asked for, where their gates lie. */
interface PlacedRadials extends Radials {
  placeOf(): GatePlace;
}

/** What all sweeps share. */
interface Scan {
  readonly root: DataGroup;
  readonly moments: ReadonlyMap<string, DataArray>;
  readonly names: readonly string[];
  readonly budget: Budget;
  /** For files whose radials differ in length: the index of each radial's first value, and its number of gates. */
  readonly ragged: { readonly starts: Float64Array; readonly gates: Float64Array } | null;
}

/**
 * Reads a CfRadial 1 file, NetCDF-3 or NetCDF-4.
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`, `format/too-large`; so may `read`
 * of its sweeps
 * Source: CfRadial data file format 1.4, NCAR
 */
export async function readCfradial1(
  bytes: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(bytes.length),
): Promise<RadarFile> {
  return readCfradial1Tree(isNetcdf3(bytes) ? openNetcdf3(bytes, budget) : openHdf5(bytes, budget), budget);
}

/** Whether a file is one of CfRadial 1. */
export function isCfradial1(root: DataGroup): boolean {
  return root.names.includes('sweep_start_ray_index') && root.names.includes('azimuth');
}

/** The same as `readCfradial1`, for a file that is open. */
export function readCfradial1Tree(root: DataGroup, budget: Budget): RadarFile {
  if (!isCfradial1(root)) {
    // Source: MINC 1 programmer's guide: MIimage, MIimagemax.
    const isMinc = root.names.includes('image') && root.names.includes('image-max');
    throw new VolumeViewError(
      'format/unsupported',
      isMinc
        ? 'the file is MINC 1, which volume-view does not read; convert it to MINC 2: mincconvert -2 in.mnc out.mnc'
        : 'the NetCDF file has no sweep_start_ray_index and azimuth; expected a radar scan in CfRadial 1',
    );
  }
  const scan = openScan(root, budget);
  const modes = readModes(root);
  const all = listRadials(root);
  const time = readStart(root) ?? readTime(root, 0);
  // The vertical width is preferred, because it determines how far sweeps reach up and down.
  const beamWidth = firstNumber(root, 'radar_beam_width_v') ?? firstNumber(root, 'radar_beam_width_h');
  const moments = [...scan.moments].map(([name, array]): RadarMoment => describeMoment(name, array));
  const sweeps = chooseByMode(
    all.map((radials) => ({ mode: modes[radials.sweep], open: () => readSweep(scan, radials) })),
    {
      beamWidth: checkBeamWidth(beamWidth),
      mixingOf: (name) => mixingOf(moments.find((one) => one.name === name)!),
    },
    budget,
  );
  return {
    format: `CfRadial ${readVersion(root)}`,
    site: readSite(root),
    ...(time ? { time } : {}),
    ...(beamWidth !== undefined && beamWidth > 0 ? { beamWidth } : {}),
    moments,
    ...sweeps,
    left: [...sweeps.left, ...describePlatform(root)],
  };
}

/** Reads '1.3' from 'CF/Radial instrument_parameters' with version '1.3', or '1.4' from 'CF-1.7 CfRadial-1.4'. */
function readVersion(root: DataGroup): string {
  const stated = `${textOf(root.attributes.get('Conventions')) ?? ''} ${textOf(root.attributes.get('version')) ?? numberOf(root.attributes.get('version')) ?? ''}`;
  return /CF-?\/?Radial-?\s?(1\.\d+)/i.exec(stated)?.[1] ?? /\b(1\.\d)\b/.exec(stated)?.[1] ?? '1';
}

function openScan(root: DataGroup, budget: Budget): Scan {
  const radials = root.array('azimuth')?.shape[0] ?? 0;
  const gates = root.array('range')?.shape.at(-1) ?? 0;
  const isRagged = root.names.includes('ray_n_gates') && root.names.includes('ray_start_index');
  if (isRagged) budget.take(radials * bytesPerRaggedRadial, 'the radials of the CfRadial file');
  const ragged = isRagged
    ? { gates: requireNumbers(root, 'ray_n_gates', radials), starts: requireNumbers(root, 'ray_start_index', radials) }
    : null;
  const points = ragged ? ragged.gates.reduce((end, count, i) => Math.max(end, ragged.starts[i] + count), 0) : NaN;
  const holdsGates = (array: DataArray): boolean => {
    const { shape } = array;
    const isGrid = shape.length === 2 && shape[0] === radials && shape[1] === gates;
    return isNumericVariable(array) && (isGrid || (shape.length === 1 && shape[0] === points && points !== radials));
  };
  const moments = new Map<string, DataArray>();
  for (const name of root.names) {
    const array = name === 'range' ? null : root.array(name);
    if (array && holdsGates(array)) moments.set(name, array);
  }
  if (moments.size === 0) throw corrupt(`has no variable of ${radials} radials by ${gates} gates`);
  return { root, moments, names: [...moments.keys()], ragged, budget };
}

function listRadials(root: DataGroup): Radials[] {
  const radials = root.array('azimuth')?.shape[0] ?? 0;
  const sweeps = countElements(root.array('sweep_start_ray_index')?.shape ?? []);
  refuseManySweeps(sweeps);
  const starts = requireNumbers(root, 'sweep_start_ray_index', sweeps);
  const ends = requireNumbers(root, 'sweep_end_ray_index', sweeps);
  return Array.from({ length: sweeps }, (_, sweep) => {
    const [from, end] = [starts[sweep], ends[sweep]];
    if (!(from >= 0 && end >= from && end < radials))
      throw corrupt(`got the radials ${from} to ${end} for sweep ${sweep}; expected some of 0 to ${radials - 1}`);
    refuseSweep(`sweep ${sweep}`, end - from + 1, 1);
    return { sweep, from, count: end - from + 1 };
  });
}

function readModes(root: DataGroup): readonly string[] {
  const modes = root.array('sweep_mode');
  return modes?.type === 'text' ? modes.readTexts() : [];
}

function readSweep(scan: Scan, radials: Radials): RadarSweep {
  const { root, moments, names, budget } = scan;
  const { from, count } = radials;
  budget.take(count * bytesPerRadial, `the angles of sweep ${radials.sweep}`);
  budget.step(count, `the angles of sweep ${radials.sweep}`);
  const azimuths = root.array('azimuth')!;
  let place: GatePlace | undefined;
  const placed: PlacedRadials = { ...radials, placeOf: () => (place ??= readGatePlace(root, radials)) };
  const elevations = readElevations(root.array('elevation'), radials);
  const time = readTime(root, from);
  const nyquist = firstNumber(root, 'nyquist_velocity', from);
  const transitions = readTransitions(root.array('antenna_transition'), radials);
  return {
    ...settleElevations(firstNumber(root, 'fixed_angle', radials.sweep), elevations, `sweep ${radials.sweep}`),
    azimuths: wrapAzimuths(readValues(azimuths, from, count), azimuths.path),
    ...(transitions ? { transitions } : {}),
    ...(time ? { time } : {}),
    ...(nyquist !== undefined && nyquist > 0 ? { nyquist } : {}),
    moments: names,
    gridOf: (moment) => {
      const array = moments.get(moment);
      return array ? readGrid(scan, array, placed) : null;
    },
    read: (moment) => {
      const array = moments.get(moment);
      return array ? readGates(scan, array, placed) : null;
    },
  };
}

function readGrid(scan: Scan, array: DataArray, radials: PlacedRadials): SweepGates {
  const gates = array.shape.length === 2 ? array.shape[1] : longestOf(scan, radials);
  refuseSweep(array.path, radials.count, gates);
  return { ...radials.placeOf(), gates };
}

function readGates(scan: Scan, array: DataArray, radials: PlacedRadials): SweepData {
  const grid = readGrid(scan, array, radials);
  if (array.shape.length !== 2) return { ...grid, ...readRagged(scan, array, { ...radials, gates: grid.gates }) };
  return { ...grid, ...packArray(array, array.readRows(radials.from, radials.count)) };
}

/** Gates of the longest radial of a sweep. */
function longestOf({ ragged }: Scan, { from, count }: Radials): number {
  return ragged?.gates.subarray(from, from + count).reduce((max, length) => Math.max(max, length), 0) ?? 0;
}

/** Reads radials of different lengths. Each of them is a part of one long row, in any order. */
function readRagged(
  { ragged, budget }: Scan,
  array: DataArray,
  { from, count, gates }: Radials & { readonly gates: number },
): PackedGates {
  if (!ragged) throw corrupt(`has no ray_start_index for ${array.path}`);
  const lengths = ragged.gates.subarray(from, from + count);
  const starts = ragged.starts.subarray(from, from + count);
  const [points] = array.shape;
  if (!lengths.every((length, i) => length >= 0 && starts[i] >= 0 && starts[i] + length <= points))
    throw corrupt(
      `got radials that begin or end outside of ${array.path}; expected ray_start_index from 0 to ${points}`,
    );
  // Of all sweeps that are known, the radials follow one another; then this is no more than they are.
  const first = starts.reduce((min, start) => Math.min(min, start), points);
  const values = starts.reduce((max, start, i) => Math.max(max, start + lengths[i]), first) - first;
  // The values take memory in addition to the rectangle that is made of them.
  return takeDuring(budget, { bytes: 4 * values, what: array.path }, () => {
    const packed = packArray(array, array.readRows(first, values));
    const rows = { starts: starts.map((start) => start - first), lengths, longest: gates };
    return { ...packed, samples: pickRows(packed.samples, rows) };
  });
}
