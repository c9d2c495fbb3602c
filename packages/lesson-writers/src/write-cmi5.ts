import cmi5 from './cmi5.js?raw';
import course from './course.js?raw';
import type { Lesson, LessonFile, Player } from './lesson.ts';
import { checkPass, nameLesson } from './name-lesson.ts';
import { escapeMarkup } from './write-html.ts';
import { encode, playerFolder, playerScript, sortFiles, writeHead, writePageFiles } from './write-page.ts';

export interface Cmi5Options {
  /** Percent of the questions that have to be right to pass, 1 to 100; null: a learner who has seen and answered all has completed it. */
  readonly pass: number | null;
}

/**
 * The files of a lesson as a package of cmi5. It becomes a ZIP archive with `cmi5.xml` at its top.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writeCmi5Files(lesson: Lesson, player: Player, { pass }: Cmi5Options): LessonFile[] {
  checkPass(pass);
  const passed = pass === null ? '' : ` data-pass="${pass}"`;
  const files = writePageFiles(lesson, player, {
    linksLeave: true,
    // The course keeps the answers of each learner; the browser would show them to the next one.
    leftOut: ['remember'],
    // What a learner does goes to the server that the course names. The element comes when the course has said where the learner was.
    head: writeHead({ connect: "'self' data: blob: https: http:", script: false }),
    end: `<script src="cmi5.js" data-player="${playerFolder}${playerScript}"${passed}></script>\n`,
  });
  files.push({ path: 'course.js', bytes: encode(course) }, { path: 'cmi5.js', bytes: encode(cmi5) });
  return sortFiles([...files, { path: 'cmi5.xml', bytes: encode(writeStructure(lesson, pass, nameLesson(files))) }]);
}

/** `cmi5.xml`: one course of one unit. Source: cmi5 1.0, 13 and 14. @param id - of the lesson */
function writeStructure({ title, credits, language }: Lesson, pass: number | null, id: string): string {
  const text = (words: string): string =>
    `<langstring lang="${escapeMarkup(language)}">${escapeMarkup(words)}</langstring>`;
  // Ids are addresses that nobody else has. This one is of no server.
  const course = `https://lesson.invalid/${id}`;
  const rule = pass === null ? 'moveOn="Completed"' : `moveOn="CompletedAndPassed" masteryScore="${pass / 100}"`;
  return `<?xml version="1.0" encoding="UTF-8"?>
<courseStructure xmlns="https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd">
  <course id="${course}">
    <title>${text(title)}</title>
    <description>${text(credits)}</description>
  </course>
  <au id="${course}/page" launchMethod="AnyWindow" ${rule}>
    <title>${text(title)}</title>
    <description>${text(credits)}</description>
    <url>index.html</url>
  </au>
</courseStructure>
`;
}
