import { directionOf } from './direction-of.ts';
import styles from './lesson.css?raw';
import { listManifestFiles } from './manifest-files.ts';
import { cleanPath, dataFolder, writeAddress } from './lesson-paths.ts';
import type { Lesson, LessonFile, LessonProblem, Player } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { readLesson } from './read-lesson.ts';
import type { LessonNode } from './check-lesson-html.ts';
import { escapeMarkup, writeNodes } from './write-html.ts';
import type { HtmlForm } from './write-html.ts';

/** The folder of the element's own files, next to the page. */
export const playerFolder = 'volume-view/';

/** The script of the element, in that folder. */
export const playerScript = 'volume-view.iife.js';

/**
 * What a browser may load for the page: its own files only, whatever a file of the lesson says. The element reads data in workers that it makes
 * itself, some of them with WebAssembly.
 */
const policy =
  "default-src 'self' data: blob:; script-src 'self' blob: 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; form-action 'none'";

/**
 * The end of the head of a page with the element's own files next to it.
 * @param connect - where its scripts may send something to; the page's own files where undefined
 * @param script - whether the element is loaded at once
 * @param playerAt - the address of the folder with the element's own files
 */
export function writeHead({
  connect,
  script = true,
  playerAt = playerFolder,
}: {
  readonly connect?: string;
  readonly script?: boolean;
  readonly playerAt?: string;
}): string {
  const whole = connect ? `${policy}; connect-src ${connect}` : policy;
  const tag = script ? `<script src="${playerAt}${playerScript}"></script>\n` : '';
  return `<meta http-equiv="Content-Security-Policy" content="${whole}">\n<link rel="stylesheet" href="${playerAt}volume-view.css">\n<link rel="stylesheet" href="lesson.css">\n${tag}`;
}

/** The longest title, licence or credits. */
const maxText = 2000;

const encoder = new TextEncoder();
export const encode = (text: string): Uint8Array => encoder.encode(text);

/** How the page of a lesson is written. */
export interface PageForm extends HtmlForm {
  /** HTML at the end of the head. */
  readonly head: string;
  /** HTML at the end of the body. */
  readonly end: string;
}

/** Each file of the lesson in its folder, the page's own files next to it. */
export const folderForm: PageForm = {
  addressOf: writeAddress,
  linksLeave: false,
  leftOut: [],
  head: writeHead({}),
  end: '',
};

/**
 * The files of a lesson as a page: `index.html`, a style sheet, the element and the data.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writePageFiles(lesson: Lesson, player: Player, form: Partial<PageForm> = {}): LessonFile[] {
  const nodes = checkLesson(lesson);
  if (!player.some(({ path }) => path === playerScript)) throw new RangeError(`the player lacks ${playerScript}`);
  return sortFiles([
    { path: 'index.html', bytes: encode(writePage(lesson, nodes, { ...folderForm, ...form })) },
    { path: 'lesson.css', bytes: encode(styles) },
    ...player
      .filter(({ path }) => !/^(?:embed|h5p)\./.test(path))
      .map(({ path, bytes }) => ({ path: playerFolder + path, bytes })),
    ...lesson.files.map(({ path, bytes }) => ({ path: dataFolder + cleanPath(path), bytes })),
  ]);
}

/** Whether a file of the player is for the pages of frames only. */
export const isForFrames = (path: string): boolean => path.startsWith('embed.');

/** Files in the order of their paths: the same lesson is the same list. */
export function sortFiles(files: readonly LessonFile[]): LessonFile[] {
  const sorted = [...files];
  sorted.sort((a, b) => (a.path < b.path ? -1 : a.path > b.path ? 1 : 0));
  return sorted;
}

/** @returns the checked HTML @throws {LessonError} */
export function checkLesson(lesson: Lesson): readonly LessonNode[] {
  const { nodes, named, problems } = readLesson(lesson.html);
  const more: LessonProblem[] = [];
  const refuse = (message: string): number => more.push({ message, line: null });
  if (!/^[A-Za-z]{2,8}(-[A-Za-z0-9]{1,8}){0,5}$/.test(lesson.language))
    refuse('got no language; expected one as HTML has it, like "en" or "pt-BR"');
  for (const [name, text, example] of [
    ['title', lesson.title, 'The brain in five steps'],
    ['licence', lesson.licence, 'CC BY 4.0'],
    ['credits', lesson.credits, 'MRI: Department of Radiology, 2024'],
  ] as const) {
    if (text.trim() === '') refuse(`got no ${name}; expected a text, like "${example}"`);
    if (text.length > maxText) refuse(`got a ${name} of ${text.length} characters; expected at most ${maxText}`);
  }
  const paths = lesson.files.map(({ path }) => cleanPath(path));
  if (paths.includes(null))
    refuse('got a file whose path leads out of the folder of the lesson, or has signs that some systems refuse');
  // Some systems do not distinguish a letter from its capital.
  if (new Set(paths.map((path) => path?.toLowerCase())).size < paths.length) refuse('got two files with one path');
  for (const path of named)
    if (!paths.includes(path)) refuse(`the lesson names ${path}; expected that file next to it`);
  for (const file of lesson.files)
    for (const path of listManifestFiles(file))
      if (path === null) refuse(`${file.path} names a file elsewhere; expected a file in the folder of the lesson`);
      else if (!paths.includes(path)) refuse(`${file.path} names ${path}; expected that file next to it`);
  const all = [...problems, ...more];
  if (all.length > 0) throw new LessonError(all);
  return nodes;
}

/** The page of a lesson, with its licence and credits below it. */
export function writePage(lesson: Lesson, nodes: readonly LessonNode[], form: PageForm): string {
  return writeDocument(
    lesson,
    form.head,
    `<main>
${writeContent(lesson, nodes, form)}
</main>
<footer class="credits">
${writeCredits(lesson)}</footer>
${form.end}`,
  );
}

/** A document about a lesson. @param head - HTML at the end of the head */
export function writeDocument({ title, language, licence, credits }: Lesson, head: string, body: string): string {
  return `<!doctype html>
<html lang="${escapeMarkup(language)}"${directionOf(language) === 'rtl' ? ' dir="rtl"' : ''}>
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escapeMarkup(title)}</title>
<meta name="author" content="${escapeMarkup(credits)}">
<meta name="license" content="${escapeMarkup(licence)}">
${head}</head>
<body>
${body}</body>
</html>
`;
}

/** The lesson, with its title where it has no heading of its own. */
export function writeContent({ title }: Lesson, nodes: readonly LessonNode[], form: HtmlForm): string {
  const heading = nodes.some(hasHeading) ? '' : `<h1>${escapeMarkup(title)}</h1>\n`;
  return `${heading}${writeNodes(nodes, form).trim()}`;
}

/** Who made the data, and under which licence: each page shows it. */
export const writeCredits = ({ licence, credits }: Lesson): string => `<p>${escapeMarkup(credits)}</p>
<p>${/^https?:\/\/[^\s]+$/.test(licence) ? `<a href="${escapeMarkup(licence)}" rel="license noopener noreferrer" target="_blank">${escapeMarkup(licence)}</a>` : escapeMarkup(licence)}</p>
`;

const hasHeading = (node: LessonNode): boolean =>
  typeof node !== 'string' && (node.name === 'h1' || node.children.some(hasHeading));
