import { readdir, readFile, stat } from 'node:fs/promises';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { LessonError, largeFile, listManifestFiles, readLesson } from '../../lesson-writers/src/index.ts';
import type { Lesson, LessonFile, LessonProblem } from '../../lesson-writers/src/index.ts';
import { makeLessonFiles, maxLessonBytes, readPlayer, zipFiles } from './lesson-forms.ts';
import type { LessonForm, LessonFormOptions } from './lesson-forms.ts';
import { nameFiles } from './name-files.ts';
import { writeFolder, writeWhole } from './write-folder.ts';

/** What is said of a lesson, where its HTML does not say it, or says something else. */
export interface LessonWords {
  readonly title?: string;
  readonly language?: string;
  readonly licence?: string;
  readonly credits?: string;
}

interface LessonOptions extends LessonFormOptions {
  readonly out: string | undefined;
  readonly words: LessonWords;
  /** The folder with the element's own files. */
  readonly player: URL;
}

/**
 * Reads a lesson with the files that it names, and writes it: a folder, a page, or a ZIP archive.
 * @param path - of the HTML
 * @throws {LessonError} where something in it is refused
 */
export async function writeLesson(path: string, { as, pass, address, out, words, player }: LessonOptions) {
  const { lesson, left } = await readLessonFiles(path, words);
  const files = makeLessonFiles(lesson, await readPlayer(fileURLToPath(player)), { as, pass, address });
  const own = nameFiles(path.replace(/\.x?html?$/i, ''));
  const target = resolve(out ?? own + endings[as]);
  const one = as === 'page' || as === 'embed' ? null : as === 'single-file' ? files[0].bytes : zipFiles(files);
  if (one && target === resolve(path)) throw new RangeError('got the lesson itself as --out; expected another name');
  if (one) await writeWhole(dirname(target), basename(target), one);
  else {
    await checkFolder(target);
    await writeFolder(
      dirname(target),
      basename(target),
      files.map((file) => [file.path, file.bytes] as const),
    );
  }
  const bytes = one?.length ?? files.reduce((sum, file) => sum + file.bytes.length, 0);
  const isLarge = as === 'single-file' && bytes > largeFile;
  return { name: out ?? basename(target), count: files.length, bytes, left, isLarge };
}

/** How names end that are made from that of the lesson. */
const endings: Readonly<Record<LessonForm, string>> = {
  page: '-page',
  'single-file': '-single.html',
  embed: '-embed',
  scorm: '.zip',
  'scorm-2004': '.zip',
  cmi5: '-cmi5.zip',
  h5p: '.h5p',
};

/** A folder is written as a whole: one with other files stays. */
async function checkFolder(path: string): Promise<void> {
  const names = await readdir(path).catch((): string[] => []);
  if (names.length > 0 && !names.includes('lesson.css'))
    throw new RangeError(
      `got --out ${basename(path)}, where other files are; expected a new folder, or one with an earlier page of a lesson`,
    );
}

/** The files that the HTML names, and those that their manifests name. */
async function readLessonFiles(path: string, words: LessonWords): Promise<{ lesson: Lesson; left: readonly string[] }> {
  const html = await readFile(path, 'utf8');
  const { named, head, left, problems } = readLesson(html);
  const missing: LessonProblem[] = [];
  const files = new Map<string, LessonFile>();
  const wanted = [...named];
  let total = 0;
  for (let name = wanted.shift(); name !== undefined; name = wanted.shift()) {
    if (files.has(name)) continue;
    const place = join(dirname(path), name);
    const found = await stat(place).catch(() => null);
    const refuse = (message: string): number => missing.push({ message, line: null });
    if (!found) refuse(`got no file ${name}; expected it in the folder of ${basename(path)}`);
    else if (!found.isFile())
      refuse(`${name} is a folder; expected a file (an OME-Zarr as .ozx, DICOM as a ZIP archive)`);
    else if ((total += found.size) > maxLessonBytes)
      refuse(
        `the files have more than ${maxLessonBytes / 2 ** 20} MiB; expected less: a mosaic of volume-view-prepare is smaller`,
      );
    else {
      const file = { path: name, bytes: new Uint8Array(await readFile(place)) };
      files.set(name, file);
      wanted.push(...listManifestFiles(file).filter((one) => one !== null));
    }
  }
  const { title, language, licence, credits } = words;
  const lesson = {
    html,
    files: [...files.values()],
    title: title ?? head.title ?? '',
    language: language ?? head.language ?? '',
    licence: licence ?? head.license ?? '',
    credits: credits ?? head.author ?? '',
  };
  const lacking = describeLacking(lesson);
  if (missing.length + lacking.length > 0) throw new LessonError([...problems, ...missing, ...lacking]);
  return { lesson, left };
}

/** What neither the page nor the arguments say, with where to write it. */
function describeLacking({ title, language, licence, credits }: Lesson): LessonProblem[] {
  return [
    title || 'got no title; expected <title> in the head of the page, or --title',
    language || 'got no language; expected <html lang="en">, or --language en',
    licence ||
      'got no licence of the data; expected <meta name="license" content="CC BY 4.0"> in the head of the page, or --licence',
    credits ||
      'got no credits for the data; expected <meta name="author" content="…"> in the head of the page, or --credits',
  ].flatMap((text, i) => ([title, language, licence, credits][i] ? [] : [{ message: text, line: null }]));
}
