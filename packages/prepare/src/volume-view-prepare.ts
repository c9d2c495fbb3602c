#!/usr/bin/env node
// The program. It makes a radar file into an image with a manifest, any file into a page that contains it, a lesson into a package for a
// course, and a folder into a web site.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism, totalmem } from 'node:os';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inspect, parseArgs } from 'node:util';
import { makeRadarMosaic } from '../../../src/prepare/radar-mosaic.ts';
import type { FolderRequest, Output } from './folder-request.ts';
import { siteForms } from './job.ts';
import type { SiteForm, SiteOptions } from './job.ts';
import { formatManifest } from './format-manifest.ts';
import { nameFiles } from './name-files.ts';
import { Misuse } from './misuse.ts';
import type { LessonWords } from './write-lesson.ts';
import type { VideoOptions } from './write-video.ts';
import { maxPageBytes, writePage } from './write-page.ts';
import { version } from '../package.json';

const usage = `volume-view-prepare FILE [--as mosaic] [--moment NAME] [--out NAME]
    one quantity of a radar file (ODIM_H5, CfRadial, NEXRAD Level II or III, Rainbow 5) as NAME.png and its manifest NAME.json
volume-view-prepare FILES --as video [--codec av1] [--error VALUE] [--moment NAME] [--out NAME]
    scans in time, of one file or of several in the order of time, as a video NAME.webm, each frame a mosaic, and its manifest NAME.json. It needs ffmpeg. Without --error it is lossless, but for its 8 bits
volume-view-prepare FILE --as page [--alt TEXT] [--out NAME]
    a page NAME.html with the file inside, which works from disk beside volume-view.iife.js
volume-view-prepare FILE --as ome-zarr [--out NAME]
    each volume of the file as an OME-Zarr, the folder NAME.ome.zarr: levels of detail in small pieces, of which a page loads what it shows
volume-view-prepare LESSON.html [--as page | single-file | embed | scorm | scorm-2004 | cmi5 | h5p] [--address URL] [--title TEXT] [--language CODE] [--licence TEXT] [--credits TEXT] [--pass PERCENT] [--out NAME]
    a lesson and the files that it names, as a folder for a web server, as one file that opens from disk, as a folder that other sites show in a frame (--address says where it will be), or as a package for a course (ZIP) or for H5P
volume-view-prepare FOLDER --out SITE [--fit phone] [--as mosaic | ome-zarr | video | single-file | embed | scorm | scorm-2004 | cmi5 | h5p] [--keep-names] [--moment NAME] [--poster PIXELS] [--jobs N] [--memory MEGABYTES] [--timeout SECONDS]
    a folder SITE for a web server: a page or a package for each volume in FOLDER, and index.html. One JSON line a volume on stdout. --as video takes --codec and --error; --as embed, scorm, scorm-2004, cmi5 and h5p need --licence TEXT and --credits TEXT and take --language CODE, and embed needs --address URL of SITE
volume-view-prepare FOLDER --out SITE --watch [--newest N] [--every SECONDS] [--settle SECONDS] [options of a folder]
    the same for a folder into which a radar writes, until you end it: SITE/newest/index.html shows the newest N scans with a timeline, and old ones are removed from SITE`;

/** Bytes that a volume may take while it is read: most of the memory, shared by all processes. */
const shareOfMemory = 0.7;

/** The largest picture of a volume, pixels across: it takes minutes. */
const maxPoster = 1024;

/** Scans of a page of newest scans: more of them are no timeline that a person reads. */
const maxNewest = 1000;

async function writeMosaic(path: string, moment: string | undefined, out: string | undefined): Promise<void> {
  const { png, manifest, rounding, partial } = await makeRadarMosaic(
    new Uint8Array(readFileSync(path)),
    basename(path),
    moment,
  );
  const name = out ?? nameFiles(path, manifest.moment ?? '');
  writeFileSync(`${name}.png`, png);
  writeFileSync(`${name}.json`, formatManifest({ image: `${basename(name)}.png`, ...manifest }));
  const exact =
    rounding === 0
      ? 'values exactly as in the file'
      : `values within ${rounding.toPrecision(2)} ${manifest.unit ?? ''}`;
  console.log(
    `${name}.png and ${name}.json: ${manifest.slices} sweeps of ${inspect(manifest.moment)}, ${png.length} bytes, ${exact}`,
  );
  if (partial) console.error(`not all: ${partial}`);
}

