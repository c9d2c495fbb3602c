// What a lesson becomes: a folder, one page, or an archive.
import { readdir, readFile } from 'node:fs/promises';
import { join, relative } from 'node:path';
import { zipSync } from 'fflate';
import type { Zippable } from 'fflate';
import {
  writeCmi5Files,
  writeEmbedFiles,
  writeH5pFiles,
  writePageFiles,
  writeScormFiles,
  writeSingleFile,
} from '../../lesson-writers/src/index.ts';
import type { Lesson, LessonFile } from '../../lesson-writers/src/index.ts';

export const lessonForms = ['page', 'single-file', 'embed', 'scorm', 'scorm-2004', 'cmi5', 'h5p'] as const;

export type LessonForm = (typeof lessonForms)[number];

export interface LessonFormOptions {
  readonly as: LessonForm;
  /** Percent of the questions. */
  readonly pass: number | null;
  /** Where the folder of a lesson for frames will be. */
  readonly address: string | undefined;
  /** The element's own files are in the folder of several lessons for frames. */
  readonly sharedPlayer?: boolean;
}

/** Bytes of all files of a lesson: a package is made in memory, and few courses take larger ones. */
export const maxLessonBytes = 2 ** 29;

/**
 * The files of a lesson in a form.
 * @throws {LessonError} where something in it is refused
 */
export function makeLessonFiles(
  lesson: Lesson,
  player: readonly LessonFile[],
  { as, pass, address = '', sharedPlayer }: LessonFormOptions,
): LessonFile[] {
  if (as === 'page') return writePageFiles(lesson, player);
  if (as === 'embed') return writeEmbedFiles(lesson, player, { address, sharedPlayer });
  if (as === 'single-file') return writeSingleFile(lesson, player);
  if (as === 'h5p') return writeH5pFiles(lesson, player);
  if (as === 'cmi5') return writeCmi5Files(lesson, player, { pass });
  return writeScormFiles(lesson, player, { version: as === 'scorm' ? '1.2' : '2004', pass });
}

/** The element's own files, which pages and packages of lessons have. @param folder - of the program */
export async function readPlayer(folder: string): Promise<LessonFile[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const paths = entries.filter((one) => one.isFile()).map((one) => join(one.parentPath, one.name));
  return Promise.all(
    paths.map(async (path) => ({
      path: relative(folder, path).replaceAll('\\', '/'),
      bytes: new Uint8Array(await readFile(path)),
    })),
  );
}

/** A fixed time, so that the same files always give the same bytes. ZIP knows no time zones and no earlier year. */
const zipTime = new Date(1980, 0, 2);

/** The same files always give the same bytes. */
export function zipFiles(files: readonly LessonFile[]): Uint8Array {
  const entries: Zippable = {};
  for (const { path, bytes } of files) {
    const isPacked = /\.(?:gz|png|jpe?g|webp|zip|mgz|h5|ozx)$/i.test(path);
    entries[path] = [bytes, { level: isPacked ? 0 : 6, mtime: zipTime }];
  }
  return zipSync(entries);
}
