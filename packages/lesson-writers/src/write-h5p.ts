// A lesson as an H5P package: the lesson as content, and the element as a library of H5P (https://h5p.org/documentation/developers).
import { version } from '../package.json';
import course from './course.js?raw';
import ownStyles from './h5p.css?raw';
import styles from './lesson.css?raw';
import { directionOf } from './direction-of.ts';
import { cleanPath, dataFolder } from './lesson-paths.ts';
import type { Lesson, LessonFile, LessonProblem, Player } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { escapeMarkup } from './write-html.ts';
import { checkLesson, encode, playerScript, sortFiles, writeContent, writeCredits } from './write-page.ts';

/** The name and version that H5P keeps the library by. A host replaces a library by one with a higher `patchVersion`. */
const library = { machineName: 'H5P.VolumeViewLesson', majorVersion: 1, minorVersion: 0 } as const;
const patchVersion = version.split('.').reduce((sum, part) => 100 * sum + Number.parseInt(part, 10), 0);

/** The folder of the library, and the script with which it begins. */
const libraryFolder = `${library.machineName}-${library.majorVersion}.${library.minorVersion}/`;
const libraryScript = 'h5p.js';

/** Endings of content that a host takes by default, with their types. Source: H5PConfig of the H5P servers, `contentWhitelist`. */
const types: Readonly<Record<string, string>> = {
  json: 'application/json',
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  gif: 'image/gif',
  tif: 'image/tiff',
  tiff: 'image/tiff',
  txt: 'text/plain',
  gltf: 'model/gltf+json',
  glb: 'model/gltf-binary',
  vtt: 'text/vtt',
  csv: 'text/csv',
};

/** H5P's names of licences: `CC BY-SA`, in the versions that it knows. */
const licences = /^(CC BY(?:-NC)?(?:-SA|-ND)?|CC0)(?: (1\.0|2\.0|2\.5|3\.0|4\.0))?$/;

/**
 * The files of a lesson as an H5P package. It becomes a ZIP archive with the ending `.h5p`.
 * @throws {LessonError} where something in the lesson is refused, or its data have an ending that H5P does not take
 */
export function writeH5pFiles(lesson: Lesson, player: Player): LessonFile[] {
  const nodes = checkLesson(lesson);
  const paths = lesson.files.map(({ path }) => cleanPath(path) ?? '');
  const problems = paths.filter((path) => typeOf(path) === null).map(describeUnfit);
  if (problems.length > 0) throw new LessonError(problems);
  for (const name of [playerScript, libraryScript])
    if (!player.some(({ path }) => path === name)) throw new RangeError(`the player lacks ${name}`);
  const form = {
    addressOf: (path: string) => path.split('/').map(encodeURIComponent).join('/'),
    linksLeave: true,
    leftOut: ['remember', 'link-state'],
  };
  const { language } = lesson;
  const html = `<main lang="${escapeMarkup(language)}" dir="${directionOf(language)}">${writeContent(lesson, nodes, form)}</main><footer class="credits">${writeCredits(lesson)}</footer>`;
  const content = {
    html: escapeMarkup(html),
    files: paths.map((path) => ({
      name: path,
      file: { path: dataFolder + path, mime: typeOf(path), copyright: { license: 'U' } },
    })),
  };
  const write = (path: string, value: unknown): LessonFile => ({
    path,
    bytes: encode(`${JSON.stringify(value, null, 2)}\n`),
  });
  return sortFiles([
    write('h5p.json', describeContent(lesson)),
    write('content/content.json', content),
    ...lesson.files.map(({ bytes }, i) => ({ path: `content/${dataFolder}${paths[i]}`, bytes })),
    write(`${libraryFolder}library.json`, describeLibrary()),
    write(`${libraryFolder}semantics.json`, semantics),
    { path: `${libraryFolder}course.js`, bytes: encode(course) },
    { path: `${libraryFolder}lesson.css`, bytes: encode(`${styles}\n${ownStyles}`) },
    ...player
      .filter(({ path }) => !path.startsWith('embed.'))
      .map(({ path, bytes }) => ({ path: libraryFolder + path, bytes })),
  ]);
}

const typeOf = (path: string): string | null => types[/\.([a-z]+)$/.exec(path)?.[1] ?? ''] ?? null;

const describeUnfit = (path: string): LessonProblem => ({
  message: `H5P does not take a file like ${path}; expected one of .${Object.keys(types).join(', .')}: "volume-view-prepare FOLDER --out SITE" makes a PNG with its .json of a volume`,
  line: null,
});

function describeContent({ title, language, licence, credits }: Lesson): object {
  const [, name, inVersion] = licences.exec(licence.trim()) ?? [];
  return {
    title: title.trim().replace(/\s+/g, ' ').slice(0, 255),
    language: language.slice(0, 10),
    mainLibrary: library.machineName,
    embedTypes: ['iframe'],
    license: name === 'CC0' ? 'CC0 1.0' : (name ?? 'U'),
    ...(name && name !== 'CC0' && inVersion && { licenseVersion: inVersion }),
    licenseExtras: licence,
    authors: [{ name: credits.trim().replace(/\s+/g, ' ').slice(0, 255), role: 'Author' }],
    preloadedDependencies: [library],
  };
}

function describeLibrary(): object {
  return {
    title: 'Lesson with volumes',
    description: 'A lesson with CT, MRI or radar scans that turn under the pointer, with notes, a tour and questions',
    ...library,
    patchVersion,
    runnable: 1,
    fullscreen: 0,
    embedTypes: ['iframe'],
    author: 'The volume-view authors',
    license: 'MIT',
    coreApi: { majorVersion: 1, minorVersion: 19 },
    preloadedJs: [{ path: libraryScript }],
    preloadedCss: [{ path: 'volume-view.css' }, { path: 'lesson.css' }],
  };
}

/** What H5P's own editor shows, and what it copies with the content. The lesson itself is edited where it was made. */
const semantics = [
  {
    name: 'html',
    type: 'text',
    widget: 'textarea',
    label: 'Lesson',
    description: 'Made in the lesson studio of volume-view, which opens the .html of this lesson again.',
    importance: 'low',
    maxLength: 2_000_000,
  },
  {
    name: 'files',
    type: 'list',
    label: 'Files of the lesson',
    entity: 'file',
    importance: 'low',
    optional: true,
    field: {
      name: 'named',
      type: 'group',
      label: 'File',
      fields: [
        { name: 'name', type: 'text', label: 'Its name in the lesson', maxLength: 200 },
        { name: 'file', type: 'file', label: 'File' },
      ],
    },
  },
];
