// Writes the volumes of a source into the site, each in the form that was asked for.
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { decodeSource } from '../../../src/prepare/decode-source.ts';
import type { Source } from '../../../src/prepare/find-sources.ts';
import { posterOf, prepareSource } from '../../../src/prepare/prepare-source.ts';
import type {
  PreparedPyramid,
  PreparedVolume,
  PrepareFailure,
  PyramidOptions,
  VolumeReport,
} from '../../../src/prepare/prepare-source.ts';
import { pathOf } from '../../../src/sources/byte-store.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { formatManifest } from './format-manifest.ts';
import type { DoneLine, FailedLine, Job, Line, PackageForm, SiteForm } from './job.ts';
import { readPlayer } from './lesson-forms.ts';
import { writeScanPage, writeSeriesPage } from './site-pages.ts';
import { unfinished, writeFolder } from './write-folder.ts';
import { isPackage, packScans, pageOf } from './write-packages.ts';
import type { PackedScan } from './write-packages.ts';
import { findSeries, writeSeries } from './write-series.ts';
import type { WrittenScan } from './write-series.ts';
import { makeVideo, NoVideo } from './write-video.ts';
import { packChunk } from './write-zarr.ts';

/** A source that is read and written. */
export interface ScansToWrite extends Pick<Job, 'site' | 'options' | 'player'> {
  readonly store: ByteStore;
  /** Several where each is a scan in time. */
  readonly sources: readonly Source[];
  /** The name of the file, where titles have it. */
  readonly name: string | null;
  /** What the first volume is called in the site, which follows from the bytes of what was read so far. */
  id(): Promise<string>;
}

/**
 * Writes a folder for each volume, or for all scans in time, and says what was written and what failed.
 * @throws {VolumeViewError} where the first volume can't be read
 */
export async function writeScans(all: ScansToWrite): Promise<Line[]> {
  const { as } = all.options;
  if (isPackage(as)) return writePackages(all, as);
  return (as === 'video' ? await writeVideoFolder(all) : null) ?? writeVolumes(all);
}

/** The name of a source's file; null for DICOM and for scans of several files. */
export const nameOfSource = ({ first, files }: Source): string | null =>
  files ? null : basename(pathOf(first)).slice(0, 200);

/** What a line says that is not in the report. */
interface Own {
  readonly id: string;
  readonly title: string;
}

/** All volumes of all sources. */
async function* volumesOf(
  { store, sources, options, name, id }: ScansToWrite,
  pyramids?: PyramidOptions,
): AsyncGenerator<((PreparedVolume | PreparedPyramid) & Own) | PrepareFailure> {
  let number = 0;
  for (const source of sources)
    for await (const one of prepareSource(store, source, options, pyramids)) {
      const first = await id();
      number++;
      if ('code' in one) yield one;
      else
        yield {
          ...one,
          id: number > 1 ? `${first}-${number}` : first,
          title: titleOf(first, name, number),
        };
    }
}

function titleOf(id: string, name: string | null, number = 1): string {
  const own = name ?? `Scan ${id.slice(0, 8)}`;
  return number > 1 ? `${own}, ${number}` : own;
}

const lineOf = (form: SiteForm, { id, title }: Own, report: VolumeReport): DoneLine => ({
  ...{ status: 'done', id, title, form },
  page: `${id}/${pageOf(form)}`,
  ...report,
});

const failed = ({ code, message }: PrepareFailure): FailedLine => ({ status: 'failed', code, message });

/** A folder with a page for each volume: mosaics and pyramids. */
async function writeVolumes(all: ScansToWrite): Promise<Line[]> {
  const { as, fit } = all.options;
  const lines: Line[] = [];
  const written: WrittenScan[] = [];
  const of = as === 'ome-zarr' ? 'all' : as !== 'single-file' && fit === 'desktop' ? 'large' : null;
  for await (const one of volumesOf(all, of === null ? undefined : { of, pack: packChunk })) {
    if ('code' in one) lines.push(failed(one));
    else if ('files' in one) lines.push(await writePyramid(all, one));
    else {
      const line = await writeMosaic(all, one);
      written.push({
        line,
        place: lines.push(line) - 1,
        series: one.series,
        manifest: one.manifest,
        poster: one.poster,
      });
    }
  }
  // A page that holds the volumes of all times would be as large as all of them.
  if (as !== 'single-file')
    for (const scans of findSeries(written)) {
      const page = await writeSeries(all.site, scans);
      for (const { line, place } of scans) lines[place] = { ...line, scans: page };
    }
  return lines;
}

