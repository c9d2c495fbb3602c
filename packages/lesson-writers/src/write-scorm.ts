import course from './course.js?raw';
import type { Lesson, LessonFile, Player } from './lesson.ts';
import { checkPass, nameLesson } from './name-lesson.ts';
import { writeManifest } from './scorm-manifest.ts';
import type { ScormVersion } from './scorm-manifest.ts';
import { encode, sortFiles, writePageFiles } from './write-page.ts';

export interface ScormOptions {
  readonly version: ScormVersion;
  /** Percent of the questions that have to be right to pass, 1 to 100; null: a learner who has seen and answered all has completed it. */
  readonly pass: number | null;
}

/**
 * The files of a lesson as a package for a course. It becomes a ZIP archive with `imsmanifest.xml` at its top.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writeScormFiles(lesson: Lesson, player: Player, { version, pass }: ScormOptions): LessonFile[] {
  checkPass(pass);
  const passed = pass === null ? '' : ` data-pass="${pass}"`;
  const files = writePageFiles(lesson, player, {
    linksLeave: true,
    // The course keeps the answers of each learner; the browser would show them to the next one.
    leftOut: ['remember'],
    end: `<script src="course.js" data-scorm="${version}"${passed}></script>\n`,
  });
  files.push({ path: 'course.js', bytes: encode(course) });
  const paths = sortFiles(files).map(({ path }) => path);
  return sortFiles([
    ...files,
    { path: 'imsmanifest.xml', bytes: encode(writeManifest(lesson, paths, { version, pass, id: nameLesson(files) })) },
  ]);
}
