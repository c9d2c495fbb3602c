// Writes the files that an author takes away, and opens them again.
import { unzipSync, zipSync } from 'fflate';
import type { Zippable } from 'fflate';
import {
  escapeMarkup,
  unescapeMarkup,
  writeCmi5Files,
  writeEmbedFiles,
  writeH5pFiles,
  writePageFiles,
  writeScormFiles,
  writeSingleFile,
} from '../../../lesson-writers/src/index.ts';
import type { Lesson as WrittenLesson, LessonFile } from '../../../lesson-writers/src/index.ts';
import type { Lesson } from '../model/lesson.ts';
import { readLessonHtml } from '../model/read-lesson.ts';
import { writeLessonHtml } from '../model/write-lesson.ts';
import { loadPart } from './parts.ts';
import { newDataId } from './prepare.ts';
import type { LessonData } from './prepare.ts';

export type ExportKind = 'page' | 'single-file' | 'embed' | 'scorm' | 'scorm-2004' | 'cmi5' | 'h5p';

export interface ExportOptions {
  readonly kind: ExportKind;
  /** Percent of the questions to pass a course; null for none. */
  readonly pass: number | null;
  /** Where a folder for frames will be. */
  readonly address: string;
  /** The picture that a folder for frames shows first; null for none. */
  readonly poster: LessonFile | null;
}

/** The lesson as the writers take it. */
export function toWritten(lesson: Lesson, data: LessonData, poster: LessonFile | null = null): WrittenLesson {
  const { title, language, licence, credits } = lesson;
  const html = writeLessonHtml(lesson, data.files[0].path, poster?.path);
  return { html, files: [...data.files, ...(poster ? [poster] : [])], title, language, licence, credits };
}

/** How the name of a file ends that an author takes away. */
export const endingOf = (kind: ExportKind): string =>
  ({ page: '.zip', 'single-file': '.html', h5p: '.h5p' } as Partial<Record<ExportKind, string>>)[kind] ??
  `-${kind}.zip`;

/** @throws {LessonError} where the writers refuse something */
export async function exportLesson(lesson: Lesson, data: LessonData, options: ExportOptions): Promise<Uint8Array> {
  const player = Object.entries(unzipSync(await loadPart('player'))).map(([path, bytes]) => ({ path, bytes }));
  return writeLesson(lesson, data, player, options);
}

/** The bytes of the file that an author takes away: a page, or a ZIP archive. @throws {LessonError} */
export function writeLesson(
  lesson: Lesson,
  data: LessonData,
  player: readonly LessonFile[],
  { kind, pass, address, poster }: ExportOptions,
): Uint8Array {
  switch (kind) {
    case 'page':
      return zipFiles(writePageFiles(toWritten(lesson, data), player));
    case 'single-file':
      return writeSingleFile(toWritten(lesson, data), player)[0].bytes;
    case 'embed':
      return zipFiles(writeEmbedFiles(toWritten(lesson, data, poster), player, { address }));
    case 'cmi5':
      return zipFiles(writeCmi5Files(toWritten(lesson, data), player, { pass }));
    case 'h5p':
      return zipFiles(writeH5pFiles(toWritten(lesson, data), player));
    case 'scorm':
    case 'scorm-2004':
      return zipFiles(
        writeScormFiles(toWritten(lesson, data), player, { version: kind === 'scorm' ? '1.2' : '2004', pass }),
      );
  }
}

/** A fixed time, so that the same lesson always gives the same bytes. ZIP knows no time zones and no earlier year. */
const zipTime = new Date(1980, 0, 2);

function zipFiles(files: readonly LessonFile[]): Uint8Array {
  const entries: Zippable = {};
  for (const { path, bytes } of files)
    entries[path] = [bytes, { level: /\.(?:gz|png|webp)$/i.test(path) ? 0 : 6, mtime: zipTime }];
  return zipSync(entries);
}

/** A lesson that was opened. */
export interface OpenedLesson {
  readonly lesson: Lesson;
  /** null where only its HTML was opened. */
  readonly data: LessonData | null;
  readonly left: readonly string[];
}

/** Bytes of all files of a package that is opened. */
const maxBytes = 2 ** 29;

/** Opens a package or a page of a lesson. @returns null where it is none */
export async function openLesson(file: Blob): Promise<OpenedLesson | null> {
  if (file.size > maxBytes) return null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isZip = bytes[0] === 0x50 && bytes[1] === 0x4b;
  return isZip ? openPackage(bytes) : openPage(new TextDecoder().decode(bytes));
}

