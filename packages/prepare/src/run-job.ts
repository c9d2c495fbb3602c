import { createHash, createHmac } from 'node:crypto';
import type { Source } from '../../../src/prepare/find-sources.ts';
import { lookAtRadar } from '../../../src/prepare/look-at-radar.ts';
import { describeFailure } from '../../../src/prepare/prepare-source.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import type { Job, JobResult, Line } from './job.ts';
import { hideNames, openPlace, WatchedStore } from './open-place.ts';
import { nameOfSource, writeScans } from './write-scans.ts';

/** Reads a source, and writes a folder for each of its volumes. Never rejects: what fails is a line. */
export async function runJob({ place, source, salt, looks, ...job }: Job): Promise<JobResult> {
  const lines: Line[] = [];
  let content = '';
  let look: JobResult['look'];
  let watched: WatchedStore | null = null;
  try {
    const own = new WatchedStore(await openPlace(place));
    watched = own;
    const store = await hideNames(own, place);
    const hidden = (urls: readonly string[] | undefined) => urls?.map((url) => store.hide(url));
    const sources: Source[] = source.each
      ? hidden(source.files)!.map((first) => ({ first, phase: 1 }))
      : [{ ...source, first: store.hide(source.first), files: hidden(source.files) }];
    const id = async (): Promise<string> => {
      content ||= await hashFiles(own.inner, [...(source.files ?? []), ...own.wasRead, source.first]);
      return createHmac('sha256', salt).update(content).digest('hex').slice(0, 16);
    };
    if (looks) look = await lookAtRadar(store, sources[0].first, job.options);
    else {
      const name = job.options.keepNames ? nameOfSource(source) : null;
      lines.push(...(await writeScans({ ...job, store, sources, name, id })));
    }
  } catch (error) {
    lines.push({ status: 'failed', ...(describeWriting(error) ?? describeFailure(error)) });
  }
  return { lines, read: [...(watched?.wasRead ?? [])], content, ...(look === undefined ? {} : { look }) };
}

/** The code of a failure that is not the fault of the file. */
export const notWritable = 'site/not-writable';

/** Words for a site that can't be written; null for all other errors. Errors of reading have codes of their own. */
function describeWriting(error: unknown): { readonly code: string; readonly message: string } | null {
  const { code } = error as NodeJS.ErrnoException;
  const why = { ENOSPC: 'no space is left', EDQUOT: 'no more space is allowed', EROFS: 'it can only be read' };
  const known =
    why[code as keyof typeof why] ?? (code === 'EACCES' || code === 'EPERM' ? 'it may not be written by you' : '');
  return known
    ? { code: notWritable, message: `the site got no file: ${known}; make it possible, and run the command again` }
    : null;
}

/** One number for the bytes of files, in the order of their names. */
export async function hashFiles(store: ByteStore, urls: readonly string[]): Promise<string> {
  const hash = createHash('sha256');
  const sorted = [...new Set(urls)];
  sorted.sort();
  for (const url of sorted) {
    const { size } = await store.stat(url);
    hash.update(`${size};`);
    for (let start = 0; start < (size ?? Infinity); start += hashedAtOnce) {
      const { bytes } = await store.read(url, { range: { start, end: start + hashedAtOnce } });
      if (bytes.length === 0) break;
      hash.update(bytes);
    }
  }
  return hash.digest('hex');
}

/** Bytes. */
const hashedAtOnce = 2 ** 24;
