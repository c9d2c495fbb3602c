export { LessonError } from './lesson.ts';
export type { Lesson, LessonFile, LessonProblem, Player } from './lesson.ts';
export { listManifestFiles } from './manifest-files.ts';
export { readLesson } from './read-lesson.ts';
export type { LessonContent } from './read-lesson.ts';
export { writePageFiles } from './write-page.ts';
export { writeScormFiles } from './write-scorm.ts';
export type { ScormOptions } from './write-scorm.ts';
export type { ScormVersion } from './scorm-manifest.ts';