/** A page alone. One that was written as a single file holds its data as the address of its view. */
async function openPage(html: string): Promise<OpenedLesson | null> {
  let inside: string | null = null;
  const light = html
    .replace(/<script\b[^>]*>.*?<\/script>/gs, '')
    .replace(/ src="(data:application\/json[^"]*)"/, (_, address: string) => {
      inside = address;
      return ' src="volume.json"';
    });
  const read = readLessonHtml(light);
  if (!read) return null;
  const data = inside === null ? null : await readDataUrl(inside);
  return { lesson: { ...read.lesson, data: data?.id ?? null }, data, left: read.left };
}

/** A manifest with its image inside. @returns null where it is damaged */
async function readDataUrl(address: string): Promise<LessonData | null> {
  try {
    const text = await (await fetch(address.replaceAll('&amp;', '&'))).text();
    JSON.parse(text);
    return { id: newDataId(), files: [{ path: 'volume.json', bytes: new TextEncoder().encode(text) }] };
  } catch {
    return null;
  }
}

/** The name of a poster among the files of a lesson: it is drawn again for each folder. */
export const posterName = (type: string): string => (type === 'image/webp' ? 'poster.webp' : 'poster.png');

const isPoster = (name: string): boolean => /^poster\.(?:webp|png)$/.test(name);

/** The script of a package for a course: it is written again. */
const courseScript = /<script src="(?:course|cmi5)\.js"[^>]*><\/script>/;

function openPackage(bytes: Uint8Array): OpenedLesson | null {
  let files: Record<string, Uint8Array>;
  let total = 0;
  try {
    files = unzipSync(bytes, {
      filter: ({ name, originalSize }) =>
        /^(index\.html|h5p\.json|content\/content\.json|(content\/)?data\/[^/]+)$/.test(name) &&
        (total += originalSize) <= maxBytes,
    });
  } catch {
    return null; // It is damaged, or no archive.
  }
  if (files['content/content.json']) return openH5p(files);
  const page = files['index.html'];
  const read = page && readLessonHtml(new TextDecoder().decode(page).replace(courseScript, ''));
  if (!read) return null;
  const first = decodeURIComponent(read.src).replace(/#.*$/, '');
  const names = Object.keys(files).filter(
    (name) => name.startsWith('data/') && name !== first && !isPoster(name.replace('data/', '')),
  );
  const data: LessonData | null = files[first]
    ? {
        id: newDataId(),
        files: [first, ...names].map((name) => ({ path: name.replace(/^data\//, ''), bytes: files[name] })),
      }
    : null;
  return { lesson: { ...read.lesson, data: data?.id ?? null }, data, left: read.left };
}

/** A package of H5P: its content has the HTML, and the names of its files. @returns null where it is none of ours */
function openH5p(files: Readonly<Record<string, Uint8Array>>): OpenedLesson | null {
  const readJson = (path: string): Record<string, unknown> =>
    (JSON.parse(new TextDecoder().decode(files[path])) ?? {}) as Record<string, unknown>;
  try {
    const { html, files: listed } = readJson('content/content.json');
    const { title, language, licenseExtras: licence, authors } = readJson('h5p.json');
    const text = (value: unknown): string => (typeof value === 'string' ? escapeMarkup(value) : '');
    const credits = (authors as { name?: unknown }[] | undefined)?.[0]?.name;
    const head = `<title>${text(title)}</title><meta name="license" content="${text(licence)}"><meta name="author" content="${text(credits)}">`;
    const read = readLessonHtml(
      `<html lang="${text(language)}"><head>${head}</head><body>${unescapeMarkup(String(html))}</body></html>`,
    );
    if (!read) return null;
    const named = (listed as { name: string; file: { path: string } }[]).flatMap(({ name, file }) => {
      const bytes = files[`content/${file.path}`];
      return bytes ? [{ path: name, bytes }] : [];
    });
    const first = named.find(({ path }) => path === decodeURIComponent(read.src).replace(/#.*$/, ''));
    const data = first ? { id: newDataId(), files: [first, ...named.filter((one) => one !== first)] } : null;
    return { lesson: { ...read.lesson, data: data?.id ?? null }, data, left: read.left };
  } catch {
    return null; // It is damaged.
  }
}
