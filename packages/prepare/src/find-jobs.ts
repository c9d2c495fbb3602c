import { createHash } from 'node:crypto';
import { statSync } from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import { groupFiles, lookAtFile } from '../../../src/prepare/find-sources.ts';
import type { FoundFile, Source } from '../../../src/prepare/find-sources.ts';
import { urlInStore } from '../../../src/sources/byte-store.ts';
import { folderBase, FolderStore } from './folder-store.ts';
import type { FolderStoreOptions } from './folder-store.ts';
import type { FailedLine, Place } from './job.ts';
import { archiveBase, openPlace } from './open-place.ts';
import type { PrivateState } from './private-state.ts';

/** A source of a folder, and where it is. */
export interface FolderSource {
  readonly place: Place;
  readonly source: Source;
  /** Says which one it is from run to run. It has names of files. */
  readonly key: string;
}

/** An archive that can't be read. */
export interface BadArchive extends FailedLine {
  readonly key: string;
}

/** Everything in a folder. */
export interface Found {
  readonly sources: readonly FolderSource[];
  readonly bad: readonly BadArchive[];
  /** Paths of all files. */
  readonly files: ReadonlySet<string>;
  /** Numbers of files that are no source: images without a manifest, and all others. */
  readonly images: number;
  readonly others: number;
}

/** Size and time of change; '' where the file is gone. */
export function stampOf(path: string): string {
  const found = statSync(path, { throwIfNoEntry: false });
  return found ? `${found.size} ${found.mtimeMs}` : '';
}

/** One text for the stamps of several files. */
export function stampAll(paths: readonly string[]): string {
  const hash = createHash('sha256');
  const sorted = [...new Set(paths)];
  sorted.sort();
  for (const path of sorted) hash.update(`${path} ${stampOf(path)}\n`);
  return hash.digest('hex');
}

/**
 * Finds all sources of a folder, in archives too. What is known of a file that has not changed is not looked up again.
 * @param folder - absolute
 * @param options - as of `FolderStore`: `only` these paths in it, or all but those in the folders `without`
 * @param onFile - how many files were looked at, and of how many
 */
export async function findJobs(
  folder: string,
  options: FolderStoreOptions,
  state: PrivateState,
  onFile: (done: number, all: number) => void,
): Promise<Found> {
  const store = new FolderStore(folder, options);
  const urls = await store.list();
  const found: FoundFile[] = [];
  const sources: FolderSource[] = [];
  const bad: BadArchive[] = [];
  const files = new Set<string>();
  const inArchives: FoundFile[] = [];
  for (const [i, url] of urls.entries()) {
    onFile(i, urls.length);
    const path = store.pathOf(url);
    files.add(path);
    const stamp = stampOf(path);
    let known = state.files.get(path);
    if (known?.stamp !== stamp) {
      try {
        const own = await lookAtFile(store, url);
        known = { stamp, found: own.kind === 'archive' ? [own, ...(await lookInArchive(path))] : [own] };
        state.keepFile(path, known);
      } catch (cause) {
        bad.push({ status: 'failed', key: relative(folder, path), ...describe(cause) });
        continue;
      }
    }
    const [own, ...inside] = known.found;
    found.push(own);
    inArchives.push(...inside);
    const place = { folder: dirname(path), archive: basename(path) };
    for (const source of groupFiles(inside))
      sources.push({ place, source, key: `${relative(folder, path)}/${pathIn(archiveBase, source.first)}` });
  }
  sources.unshift(...groupFiles(found).map((source) => placeSource(folder, source)));
  const all = [...found, ...inArchives];
  sources.sort((a, b) => a.source.phase - b.source.phase);
  return {
    sources,
    bad,
    files,
    images: all.filter(({ kind }) => kind === 'image').length,
    others: all.filter(({ kind }) => kind === 'other').length,
  };
}

async function lookInArchive(path: string): Promise<FoundFile[]> {
  const archive = await openPlace({ folder: dirname(path), archive: basename(path) });
  const found: FoundFile[] = [];
  for (const url of (await archive.list()) ?? []) found.push(await lookAtFile(archive, url));
  return found;
}

/** A series has its files alone; a header, or a manifest, has all files of its folder next to it. */
function placeSource(folder: string, source: Source): FolderSource {
  const path = pathIn(folderBase, source.first);
  if (source.files) {
    const only = source.files.map((url) => pathIn(folderBase, url));
    return { place: { folder, only }, source, key: path };
  }
  return {
    place: { folder: dirname(join(folder, path)) },
    source: { ...source, first: urlInStore(folderBase, basename(path)) },
    key: path,
  };
}

const pathIn = (base: string, url: string): string => decodeURIComponent(url.slice(base.length));

function describe(cause: unknown): Pick<FailedLine, 'code' | 'message'> {
  const { code, message } = cause as { code?: string; message: string };
  return code?.includes('/') && !message.includes('folder.invalid')
    ? { code, message }
    : { code: 'source/not-found', message: 'the file can not be read; check that you may read it' };
}
