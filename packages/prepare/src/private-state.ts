import { randomBytes } from 'node:crypto';
import { appendFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { FoundFile } from '../../../src/prepare/find-sources.ts';
import { Misuse } from './misuse.ts';
import type { JobResult } from './job.ts';
import { writeWhole } from './write-folder.ts';

/** What was found of a file of the folder, or of all files in an archive, the last time. */
export interface KnownFile {
  /** Size and time of change. */
  readonly stamp: string;
  readonly found: readonly FoundFile[];
}

/** What was made of a source. */
export interface KnownSource extends JobResult {
  /** Sizes and times of change of all files that were read. */
  readonly stamp: string;
  /** The version of the program and its options. */
  readonly made: string;
  /** Of a folder that is watched: its scans are no longer in the site. */
  readonly removed?: true;
}

const watchFile = 'watch.json';

/**
 * What the program remembers from run to run, in a folder next to the site: it has the names of files, and must not be on a server. Each
 * source that is finished is a line, so that a run that is ended at any moment loses at most the source it was at.
 */
export class PrivateState {
  readonly files = new Map<string, KnownFile>();
  readonly sources = new Map<string, KnownSource>();
  readonly salt: string;
  readonly #journal: string;

  /** @throws {Misuse} where another run writes there */
  constructor(readonly folder: string) {
    mkdirSync(folder, { recursive: true });
    this.#lock();
    this.#journal = join(folder, 'journal.jsonl');
    const saltFile = join(folder, 'salt');
    if (!existsSync(saltFile)) writeFileSync(saltFile, randomBytes(32).toString('hex'), { mode: 0o600 });
    this.salt = readFileSync(saltFile, 'utf8');
    const lines = existsSync(this.#journal) ? readFileSync(this.#journal, 'utf8').split('\n') : [''];
    for (const line of lines) this.#take(line);
    // A run that was ended may have left a part of a line: the next one must not join it.
    if (lines.at(-1)) appendFileSync(this.#journal, '\n');
  }

  keepFile(path: string, known: KnownFile): void {
    this.files.set(path, known);
    this.#append({ file: path, known });
  }

  keepSource(key: string, known: KnownSource): void {
    this.sources.set(key, known);
    this.#append({ source: key, known });
  }

  /** Forgets what no longer exists. @param files - paths @param sources - keys */
  async compact(files: ReadonlySet<string>, sources: ReadonlySet<string>): Promise<void> {
    for (const file of this.files.keys()) if (!files.has(file)) this.files.delete(file);
    for (const source of this.sources.keys()) if (!sources.has(source)) this.sources.delete(source);
    const lines = [
      ...[...this.files].map(([file, known]) => ({ file, known })),
      ...[...this.sources].map(([source, known]) => ({ source, known })),
    ];
    await writeWhole(this.folder, 'journal.jsonl', lines.map((line) => `${JSON.stringify(line)}\n`).join(''));
  }

  /** Lets the next run begin. */
  unlock(): void {
    rmSync(join(this.folder, 'lock'), { force: true });
  }

  /** The pages of newest scans, where the site is that of a run with `--watch`: what the scans of each have in common; else null. */
  get watched(): readonly string[] | null {
    const path = join(this.folder, watchFile);
    return existsSync(path) ? (JSON.parse(readFileSync(path, 'utf8')) as string[]) : null;
  }

  async keepWatched(pages: readonly string[]): Promise<void> {
    await writeWhole(this.folder, watchFile, JSON.stringify(pages));
  }

  #append(line: object): void {
    appendFileSync(this.#journal, `${JSON.stringify(line)}\n`);
  }

  #take(line: string): void {
    try {
      const { file, source, known } = JSON.parse(line) as { file?: string; source?: string; known: never };
      if (file !== undefined) this.files.set(file, known);
      if (source !== undefined) this.sources.set(source, known);
    } catch {
      // The end of a run that was stopped.
    }
  }

  #lock(): void {
    const lock = join(this.folder, 'lock');
    const other = existsSync(lock) ? Number(readFileSync(lock, 'utf8')) : 0;
    if (other > 0 && other !== process.pid && isAlive(other))
      throw new Misuse(`another run (process ${other}) writes this site; wait for its end, or remove ${lock}`);
    writeFileSync(lock, String(process.pid));
  }
}

function isAlive(id: number): boolean {
  try {
    return process.kill(id, 0);
  } catch {
    return false;
  }
}
