import type { SiteOptions } from './job.ts';

/** What the command is asked to do. */
export interface FolderRequest {
  readonly folder: string;
  readonly site: string;
  readonly options: SiteOptions;
  /** Child processes at once. */
  readonly jobs?: number;
  /** Maximum seconds for one source. */
  readonly timeout: number;
  /** The program of a child process. */
  readonly child: URL;
  /** The folder with the element's own files. */
  readonly player: URL;
  /** Of the program: another version makes all again. */
  readonly version: string;
}

/** Where the program writes. */
export interface Output {
  /** One JSON object, for programs. */
  line(object: object): void;
  /** Words for people. */
  say(text: string): void;
  /** A short text that replaces the one before; nothing where nobody looks. */
  progress(text: string): void;
}
