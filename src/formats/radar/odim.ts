import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { textOf } from '../base/data-tree.ts';
import type { DataGroup } from '../base/data-tree.ts';
import { openHdf5 } from '../hdf5/hdf5.ts';
import { isCfradial2 } from './cfradial2.ts';
import { findNumber, findText, joinTime, listGroups } from './odim-attributes.ts';
import { readOdimSweep } from './odim-sweep.ts';
import type { OdimSweep } from './odim-sweep.ts';
import type { RadarFile } from './radar-file.ts';

/** Objects that are not scans of cones, in words. */
const otherObjects: Readonly<Record<string, string>> = {
  CVOL: 'a cartesian volume',
  COMP: 'a composite of radars',
  IMAGE: 'a cartesian image',
  XSEC: 'a vertical cross section',
  RHI: 'a range-height scan',
  ELEV: 'a range-height scan',
  VP: 'a vertical profile',
  PIC: 'a picture',
};

/**
 * Reads a polar volume (PVOL) or a single scan (SCAN, AZIM) of ODIM_H5, versions 2.0 to 2.4.
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`, `format/too-large`; so may `read`
 * of its sweeps
 * Source: EUMETNET OPERA weather radar information model for implementation with the HDF5 file format, 2.0 to 2.4
 */
export async function readOdim(
  bytes: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(bytes.length),
): Promise<RadarFile> {
  return readOdimTree(openHdf5(bytes, budget), budget);
}

/** Whether an HDF5 file says that it is ODIM_H5. CfRadial 2 files that xradar made from ODIM_H5 may say so too. */
export function isOdim(root: DataGroup): boolean {
  const saysSo = /^ODIM/i.test(textOf(root.attributes.get('Conventions')) ?? '');
  return (saysSo && !isCfradial2(root)) || root.group('what')?.attributes.has('object') === true;
}

/** The same as `readOdim`, for a file that is open. */
export function readOdimTree(root: DataGroup, budget: Budget): RadarFile {
  checkObject(root);
  const groups = listGroups(root, 'dataset');
  const version = readVersion(root);
  const details: string[] = [];
  const scans = groups.filter((group) => isScan(group, details));
  details.push(...describeQuality(scans));
  const sweeps = scans.map((group) => readOdimSweep(root, group, version, budget)).filter((sweep) => sweep !== null);
  if (sweeps.length === 0)
    throw new VolumeViewError(
      'format/corrupt',
      `the ODIM_H5 file holds no scan; expected groups dataset1, dataset2, … with data${details.length > 0 ? `; ${details[0]}` : ''}`,
    );
  const time = firstTime(sweeps) ?? joinTime(findText([root], 'what', 'date'), findText([root], 'what', 'time'));
  // The vertical width is preferred, because it determines how far sweeps reach up and down.
  const beamWidth = ['beamwV', 'beamwidth', 'beamwH']
    .map((name) => findNumber([root, ...groups], 'how', name))
    .find((width) => width !== undefined && width > 0);
  const moments = new Map(sweeps.flatMap((sweep) => sweep.found).map((moment) => [moment.name, moment]));
  return {
    format: `ODIM_H5 ${version}`,
    site: readSite(root),
    ...(time ? { time } : {}),
    ...(beamWidth === undefined ? {} : { beamWidth }),
    moments: [...moments.values()],
    sweeps,
    details,
  };
}

/** Whether a dataset is a scan, and not another product of the same file. */
function isScan(dataset: DataGroup, details: string[]): boolean {
  const product = findText([dataset], 'what', 'product');
  if (product === undefined || ['SCAN', 'AZIM', 'PPI', 'PVOL'].includes(product)) return true;
  details.push(`${dataset.path} is left out: it is no scan but ${product.slice(0, 20)} (what/product)`);
  return false;
}

/** Fields of quality in addition to the data: each says what it says in its own way, and none that a gate is no data. Source: ODIM_H5 2.4, 4.5 and table 8, how/task */
function describeQuality(scans: readonly DataGroup[]): string[] {
  const groups = scans
    .flatMap((scan) => [scan, ...listGroups(scan, 'data')])
    .flatMap((parent) => listGroups(parent, 'quality'));
  const tasks = new Set(groups.map((group) => findText([group], 'how', 'task')?.slice(0, 60) ?? 'no how/task'));
  return groups.length > 0
    ? [`${groups.length} fields of quality are not used (${[...tasks].slice(0, 8).join(', ')})`]
    : [];
}

function checkObject(root: DataGroup): void {
  const object = findText([root], 'what', 'object');
  if (object === undefined) {
    throw new VolumeViewError(
      'format/unsupported',
      'the HDF5 file has no what/object; expected a polar volume of ODIM_H5 (PVOL or SCAN)',
    );
  }
  if (['PVOL', 'SCAN', 'AZIM'].includes(object)) return;
  const words = Object.hasOwn(otherObjects, object) ? `, ${otherObjects[object]}` : '';
  throw new VolumeViewError(
    'format/unsupported',
    `the ODIM_H5 file got the object ${object}${words}; expected a polar volume (PVOL) or a scan (SCAN). Fetch the radar's volume instead, or read this object with wradlib or xradar`,
  );
}

function firstTime(sweeps: readonly OdimSweep[]): string | undefined {
  const times = sweeps.map(({ time }) => time).filter((time) => time !== undefined);
  return times.length > 0 ? times.reduce((first, next) => (next < first ? next : first)) : undefined;
}

/** Reads '2.2' from 'ODIM_H5/V2_2' or 'H5rad 2.2'. */
function readVersion(root: DataGroup): string {
  const stated = `${textOf(root.attributes.get('Conventions')) ?? ''} ${findText([root], 'what', 'version') ?? ''}`;
  const found = /V(\d+)_(\d+)|H5rad (\d+)\.(\d+)/.exec(stated);
  return found ? `${found[1] ?? found[3]}.${found[2] ?? found[4]}` : '2';
}

/** Reads the position from `where`, and the most readable name from `source`, 'WMO:06477,PLC:Wideumont,NOD:bewid'. */
function readSite(root: DataGroup): RadarFile['site'] {
  const source = new Map(
    (findText([root], 'what', 'source') ?? '').split(',').map((part) => {
      const [key, ...value] = part.split(':');
      return [key.trim(), value.join(':').trim()] as const;
    }),
  );
  const name = ['PLC', 'NOD', 'RAD', 'WMO', 'WIGOS'].map((key) => source.get(key)).find((value) => value);
  const latitude = findNumber([root], 'where', 'lat');
  const longitude = findNumber([root], 'where', 'lon');
  const height = findNumber([root], 'where', 'height');
  return {
    ...(name ? { name } : {}),
    ...(isFinite(latitude) ? { latitude } : {}),
    ...(isFinite(longitude) ? { longitude } : {}),
    ...(isFinite(height) ? { height } : {}),
  };
}

function isFinite(value: number | undefined): value is number {
  return value !== undefined && Number.isFinite(value);
}
