import { Budget } from '../formats/base/budget.ts';
import { readDicomFile } from '../formats/dicom/read-file.ts';
import { tags } from '../formats/dicom/tags.ts';
import { lookAt } from '../formats/sniff.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import type { FileKind } from '../sources/divide-files.ts';
import { isLitter, sniffKind, startBytes } from '../sources/find-volume.ts';
import { isZip } from '../sources/is-zip.ts';

/** What one file of a folder is. */
export interface FoundFile {
  readonly url: string;
  readonly kind: FileKind | 'archive';
  /** Of a slice: which series it belongs to, a number of DICOM that must not leave the program; '' where it can't be read. */
  readonly series?: string;
}

/** Files that give one or several volumes. */
export interface Source {
  /** The file that is read first: a header, a manifest, the first slice. */
  readonly first: string;
  /** Of slices: all of them, in the order of their names. */
  readonly files?: readonly string[];
  /** Each of the files is a scan of its own: together they are scans in time, in that order. */
  readonly each?: true;
  /**
   * Sources of a lower number come first: what they read belongs to them, and is no source of its own. 0 manifests, 1 files of volumes and series, 2
   * packed files, which may be the data of a header.
   */
  readonly phase: 0 | 1 | 2;
}

/** Larger DICOM files are not read to find their series: each of them is one. */
const maxSliceBytes = 2 ** 26;

/** Reads the start of a file, and of a slice as much as it takes to know its series. @throws {VolumeViewError} `source/…` */
export async function lookAtFile(store: ByteStore, url: string): Promise<FoundFile> {
  if (isLitter(url)) return { url, kind: 'other' };
  const { bytes } = await store.read(url, { range: { start: 0, end: startBytes } });
  if (isZip(bytes)) return { url, kind: 'archive' };
  const kind = await sniffKind(store, url, await lookAt(bytes));
  if (kind !== 'slice') return { url, kind };
  const { size } = await store.stat(url);
  if (size !== null && size > maxSliceBytes) return { url, kind, series: url };
  try {
    const whole = (await store.read(url)).bytes;
    const { set, pixels } = readDicomFile(whole, Budget.ofFile(whole.length), 'a file');
    // Reports, plans and lists of files have no pixels.
    return pixels ? { url, kind, series: set.text(tags.series) } : { url, kind: 'other' };
  } catch {
    return { url, kind, series: '' };
  }
}

/**
 * Decides which files belong together. Slices of one series do, in whichever folders they are; one that can't be read belongs to the
 * only series of its folder, where it has one, so that its reader says what is wrong.
 */
export function groupFiles(files: readonly FoundFile[]): Source[] {
  const series = new Map<string, string[]>();
  const add = (name: string, url: string): void => {
    const urls = series.get(name);
    if (urls) urls.push(url);
    else series.set(name, [url]);
  };
  const inFolders = new Map<string, Set<string>>();
  for (const { url, series: name } of files)
    if (name) inFolders.set(folderOf(url), (inFolders.get(folderOf(url)) ?? new Set()).add(name));
  for (const { url, kind, series: name } of files) {
    if (kind !== 'slice') continue;
    const around = [...(inFolders.get(folderOf(url)) ?? [])];
    add(name || (around.length === 1 ? around[0] : url), url);
  }
  const { compare } = new Intl.Collator('en', { numeric: true });
  const sources: Source[] = [...series.values()].map((urls) => {
    urls.sort(compare);
    return { first: urls[0], files: urls, phase: 1 };
  });
  for (const { url, kind } of files) {
    const phase = { manifest: 0, volume: 1, packed: 2 }[kind as string] as Source['phase'] | undefined;
    if (phase !== undefined) sources.push({ first: url, phase });
  }
  sources.sort((a, b) => a.phase - b.phase || compare(a.first, b.first));
  return sources;
}

const folderOf = (url: string): string => url.slice(0, url.lastIndexOf('/') + 1);
