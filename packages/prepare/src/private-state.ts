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
}

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
    if (existsSync(this.#journal)) for (const line of readFileSync(this.#journal, 'utf8').split('\n')) this.#take(line);
  }

  keepFile(path: string, known: KnownFile): void {
    this.files.set(path, known);
    this.#append({ file: path, known });
  }

  keepSource(key: string, known: KnownSource): void {
    this.sources.set(key, known);
    this.#append({ source: key, known });
  }

  /** Writes again what still exists, and lets the next run begin. @param files - paths @param sources - keys */
  async close(files: ReadonlySet<string>, sources: ReadonlySet<string>): Promise<void> {
    const lines = [
      ...[...this.files].filter(([file]) => files.has(file)).map(([file, known]) => ({ file, known })),
      ...[...this.sources].filter(([source]) => sources.has(source)).map(([source, known]) => ({ source, known })),
    ];
    await writeWhole(this.folder, 'journal.jsonl', lines.map((line) => `${JSON.stringify(line)}\n`).join(''));
    rmSync(join(this.folder, 'lock'), { force: true });
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
