import { readScanTime } from '../../../src/core/scan-time.ts';
import { formatManifest } from './format-manifest.ts';
import type { DoneLine } from './job.ts';
import { writeSeriesPage } from './site-pages.ts';
import { writeFolder } from './write-folder.ts';

/** A volume that is in the site. */
export interface WrittenScan {
  readonly line: DoneLine;
  /** Among the lines of its source. */
  readonly place: number;
  /** See `SourceVolume`. */
  readonly series: number;
  /** Without the name of the image. */
  readonly manifest: object;
  readonly poster: Uint8Array | null;
}

/** Series of several scans, of which all are written, in the order of time: others can't be shown one after another. */
export function findSeries<S extends WrittenScan>(written: readonly S[]): S[][] {
  const series = new Map<number, S[]>();
  for (const one of written) series.set(one.series, [...(series.get(one.series) ?? []), one]);
  return [...series.values()].filter((scans) => scans.length > 1 && isInOrder(scans.map(({ line }) => line.time)));
}

function isInOrder(times: readonly (string | undefined)[]): boolean {
  const known = times.flatMap((time) => (time === undefined ? [] : [readScanTime(time)]));
  return known.every(
    (time, i) => time !== null && (i === 0 || (time.unit === known[i - 1]!.unit && time.value >= known[i - 1]!.value)),
  );
}

/**
 * Writes a folder whose page shows all scans of a series, with a timeline. Their images are in their own folders.
 * @returns the page, relative to the site
 */
export async function writeSeries(site: string, scans: readonly WrittenScan[]): Promise<string> {
  const [{ line: first, poster }] = scans;
  const id = `${first.id}-scans`;
  const list = scans.map(({ line, manifest }) => ({
    ...manifest,
    title: first.title,
    image: `../${line.id}/volume.png`,
    ...(line.time === undefined ? {} : { time: line.time }),
  }));
  const lines = scans.map(({ line }) => line);
  await writeFolder(site, id, [
    ...(poster ? ([['poster.png', poster]] as const) : []),
    ['scans.json', formatManifest({ scans: list })],
    ['index.html', writeSeriesPage(lines, 'scans.json', poster !== null)],
  ]);
  return `${id}/index.html`;
}