async function writeMosaic({ options, site }: ScansToWrite, one: PreparedVolume & Own): Promise<DoneLine> {
  const { png, poster, manifest, id, title } = one;
  const isSingle = options.as === 'single-file';
  const line = lineOf(isSingle ? 'single-file' : 'mosaic', one, one.report);
  const titled = { title, ...manifest };
  const files: Record<string, Uint8Array | string> = poster ? { 'poster.png': poster } : {};
  if (isSingle) {
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

const zarrName = 'volume.ome.zarr';

async function writePyramid({ site }: ScansToWrite, one: PreparedPyramid & Own): Promise<DoneLine> {
  const { files, poster, report, id } = one;
  let bytes = 0;
  const lineNow = (): DoneLine => lineOf('ome-zarr', one, { ...report, bytes });
  const all = function* () {
    for (const [file, content] of files) {
      bytes += content.length;
      yield [`${zarrName}/${file}`, content] as const;
    }
    if (poster) yield ['poster.png', poster] as const;
    yield ['index.html', writeScanPage(lineNow(), zarrName, poster !== null)] as const;
  };
  await writeFolder(site, id, all());
  return lineNow();
}

/** A package for each volume; one for all scans in time of a series. */
async function writePackages(all: ScansToWrite, form: PackageForm): Promise<Line[]> {
  const lines: Line[] = [];
  const packed: (WrittenScan & PackedScan)[] = [];
  for await (const one of volumesOf(all)) {
    if ('code' in one) lines.push(failed(one));
    else if ('png' in one) {
      const line = lineOf(form, one, one.report);
      packed.push({ ...one, line, place: lines.push(line) - 1 });
    }
  }
  const inTime = findSeries(packed);
  const alone = packed.filter((one) => !inTime.some((scans) => scans.includes(one)));
  const player = packed.length > 0 ? await readPlayer(all.player) : [];
  for (const scans of [...inTime, ...alone.map((one) => [one])]) {
    const [{ line: first }] = scans;
    await writeFolder(all.site, first.id, packScans(scans, { form, words: all.options.words!, player }));
    for (const { line, place } of scans) lines[place] = { ...line, page: first.page };
  }
  return lines;
}

/** A folder with one video of all scans. @returns null where they make none */
async function writeVideoFolder(all: ScansToWrite): Promise<Line[] | null> {
  const { store, sources, options, site, name } = all;
  const { video, moment, deviceBytes } = options;
  const work = await mkdtemp(join(site, unfinished));
  try {
    const made = await makeVideo(
      { ...video!, sources: sources.map((source) => ({ store, source })), moment, deviceBytes, isWhole: true },
      work,
    );
    const id = await all.id();
    const own = { id, title: titleOf(id, name) };
    const { max, rms } = made.lossy;
    const bytes = Math.round(made.bytes / made.scans.length);
    const lines = made.scans.map((report) => lineOf('video', own, { ...report, bits: 8, bytes, error: { max, rms } }));
    const poster = await posterOfFirst(all);
    await writeFolder(site, id, [
      ...(poster ? [['poster.png', poster] as const] : []),
      ['volume.webm', await readFile(made.video)],
      ['volume.json', formatManifest({ video: 'volume.webm', title: own.title, ...made.manifest })],
      ['index.html', writeSeriesPage(lines, 'volume.json', poster !== null)],
    ]);
    return lines;
  } catch (error) {
    if (error instanceof NoVideo || error instanceof VolumeViewError) return null;
    throw error;
  } finally {
    await rm(work, { recursive: true, force: true });
  }
}

async function posterOfFirst({ store, sources, options }: ScansToWrite): Promise<Uint8Array | null> {
  if (options.poster > 0)
    for await (const one of decodeSource(store, sources[0], options))
      if ('volume' in one) return posterOf(one.volume, options.poster);
  return null;
}