function writeVolumePage(path: string, alt: string | undefined, out: string | undefined): void {
  const { size } = statSync(path);
  if (size > maxPageBytes)
    throw new RangeError(
      `${basename(path)} has ${Math.round(size / 2 ** 20)} MiB; expected at most ${maxPageBytes / 2 ** 20}: put it on a web server`,
    );
  const name = `${out ?? nameFiles(path)}.html`;
  writeFileSync(name, writePage(readFileSync(path), alt ?? basename(path)));
  console.log(`${name}: put volume-view.iife.js of the package volume-view next to it, and open it`);
}

async function writePyramids(path: string, out: string | undefined): Promise<void> {
  const { writeZarr } = await import('./write-zarr.ts');
  const name = out ?? nameFiles(path);
  for await (const { folder, dimensions, files, bytes, left } of writeZarr(path, name, shareOfMemory * totalmem())) {
    console.log(`${folder}: ${dimensions.join(' x ')} voxels, ${files} files, ${(bytes / 1e6).toFixed(1)} MB`);
    for (const line of left) console.error(`left out: ${line}`);
  }
}

interface VideoValues {
  readonly codec?: string;
  readonly error?: string;
}

async function readVideoOptions({ codec = 'vp9', error = '0' }: VideoValues): Promise<VideoOptions> {
  const { codecs } = await import('./ffmpeg.ts');
  const known = codecs.find((one) => one === codec);
  if (!known) throw new Misuse(`got --codec ${codec}; expected ${codecs.join(' or ')}`);
  const limit = Number(error);
  if (!(limit >= 0 && limit < Infinity))
    throw new Misuse(`got --error ${error}; expected a number from 0, in data values`);
  return { codec: known, error: limit };
}

async function writeFrames(
  paths: readonly string[],
  { moment, out, ...values }: VideoValues & { readonly moment?: string; readonly out?: string },
): Promise<void> {
  const options = await readVideoOptions(values);
  const { writeVideo } = await import('./write-video.ts');
  const written = await writeVideo(paths, { ...options, moment, deviceBytes: shareOfMemory * totalmem() }, out);
  const { lossy, unit, changed } = written;
  const say = (value: number): string => `${Number(value.toPrecision(3))} ${unit}`.trim();
  console.log(
    `${written.name}.webm and ${written.name}.json: ${written.scans.length} scans, ${written.bytes} bytes; values are off by ${say(lossy.rms)} (root mean square), ` +
      `99 % of them by at most ${say(lossy.p99)}, at most by ${say(lossy.max)}; pictures by ${lossy.picture?.rms.toPrecision(2)} of 255`,
  );
  if (changed > 0) console.error(`${(100 * changed).toPrecision(2)} % of the places have data before or after alone`);
  if (options.error > 0 && lossy.rms > options.error)
    console.error(
      `--error ${values.error} was not reached: 8 bits alone leave more. Allow a larger error, or write mosaics`,
    );
}

interface SiteValues extends VideoValues {
  readonly language?: string;
  readonly licence?: string;
  readonly credits?: string;
  readonly address?: string;
  readonly as: string;
  readonly out?: string;
  readonly moment?: string;
  readonly fit: string;
  readonly poster: string;
  readonly jobs?: string;
  readonly memory?: string;
  readonly timeout: string;
  readonly 'keep-names': boolean;
  readonly watch: boolean;
  readonly newest: string;
  readonly every: string;
  readonly settle: string;
}

