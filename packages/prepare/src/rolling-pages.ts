import { existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { chmod, rename, rm, mkdtemp } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { readScanTime } from '../../../src/core/scan-time.ts';
import { formatManifest } from './format-manifest.ts';
import type { DoneLine } from './job.ts';
import { writeChanged } from './site-files.ts';
import { writeRollingPage } from './site-pages.ts';
import { unfinished, writeWhole } from './write-folder.ts';

/** A radar's scan that is in the site. */
export interface TimedScan {
  readonly line: DoneLine;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** What the scans of one page have in common: the radar and the quantity. */
  readonly kind: string;
  readonly manifest: ScanManifest;
}

interface ScanManifest {
  readonly moment?: string;
  readonly unit?: string;
  readonly site?: { readonly name?: string; readonly latitude?: number; readonly longitude?: number };
}

/** The scan of a line, from its folder; null where it says no time of the day, or its folder is gone. */
export function readTimedScan(site: string, line: DoneLine): TimedScan | null {
  const time = line.time === undefined ? null : readScanTime(line.time);
  const path = join(site, line.id, 'volume.json');
  if (time?.unit !== 'UTC' || !existsSync(path)) return null;
  const manifest = JSON.parse(readFileSync(path, 'utf8')) as ScanManifest;
  const { moment, unit, site: radar } = manifest;
  const kind = JSON.stringify([radar?.latitude, radar?.longitude, moment, unit]);
  return { line, time: time.value, kind, manifest };
}

/** Scans by their kind, each in the order of time, and at most `count` of the newest. */
export function newestScans(scans: readonly TimedScan[], count: number): Map<string, TimedScan[]> {
  const kinds = new Map<string, TimedScan[]>();
  for (const one of scans) kinds.set(one.kind, [...(kinds.get(one.kind) ?? []), one]);
  for (const [kind, all] of kinds) {
    all.sort((a, b) => a.time - b.time || (a.line.id < b.line.id ? -1 : 1));
    kinds.set(kind, all.slice(-count));
  }
  return kinds;
}

/** The folder of a page of newest scans. @param number - of its kind, from 0: the same from run to run */
export const rollingFolder = (number: number): string => (number === 0 ? 'newest' : `newest-${number + 1}`);

/**
 * Writes the page of newest scans of one kind. Its list is replaced as a file, so that a server has it at any moment.
 * @param seconds - after which an open page looks for a new list
 */
export async function writeRolling(
  site: string,
  folder: string,
  scans: readonly TimedScan[],
  seconds: number,
): Promise<void> {
  const at = join(site, folder);
  mkdirSync(at, { recursive: true });
  await chmod(at, 0o755);
  const newest = scans[scans.length - 1];
  const title = [newest.manifest.site?.name, newest.manifest.moment].filter(Boolean).join(', ') || 'Newest scans';
  const list = scans.map(({ line, manifest }) => ({
    ...manifest,
    title,
    image: `../${line.id}/volume.png`,
    time: line.time,
  }));
  const poster = join(site, newest.line.id, 'poster.png');
  const hasPoster = existsSync(poster);
  if (hasPoster) await writeWhole(at, 'poster.png', readFileSync(poster));
  await writeChanged(at, 'scans.json', formatManifest({ scans: list }));
  await writeChanged(at, 'index.html', writeRollingPage(title, newest.line, { seconds, hasPoster }));
}

/** Folders of scans have such names, and no other folder of a site has. */
export const scanFolder = /^[0-9a-f]{16}(-\d+)?(-scans)?$/;

/** Removes the folders of all scans but these. @returns how many */
export async function removeOthers(site: string, lines: readonly DoneLine[]): Promise<number> {
  const kept = new Set(lines.flatMap(({ id, scans }) => [id, ...(scans ? [dirname(scans)] : [])]));
  const old = readdirSync(site).filter((name) => scanFolder.test(name) && !kept.has(name));
  for (const name of old) {
    const beside = await mkdtemp(join(site, unfinished));
    await rename(join(site, name), join(beside, 'old'));
    await rm(beside, { recursive: true, force: true });
  }
  return old.length;
}
