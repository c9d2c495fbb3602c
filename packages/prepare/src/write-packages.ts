// Volumes as pages for frames, and as packages for courses: each is a lesson with one view.
import { VolumeViewError } from '../../../src/core/errors.ts';
import { escapeMarkup, LessonError } from '../../lesson-writers/src/index.ts';
import type { Lesson, LessonFile } from '../../lesson-writers/src/index.ts';
import { formatManifest } from './format-manifest.ts';
import type { DoneLine, PackageForm, PackageWords, SiteForm } from './job.ts';
import { makeLessonFiles, maxLessonBytes, zipFiles } from './lesson-forms.ts';
import { Misuse } from './misuse.ts';
import { altOf, describeScans } from './site-pages.ts';

/** The names of packages. */
const packageNames: Readonly<Record<Exclude<PackageForm, 'embed'>, string>> = {
  scorm: 'scorm.zip',
  'scorm-2004': 'scorm-2004.zip',
  cmi5: 'cmi5.zip',
  h5p: 'scan.h5p',
};

export const isPackage = (form: SiteForm): form is PackageForm => form === 'embed' || form in packageNames;

/** What of a scan's folder an index links to. */
export const pageOf = (form: SiteForm): string =>
  isPackage(form) && form !== 'embed' ? packageNames[form] : 'index.html';

/** A volume in memory. */
export interface PackedScan {
  readonly line: DoneLine;
  readonly png: Uint8Array;
  /** Without the name of the image. */
  readonly manifest: object;
  readonly poster: Uint8Array | null;
}

export interface PackageOptions {
  readonly form: PackageForm;
  readonly words: PackageWords;
  readonly player: readonly LessonFile[];
}

/**
 * The files of a folder with one volume, or with all scans in time of one.
 * @throws {VolumeViewError} `format/too-large`
 */
export function packScans(
  scans: readonly PackedScan[],
  { form, words, player }: PackageOptions,
): (readonly [name: string, content: Uint8Array])[] {
  const [{ line, poster }] = scans;
  const lesson = writeLessonOf(scans, words);
  const bytes = lesson.files.reduce((sum, file) => sum + file.bytes.length, 0);
  if (bytes > maxLessonBytes)
    throw new VolumeViewError(
      'format/too-large',
      `a package of it has ${Math.round(bytes / 2 ** 20)} MiB; expected at most ${maxLessonBytes / 2 ** 20}: --fit phone makes it smaller`,
    );
  const address = words.address && `${words.address.replace(/\/*$/, '/')}${line.id}/`;
  const files = makeLessonFiles(lesson, player, { as: form, pass: null, address, sharedPlayer: true });
  const own = form === 'embed' ? files.map((file) => [file.path, file.bytes] as const) : null;
  // The index shows it.
  const shown = poster ? [['poster.png', poster] as const] : [];
  return [...shown, ...(own ?? [[packageNames[form as keyof typeof packageNames], zipFiles(files)] as const])];
}

/** @throws {Misuse} where the words are such that no package can be made */
export function checkPackageWords({ form, words, player }: PackageOptions): void {
  const file = { path: 'volume.json', bytes: new TextEncoder().encode('{}') };
  const lesson = {
    ...words,
    html: '<volume-view alt="Scan" src="volume.json"></volume-view>',
    files: [file],
    title: 'Scan',
  };
  try {
    makeLessonFiles(lesson, player, { as: form, pass: null, address: words.address });
  } catch (error) {
    throw error instanceof LessonError ? new Misuse(error.message) : error;
  }
}

function writeLessonOf(scans: readonly PackedScan[], { language, licence, credits }: PackageWords): Lesson {
  const [{ line, manifest, poster }] = scans;
  const isSeries = scans.length > 1;
  const imageOf = (i: number): string => (isSeries ? `volume-${i + 1}.png` : 'volume.png');
  const own = isSeries
    ? {
        scans: scans.map((scan, i) => ({
          ...scan.manifest,
          title: line.title,
          image: imageOf(i),
          ...(scan.line.time === undefined ? {} : { time: scan.line.time }),
        })),
      }
    : { title: line.title, ...manifest, image: imageOf(0) };
  const files: LessonFile[] = [
    { path: 'volume.json', bytes: new TextEncoder().encode(formatManifest(own)) },
    ...scans.map(({ png }, i) => ({ path: imageOf(i), bytes: png })),
    ...(poster ? [{ path: 'poster.png', bytes: poster }] : []),
  ];
  const html = `<h1>${escapeMarkup(line.title)}</h1>
<volume-view id="view" controls alt="${escapeMarkup(altOf(line))}" src="volume.json"${poster ? ' poster="poster.png"' : ''}></volume-view>
${isSeries ? '<volume-timeline for="view"></volume-timeline>\n' : ''}<p>${escapeMarkup(describeScans(scans.map((scan) => ({ ...scan.line, form: 'mosaic' }))))}</p>
`;
  return { html, files, title: line.title, language, licence, credits };
}
