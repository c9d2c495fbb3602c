import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { textOf } from '../base/data-tree.ts';
import type { DataArray, DataGroup } from '../base/data-tree.ts';
import { openHdf5 } from '../hdf5/hdf5.ts';
import { packArray, readValues } from './cf-packing.ts';
import {
  describeMoment,
  describePlatform,
  firstNumber,
  firstText,
  isNumericVariable,
  readElevations,
  readRange,
  readSite,
  readStart,
  readTime,
  readTransitions,
  settleElevations,
  wrapAzimuths,
} from './cfradial-parts.ts';
import { corrupt } from './cfradial-problem.ts';
import { checkBeamWidth } from './beam-width.ts';
import { mixingOf } from './moment-kind.ts';
import type { RadarFile, RadarMoment, RadarSweep } from './radar-file.ts';
import { refuseManySweeps, refuseSweep } from './radar-limits.ts';
import { chooseByMode } from './sweep-modes.ts';

/** Memory for a radial's angles, and steps for each name of a group. */
const bytesPerRadial = 16;
const stepsPerName = 16;

interface Cfradial2Sweep extends RadarSweep {
  readonly found: readonly RadarMoment[];
}

/**
 * Reads a CfRadial 2 file, which is FM 301 too: NetCDF-4 with a group for each sweep.
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`, `format/too-large`; so may `read`
 * of its sweeps
 * Source: CfRadial2 data file format 2.1, NCAR; WMO Manual on Codes I.2, FM 301-XXIV
 */
export async function readCfradial2(
  bytes: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(bytes.length),
): Promise<RadarFile> {
  return readCfradial2Tree(openHdf5(bytes, budget), budget);
}

/** Whether a file is one of CfRadial 2. */
export function isCfradial2(root: DataGroup): boolean {
  return root.names.includes('sweep_group_name') || root.names.some((name) => sweepName.test(name));
}

/** The same as `readCfradial2`, for a file that is open. */
export function readCfradial2Tree(root: DataGroup, budget: Budget): RadarFile {
  const groups = listSweeps(root);
  if (groups.length === 0)
    throw new VolumeViewError(
      'format/unsupported',
      'the NetCDF-4 file has no groups of sweeps; expected a radar scan in CfRadial 2',
    );
  const modes = groups.map(({ group }) => firstText(group, 'sweep_mode'));
  const parameters = [root, root.group('radar_parameters')].filter((group) => group !== null);
  const beamWidth = parameters
    .flatMap((group) =>
      ['radar_beam_width_v', 'beam_width_v', 'radar_beam_width_h', 'beam_width_h'].map((name) =>
        firstNumber(group, name),
      ),
    )
    .find((width) => width !== undefined && width > 0);
  const read: Cfradial2Sweep[] = [];
  const chosen = chooseByMode(
    groups.map(({ group, index }, i) => ({
      mode: modes[i],
      open: () => {
        const sweep = readSweep({ root, group, index }, budget);
        read.push(sweep);
        return sweep;
      },
    })),
    {
      beamWidth: checkBeamWidth(beamWidth),
      mixingOf: (name) => mixingOf(read.flatMap(({ found }) => found).find((one) => one.name === name)!),
    },
    budget,
  );
  const moments = new Map(read.flatMap(({ found }) => found).map((moment) => [moment.name, moment]));
  const time = readStart(root) ?? read.map((sweep) => sweep.time).find((one) => one !== undefined);
  return {
    format: `CfRadial ${/(2\.\d+)/.exec(`${textOf(root.attributes.get('Conventions')) ?? ''} ${textOf(root.attributes.get('version')) ?? ''}`)?.[1] ?? '2'}`,
    site: readSite(root),
    ...(time ? { time } : {}),
    ...(beamWidth === undefined ? {} : { beamWidth }),
    moments: [...moments.values()],
    ...chosen,
    left: [...chosen.left, ...describePlatform(root)],
  };
}

const sweepName = /^sweep_(\d+)$/;

/** Groups of sweeps, as `sweep_group_name` lists them, or by their numbers. */
function listSweeps(root: DataGroup): { group: DataGroup; index: number }[] {
  const listed = root.array('sweep_group_name');
  const stated = listed?.type === 'text' ? listed.readTexts() : [];
  const found = root.names.filter((name) => sweepName.test(name));
  found.sort((a, b) => Number(sweepName.exec(a)?.[1]) - Number(sweepName.exec(b)?.[1]));
  // The names in xradar's list may differ from the groups' real names.
  const held = new Set(root.names);
  const names = stated.length > 0 && stated.every((name) => held.has(name)) ? stated : found;
  refuseManySweeps(names.length);
  return names
    .map((name, index) => ({ group: root.group(name), index }))
    .filter((entry): entry is { group: DataGroup; index: number } => entry.group !== null);
}

function readSweep(
  { root, group, index }: { root: DataGroup; group: DataGroup; index: number },
  budget: Budget,
): Cfradial2Sweep {
  const azimuths = group.array('azimuth');
  const range = group.array('range');
  if (!azimuths || !range || azimuths.shape.length !== 1 || range.shape.length !== 1) {
    throw corrupt(`has no radials and gates in ${group.path}; expected variables azimuth and range of one axis each`);
  }
  const [radials] = azimuths.shape;
  const [gates] = range.shape;
  refuseSweep(group.path, radials, gates);
  budget.take(radials * bytesPerRadial, `the angles of ${group.path}`);
  budget.step(radials + stepsPerName * group.names.length, group.path);
  const moments = findMoments(group, radials, gates);
  const time = readTime(group, 0);
  const nyquist = firstNumber(group, 'nyquist_velocity');
  const elevations = readElevations(group.array('elevation'), { from: 0, count: radials });
  const transitions = readTransitions(group.array('antenna_transition'), { from: 0, count: radials });
  return {
    ...settleElevations(readNominal(root, group, index), elevations, group.path),
    azimuths: wrapAzimuths(readValues(azimuths, 0, radials), azimuths.path),
    ...(transitions ? { transitions } : {}),
    ...(time ? { time } : {}),
    ...(nyquist !== undefined && nyquist > 0 ? { nyquist } : {}),
    moments: [...moments.keys()],
    found: [...moments].map(([name, array]) => describeMoment(name, array)),
    gridOf: (moment) => (moments.has(moment) ? { ...readRange(range), gates } : null),
    read: (moment) => {
      const array = moments.get(moment);
      return array ? { ...readRange(range), gates, ...packArray(array, array.readRows(0, radials)) } : null;
    },
  };
}

function findMoments(group: DataGroup, radials: number, gates: number): Map<string, DataArray> {
  const moments = new Map<string, DataArray>();
  for (const name of group.names) {
    const array = group.array(name);
    if (
      array &&
      isNumericVariable(array) &&
      array.shape.length === 2 &&
      array.shape[0] === radials &&
      array.shape[1] === gates
    )
      moments.set(name, array);
  }
  return moments;
}

function readNominal(root: DataGroup, group: DataGroup, index: number): number | undefined {
  return (
    firstNumber(group, 'sweep_fixed_angle') ??
    firstNumber(group, 'fixed_angle') ??
    firstNumber(root, 'sweep_fixed_angle', index)
  );
}
