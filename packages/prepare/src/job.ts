import type { Source } from '../../../src/prepare/find-sources.ts';
import type { PrepareOptions, VolumeReport } from '../../../src/prepare/prepare-source.ts';

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

/** How sites are written. */
export interface SiteOptions extends PrepareOptions {
  readonly as: 'mosaic' | 'single-file';
  /** Whether pages have the names of files as their titles. */
  readonly keepNames: boolean;
}

export interface Job {
  readonly place: Place;
  readonly source: Source;
  readonly site: string;
  /** Secret, so that nobody can find out of an id whether it belongs to a file that he has. */
  readonly salt: string;
  readonly options: SiteOptions;
}

/** One volume of a site: the line that the program prints. */
export interface DoneLine extends VolumeReport {
  readonly status: 'done';
  readonly id: string;
  /** Relative to the site. */
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
}