async function writeSite(folder: string, values: SiteValues): Promise<void> {
  const { out, fit, moment } = values;
  if (out === undefined) throw new Misuse('got a folder without --out; expected --out SITE, the folder to write');
  const as = siteForms.find((one) => one === values.as);
  if (!as) throw new Misuse(`got --as ${values.as}; expected ${siteForms.join(', ')}`);
  if (fit !== 'desktop' && fit !== 'phone') throw new Misuse(`got --fit ${fit}; expected phone, or nothing`);
  const poster = readCount('poster', values.poster, [0, maxPoster]);
  const jobs = values.jobs === undefined ? undefined : readCount('jobs', values.jobs);
  const memory = values.memory === undefined ? totalmem() : 1e6 * readCount('memory', values.memory);
  if (values.watch && as !== 'mosaic') throw new Misuse(`got --as ${as} with --watch; expected mosaic, or nothing`);
  const player = new URL('./player/', import.meta.url);
  const request = {
    folder,
    site: out,
    options: {
      as,
      ...(await readFormOptions(as, values, player)),
      fit,
      poster,
      ...(moment === undefined ? {} : { moment }),
      keepNames: values['keep-names'],
      deviceBytes: (shareOfMemory * memory) / (jobs ?? availableParallelism()),
    },
    jobs,
    timeout: readCount('timeout', values.timeout),
    child: new URL('./child.js', import.meta.url),
    player,
    version,
  } satisfies FolderRequest;
  const output: Output = {
    line: (object) => console.log(JSON.stringify(object)),
    say: (text) => console.error(text),
    progress: (text) => void (process.stderr.isTTY && process.stderr.write(`\r${text}\x1b[K`)),
  };
  if (values.watch) return watchSite(request, values, output);
  const { prepareFolder } = await import('./prepare-folder.ts');
  process.exitCode = await prepareFolder(request, output);
}

/** Options that some forms have alone. */
async function readFormOptions(
  form: SiteForm,
  { codec, error, language = 'en', licence = '', credits = '', address }: SiteValues,
  player: URL,
): Promise<Pick<SiteOptions, 'video' | 'words'>> {
  const { checkPackageWords, isPackage } = await import('./write-packages.ts');
  if (!isPackage(form) && (licence || credits || address !== undefined))
    throw new Misuse(`got --licence, --credits or --address for ${form}; expected them with --as embed, scorm or h5p`);
  if (form !== 'video' && (codec ?? error) !== undefined)
    throw new Misuse(`got --codec or --error for ${form}; expected them with --as video`);
  if (form === 'video') {
    const video = await readVideoOptions({ codec, error });
    (await import('./ffmpeg.ts')).checkFfmpeg(video.codec);
    return { video };
  }
  if (!isPackage(form)) return {};
  if (!licence || !credits)
    throw new Misuse(
      `got --as ${form} without --licence and --credits; expected both, such as --licence "CC BY 4.0" --credits "MRI: Department of Radiology, 2024": what is passed on says whose data it has`,
    );
  if (address !== undefined && form !== 'embed')
    throw new Misuse(`got --address for ${form}; expected it with --as embed`);
  const { readPlayer } = await import('./lesson-forms.ts');
  const words = { language, licence, credits, ...(address === undefined ? {} : { address }) };
  checkPackageWords({ form, words, player: await readPlayer(fileURLToPath(player)) });
  return { words };
}

async function watchSite(request: FolderRequest, values: SiteValues, output: Output): Promise<void> {
  const { watchFolder } = await import('./watch-folder.ts');
  const stop = await watchFolder(
    request,
    {
      newest: readCount('newest', values.newest, [1, maxNewest]),
      every: readSeconds('every', values.every),
      settle: readSeconds('settle', values.settle),
    },
    output,
  );
  const end = (): void => {
    stop();
    process.exit(0);
  };
  process.once('SIGINT', end).once('SIGTERM', end);
}

interface LessonValues extends LessonWords {
  readonly as?: string;
  readonly pass?: string;
  readonly address?: string;
  readonly out?: string;
}

