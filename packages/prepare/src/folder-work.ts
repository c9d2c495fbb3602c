import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { RadarLook } from '../../../src/prepare/look-at-radar.ts';
import type { ChildPool } from './child-pool.ts';
import { stampAll } from './find-jobs.ts';
import type { FolderSource } from './find-jobs.ts';
import type { FolderRequest, Output } from './folder-request.ts';
import { FolderStore } from './folder-store.ts';
import type { DoneLine, Line } from './job.ts';
import { openPlace } from './open-place.ts';
import type { KnownSource, PrivateState } from './private-state.ts';
import { hashFiles, notWritable } from './run-job.ts';

/** The sources of a folder at work. */
export class FolderWork {
  readonly counts = { done: 0, unchanged: 0, failed: 0 };
  readonly keys = new Set<string>();
  /** Packed files that hold no volume. */
  others = 0;
  readonly #made: string;
  readonly #index = new Map<string, DoneLine>();
  /** Files that belong to a source. */
  readonly #read = new Set<string>();
  readonly #table: string[] = [];
  #count = 0;

  constructor(
    private readonly request: FolderRequest,
    private readonly at: {
      readonly folder: string;
      readonly site: string;
      readonly state: PrivateState;
      readonly pool: ChildPool;
      readonly output: Output;
    },
  ) {
    this.#made = madeBy(request);
  }

  /** Does all sources, some at once. */
  async runAll(all: readonly FolderSource[]): Promise<void> {
    const left = all.filter(
      (one) => !this.#read.has(namesOf({ ...one, source: { ...one.source, files: undefined } }, [])[0]),
    );
    await this.#each(left, (one) => this.#run(one));
  }

  async #each(left: readonly FolderSource[], work: (one: FolderSource) => Promise<void>): Promise<void> {
    let next = 0;
    const worker = async (): Promise<void> => {
      while (next < left.length) await work(left[next++]);
    };
    const jobs = this.request.jobs ?? Math.max(1, availableParallelism() - 1);
    await Promise.all(Array.from({ length: jobs }, worker));
  }

  /** What of radar scans says which of them make one video, by the keys of their sources. What was known before is not looked up again. */
  async lookAtRadars(all: readonly FolderSource[]): Promise<Map<string, RadarLook>> {
    const looks = new Map<string, RadarLook>();
    const { state, pool, site } = this.at;
    const left = all.filter(({ source, place }) => source.phase > 0 && !source.files && place.archive === undefined);
    await this.#each(left, async (one) => {
      const key = `look ${one.key}`;
      this.keys.add(key);
      const stamp = stampAll(pathsOf(one, []));
      let known = state.sources.get(key);
      if (known?.stamp !== stamp || known.made !== this.#made) {
        const { place, source } = one;
        const { salt } = state;
        const { options, player } = this.request;
        const job = { place, source, site, salt, options, player: fileURLToPath(player), looks: true } as const;
        known = { ...(await pool.run(job)), lines: [], stamp, made: this.#made };
        state.keepSource(key, known);
      }
      if (known.look) looks.set(one.key, known.look);
      this.at.output.progress(`looked at ${looks.size} radar scans`);
    });
    return looks;
  }

  report(key: string, lines: readonly Line[], isKnown: boolean): void {
    const number = ++this.#count;
    for (const line of lines) {
      const status = line.status === 'done' && isKnown ? 'unchanged' : line.status;
      this.counts[status]++;
      if (line.status === 'done') this.#index.set(line.id, line);
      this.at.output.line({ source: number, ...line, status });
      this.#table.push([number, status, line.status === 'done' ? line.id : line.code, key].join('\t'));
    }
    this.at.output.progress(`${this.#count} read, ${this.counts.failed} failed`);
  }

  /** All volumes that are in the site, as pages list them. */
  get done(): DoneLine[] {
    return [...this.#index.values()];
  }

  /** A row for each volume, with the name of its file. */
  get table(): readonly string[] {
    return this.#table;
  }

  async #run(one: FolderSource): Promise<void> {
    const { key, place, source } = one;
    const { state, pool, site } = this.at;
    this.keys.add(key);
    const known = state.sources.get(key);
    if (known && (await this.#isCurrent(one, known))) {
      for (const name of namesOf(one, known.read)) this.#read.add(name);
      return this.report(key, known.lines, true);
    }
    const before = stampAll(pathsOf(one, []));
    const { options, player } = this.request;
    const job = { place, source, site, salt: state.salt, options, player: fileURLToPath(player) };
    const result = await pool.run(job);
    const paths = pathsOf(one, result.read);
    for (const name of namesOf(one, result.read)) this.#read.add(name);
    // A full disk is not the fault of the file.
    const isWritten = result.lines.every((line) => line.status === 'done' || line.code !== notWritable);
    // Nor is it known what was read of a file that changed meanwhile.
    const stamp = stampAll(pathsOf(one, [])) === before ? stampAll(paths) : '';
    if (isWritten) state.keepSource(key, { ...result, stamp, made: this.#made });
    // Of a packed file only its reader knows whether it holds a volume.
    if (source.phase === 2 && result.lines.some((line) => line.status === 'failed' && line.code === 'format/unknown'))
      this.others++;
    else this.report(key, result.lines, false);
  }

  /** Whether all that was made of a source is there, and neither its files nor the options have changed. */
  async #isCurrent(one: FolderSource, known: KnownSource): Promise<boolean> {
    const { site, state } = this.at;
    if (known.made !== this.#made) return false;
    const isThere = known.lines.every(
      (line) =>
        line.status === 'done' && [line.page, line.scans ?? line.page].every((page) => existsSync(join(site, page))),
    );
    if (!isThere) return false;
    const paths = pathsOf(one, known.read);
    const stamp = stampAll(paths);
    if (stamp === known.stamp) return true;
    // Files that were copied or touched have another time, and the same bytes.
    const content = await hashFiles(await openPlace(one.place), urlsOf(one, known.read)).catch(() => '');
    if (content !== known.content) return false;
    state.keepSource(one.key, { ...known, stamp });
    return true;
  }
}

/** What a source was made with: the version of the program and its options. */
export function madeBy({ version, options }: FolderRequest): string {
  // More or less memory decides what can be made, and changes nothing that is.
  return JSON.stringify([version, { ...options, deviceBytes: undefined }]);
}

/** Whether the files of a source are those of the last time, whatever was made of them. */
export function isTried(one: FolderSource, known: KnownSource | undefined, made: string): boolean {
  return known?.made === made && known.stamp === stampAll(pathsOf(one, known.read));
}

const urlsOf = ({ source }: FolderSource, read: readonly string[]): string[] => [
  ...new Set([source.first, ...(source.files ?? []), ...read]),
];

/** The paths of a source's files; of one in an archive that of the archive. */
function pathsOf(one: FolderSource, read: readonly string[]): string[] {
  const { folder, archive } = one.place;
  if (archive !== undefined) return [join(folder, archive)];
  const store = new FolderStore(folder);
  return urlsOf(one, read).map((url) => store.pathOf(url));
}

/** What files of a source are called among all files of the folder and its archives. */
function namesOf(one: FolderSource, read: readonly string[]): string[] {
  const { folder, archive } = one.place;
  return archive === undefined ? pathsOf(one, read) : urlsOf(one, read).map((url) => `${join(folder, archive)}/${url}`);
}
