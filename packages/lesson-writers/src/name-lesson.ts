// What packages of all kinds of courses have.
import type { LessonFile } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { encode } from './write-page.ts';

/** An id that the same files always have: their FNV-1a hash of 32 bits, and the number of their bytes. */
export function nameLesson(files: readonly LessonFile[]): string {
  let [hash, count] = [0x811c9dc5, 0];
  for (const { path, bytes } of files)
    for (const part of [encode(path), bytes]) {
      for (const byte of part) hash = Math.imul(hash ^ byte, 0x01000193);
      count += part.length;
    }
  return `lesson-${(hash >>> 0).toString(16).padStart(8, '0')}-${count}`;
}

/** @throws {LessonError} where it is no number of percent */
export function checkPass(pass: number | null): void {
  if (pass !== null && !(pass >= 1 && pass <= 100))
    throw new LessonError([{ message: `got ${pass} to pass; expected a number from 1 to 100`, line: null }]);
}
