import { createHash, createHmac } from 'node:crypto';
import { basename } from 'node:path';
import { describeFailure, prepareSource } from '../../../src/prepare/prepare-source.ts';
import type { PreparedVolume } from '../../../src/prepare/prepare-source.ts';
import { pathOf } from '../../../src/sources/byte-store.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { formatManifest } from './format-manifest.ts';
import type { DoneLine, Job, JobResult, Line } from './job.ts';
import { findSeries, writeSeries } from './write-series.ts';
import type { WrittenScan } from './write-series.ts';
import { hideNames, openPlace, WatchedStore } from './open-place.ts';
import { writeScanPage } from './site-pages.ts';
import { writeFolder } from './write-folder.ts';

/** Reads a source, and writes a folder for each of its volumes. Never rejects: what fails is a line. */
export async function runJob({ place, source, site, salt, options }: Job): Promise<JobResult> {
  const lines: Line[] = [];
  const written: WrittenScan[] = [];
  let content = '';
  let watched: WatchedStore | null = null;
  try {
    watched = new WatchedStore(await openPlace(place));
    const store = await hideNames(watched, place);
    const hidden = { ...source, first: store.hide(source.first), files: source.files?.map((url) => store.hide(url)) };
    let id = '';
    for await (const one of prepareSource(store, hidden, options)) {
      content ||= await hashFiles(watched.inner, [...(source.files ?? []), ...watched.wasRead, source.first]);
      id ||= createHmac('sha256', salt).update(content).digest('hex').slice(0, 16);
      if ('code' in one) {
        lines.push({ status: 'failed', code: one.code, message: one.message });
        continue;
      }
      const own = one.number === 1 ? id : `${id}-${one.number}`;
      const line = await writeVolume(one, own, { place, source, site, options });
      written.push({
        line,
        place: lines.push(line) - 1,
        series: one.series,
        manifest: one.manifest,
        poster: one.poster,
      });
    }
    // A page that holds the volumes of all times would be as large as all of them.
    if (options.as === 'mosaic')
      for (const scans of findSeries(written)) {
        const page = await writeSeries(site, scans);
        for (const { line, place } of scans) lines[place] = { ...line, scans: page };
      }
  } catch (error) {
    lines.push({ status: 'failed', ...(describeWriting(error) ?? describeFailure(error)) });
  }
  return { lines, read: [...(watched?.wasRead ?? [])], content };
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

async function writeVolume(
  { png, poster, manifest, report, number }: PreparedVolume,
  id: string,
  { source, site, options }: Pick<Job, 'place' | 'source' | 'site' | 'options'>,
): Promise<DoneLine> {
  // Names of DICOM files, and of their folders, are never kept.
  const own = options.keepNames && !source.files ? nameOf(source.first) : `Scan ${id.slice(0, 8)}`;
  const title = number > 1 ? `${own}, ${number}` : own;
  const line: DoneLine = { status: 'done', id, title, page: `${id}/index.html`, ...report };
  const titled = { title, ...manifest };
  const files: Record<string, Uint8Array | string> = poster ? { 'poster.png': poster } : {};
  if (options.as === 'single-file') {
    const image = `data:image/png;base64,${Buffer.from(png.buffer, png.byteOffset, png.byteLength).toString('base64')}`;
    // In a URL only these signs of JSON have another meaning.
    const json = JSON.stringify({ image, ...titled }).replace(/[%#\s]/g, encodeURIComponent);
    files['index.html'] = writeScanPage(line, `data:application/json,${json}`, poster !== null);
  } else {
    files['volume.png'] = png;
    files['volume.json'] = formatManifest({ image: 'volume.png', ...titled });
    files['index.html'] = writeScanPage(line, 'volume.json', poster !== null);
  }
  await writeFolder(site, id, Object.entries(files));
  return line;
}

const nameOf = (url: string): string => basename(pathOf(url)).slice(0, 200);

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
