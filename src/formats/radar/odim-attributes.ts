import { VolumeViewError } from '../../core/errors.ts';
import { numberOf, textOf } from '../base/data-tree.ts';
import type { AttributeValue, DataGroup } from '../base/data-tree.ts';
import { refuseManySweeps } from './radar-limits.ts';

/** From the most specific group to the root: if a data group lacks an attribute, its dataset or the file may have it. */
export type Lineage = readonly DataGroup[];

export type Section = 'what' | 'where' | 'how';

/** The first of several attribute names that the groups' `what`, `where` or `how` has, the most specific group first. */
export function findAttribute(
  lineage: Lineage,
  section: Section,
  names: readonly string[],
): AttributeValue | undefined {
  for (const group of lineage) {
    const attributes = group.group(section)?.attributes;
    for (const name of names) {
      const value = attributes?.get(name);
      if (value !== undefined) return value;
    }
  }
  return undefined;
}

export function findNumber(lineage: Lineage, section: Section, ...names: string[]): number | undefined {
  return numberOf(findAttribute(lineage, section, names));
}

export function findText(lineage: Lineage, section: Section, ...names: string[]): string | undefined {
  return textOf(findAttribute(lineage, section, names));
}

/** @throws {VolumeViewError} `format/corrupt`, if the number is absent or out of range */
export function requireNumber(
  lineage: Lineage,
  section: Section,
  name: string,
  range: readonly [number, number],
): number {
  const value = findNumber(lineage, section, name);
  if (value !== undefined && value >= range[0] && value <= range[1]) return value;
  throw new VolumeViewError(
    'format/corrupt',
    `the ODIM_H5 file got ${section}/${name} ${value ?? 'missing'} at ${lineage[0].path}; expected ${range[0]} to ${range[1]}; check the program that wrote it`,
  );
}

/** Whether a file is of version 2.4 or later, which uses SI units where earlier versions used km, cm and µs. */
export function isInMetres(version: string): boolean {
  const [major, minor = 0] = version.split('.').map(Number);
  return major > 2 || (major === 2 && minor >= 4);
}

/** A date 'YYYYMMDD' and a time 'HHMMSS' as ISO 8601; undefined if they are invalid. */
export function joinTime(date: string | undefined, time: string | undefined): string | undefined {
  const day = /^(\d{4})(\d\d)(\d\d)/.exec(date ?? '');
  const clock = /^(\d\d)(\d\d)(\d\d)?/.exec(time ?? '');
  if (!day || !clock) return undefined;
  const iso = `${day[1]}-${day[2]}-${day[3]}T${clock[1]}:${clock[2]}:${clock[3] ?? '00'}Z`;
  return Number.isNaN(Date.parse(iso)) ? undefined : iso;
}

/** Groups called 'dataset1', 'dataset2', … in the order of their numbers. */
export function listGroups(parent: DataGroup, prefix: string): DataGroup[] {
  const pattern = new RegExp(`^${prefix}(\\d+)$`);
  const found = parent.names
    .map((name) => ({ name, number: Number(pattern.exec(name)?.[1] ?? NaN) }))
    .filter(({ number }) => !Number.isNaN(number));
  refuseManySweeps(found.length, `groups ${prefix}1, ${prefix}2, … in ${parent.path}`);
  found.sort((a, b) => a.number - b.number);
  return found.map(({ name }) => parent.group(name)).filter((group) => group !== null);
}
