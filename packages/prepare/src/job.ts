import type { Source } from '../../../src/prepare/find-sources.ts';
import type { RadarLook } from '../../../src/prepare/look-at-radar.ts';
import type { PrepareOptions, VolumeReport } from '../../../src/prepare/prepare-source.ts';
import type { Lesson } from '../../lesson-writers/src/index.ts';
import type { LessonForm } from './lesson-forms.ts';
import type { VideoOptions } from './write-video.ts';

// What the program and its child processes say to each other.

/** Where the files of a source are. */
export interface Place {
  /** Absolute path of the folder. */
  readonly folder: string;
  /** Paths in it of the files that belong to the source; all of the folder if undefined. */
  readonly only?: readonly string[];
  /** The folder has this ZIP archive, and the files are in it. */
  readonly archive?: string;
}

/** What becomes of a volume. */
export const siteForms = [
  ...(['mosaic', 'ome-zarr', 'video', 'single-file'] as const),
  ...(['embed', 'scorm', 'scorm-2004', 'cmi5', 'h5p'] as const),
] as const;

export type SiteForm = (typeof siteForms)[number];

/** Forms of lessons: a page for frames, and packages for courses. */
export type PackageForm = Extract<SiteForm, LessonForm> & Exclude<SiteForm, 'single-file'>;

/** What packages say of all their volumes. */
export interface PackageWords extends Pick<Lesson, 'language' | 'licence' | 'credits'> {
  /** Of the site on its server, for pages for frames. */
  readonly address?: string;
}

/** How sites are written. */
export interface SiteOptions extends PrepareOptions {
  readonly as: SiteForm;
  /** Whether pages have the names of files as their titles. */
  readonly keepNames: boolean;
  /** Of videos. */
  readonly video?: VideoOptions;
  /** Of packages. */
  readonly words?: PackageWords;
}

export interface Job {
  readonly place: Place;
  readonly source: Source;
  readonly site: string;
  /** Secret, so that nobody can find out of an id whether it belongs to a file that he has. */
  readonly salt: string;
  readonly options: SiteOptions;
  /** Path of the folder with the element's own files. */
  readonly player: string;
  /** Nothing is written: it is asked which video the file may belong to. */
  readonly looks?: true;
}

/** One volume of a site: the line that the program prints. */
export interface DoneLine extends VolumeReport {
  readonly status: 'done';
  readonly id: string;
  /** What it became: a volume of another form than was asked for can't have that one. */
  readonly form: SiteForm;
  /** Relative to the site. Of a package for a course the package. */
  readonly page: string;
  readonly title: string;
  /** The page of all scans of its series, where there are several: relative to the site. */
  readonly scans?: string;
}

export interface FailedLine {
  readonly status: 'failed';
  readonly code: string;
  readonly message: string;
}

export type Line = DoneLine | FailedLine;

/** The answer of a child to a job. */
export interface JobResult {
  readonly lines: readonly Line[];
  /** URLs of files that were read for it, besides its own. */
  readonly read: readonly string[];
  /** Of the bytes of all of them. */
  readonly content: string;
  /** Of a job that looks. */
  readonly look?: RadarLook | null;
}