async function writeCourse(path: string, { as = 'page', pass, address, out, ...words }: LessonValues): Promise<void> {
  const { lessonForms } = await import('./lesson-forms.ts');
  const { writeLesson } = await import('./write-lesson.ts');
  const form = lessonForms.find((one) => one === as);
  if (!form) throw new Misuse(`got --as ${as}; expected ${lessonForms.join(', ')}`);
  if (pass !== undefined && !form.startsWith('scorm') && form !== 'cmi5')
    throw new Misuse(`got --pass for a ${form}; expected it with --as scorm or --as cmi5`);
  if (address !== undefined && form !== 'embed')
    throw new Misuse(`got --address for a ${form}; expected it with --as embed`);
  const percent = pass === undefined ? null : readCount('pass', pass, [1, 100]);
  const written = await writeLesson(path, {
    as: form,
    pass: percent,
    address,
    out,
    words,
    player: new URL('./player/', import.meta.url),
  });
  for (const line of written.left) console.error(`left out: ${line}`);
  const size = `${(written.bytes / 1e6).toFixed(1)} MB`;
  console.log(`${written.name}: ${written.count} ${written.count === 1 ? 'file' : 'files'}, ${size}`);
  if (written.isLarge)
    console.error(
      `${written.name} has ${size}: many mail systems and courses take at most 25 MB, and a phone may not open it`,
    );
}

function readCount(name: string, text: string, [low, high] = [1, Number.MAX_SAFE_INTEGER]): number {
  const count = Number(text);
  const limit = high < Number.MAX_SAFE_INTEGER ? ` to ${high}` : '';
  if (!/^\d+$/.test(text) || count < low || count > high)
    throw new Misuse(`got --${name} ${text}; expected a whole number from ${low}${limit}`);
  return count;
}

function readSeconds(name: string, text: string): number {
  const seconds = Number(text);
  // A day; a timer takes 24 of them at most.
  if (!(seconds >= 0.1 && seconds <= 86_400))
    throw new Misuse(`got --${name} ${text}; expected a number of seconds from 0.1 to 86400`);
  return seconds;
}

async function main(): Promise<void> {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      as: { type: 'string' },
      moment: { type: 'string' },
      alt: { type: 'string' },
      out: { type: 'string' },
      fit: { type: 'string', default: 'desktop' },
      poster: { type: 'string', default: '256' },
      jobs: { type: 'string' },
      memory: { type: 'string' },
      timeout: { type: 'string', default: '1800' },
      watch: { type: 'boolean', default: false },
      newest: { type: 'string', default: '12' },
      every: { type: 'string', default: '10' },
      settle: { type: 'string', default: '10' },
      title: { type: 'string' },
      language: { type: 'string' },
      licence: { type: 'string' },
      credits: { type: 'string' },
      pass: { type: 'string' },
      codec: { type: 'string' },
      error: { type: 'string' },
      address: { type: 'string' },
      'keep-names': { type: 'boolean', default: false },
      deface: { type: 'boolean', default: false },
      help: { type: 'boolean', short: 'h' },
      version: { type: 'boolean' },
    },
  });
  if (values.help) return console.log(usage);
  if (values.version) return console.log(version);
  const [path] = positionals;
  if (values.as === 'video' && path !== undefined && !positionals.some((one) => statSync(one).isDirectory()))
    return writeFrames(positionals, values);
  if (positionals.length !== 1) throw new Misuse(`got ${positionals.length} files; expected one`);
  if (values.deface)
    throw new Misuse(
      'got --deface; expected data without faces: a rendered head shows the face of a person. Programs that remove faces are pydeface, mri_deface and mideface (FreeSurfer), fsl_deface (FSL), quickshear, and afni_refacer_run (AFNI). Run one of them, look at the result, then prepare that',
    );
  if (/\.x?html?$/i.test(path)) return writeCourse(path, values);
  const as = values.as ?? 'mosaic';
  if (statSync(path).isDirectory()) return writeSite(path, { ...values, as });
  if (as === 'mosaic') return writeMosaic(path, values.moment, values.out);
  if (as === 'page') return writeVolumePage(path, values.alt, values.out);
  if (as === 'ome-zarr') return writePyramids(path, values.out);
  throw new Misuse(`got --as ${as}; expected mosaic, page or ome-zarr, or video for scans in time`);
}

await main().catch((error: unknown) => {
  console.error(error instanceof Error ? error.message : String(error));
  if (error instanceof Misuse) console.error(usage);
  process.exitCode = 1;
});
