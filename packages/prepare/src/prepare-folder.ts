import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { ChildPool } from './child-pool.ts';
import { findJobs, stampAll } from './find-jobs.ts';
import type { FolderSource } from './find-jobs.ts';
import { FolderStore } from './folder-store.ts';
import type { DoneLine, Line, SiteOptions } from './job.ts';
import { openPlace } from './open-place.ts';
import { PrivateState } from './private-state.ts';
import type { KnownSource } from './private-state.ts';
import { hashFiles } from './run-job.ts';
import { partsName, scriptName, writeIndex, x3domName } from './site-pages.ts';
import { copyFolder, removeUnfinished, writeWhole } from './write-folder.ts';

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

/**
 * Makes a site of all volumes in a folder. A volume that was made before, and whose files have not changed, is left as it is.
 * @returns the exit status: 0, or 2 where some volumes could not be made
 */
export async function prepareFolder(request: FolderRequest, output: Output): Promise<number> {
  const folder = resolve(request.folder);
  const site = resolve(request.site);
  const state = new PrivateState(`${site}.private`);
  mkdirSync(site, { recursive: true });
  await removeUnfinished(site);
  const found = await findJobs(folder, [site, state.folder], state, (done, all) =>
    output.progress(`looked at ${done} of ${all} files`),
  );
  const pool = new ChildPool(request.child, request.timeout);
  const work = new FolderWork(request, { folder, site, state, pool, output });
  try {
    for (const { key, ...line } of found.bad) work.report(key, [line], false);
    for (const phase of [0, 1, 2]) await work.runAll(found.sources.filter(({ source }) => source.phase === phase));
  } finally {
    pool.close();
  }
  await work.finish();
  await state.close(found.files, work.keys);
  output.progress('');
  const others = found.others + work.others;
  const left = [
    found.images > 0 ? `${found.images} images without a manifest, of which nobody knows what they hold` : '',
    others > 0 ? `${others} files that hold no volume` : '',
  ].filter(Boolean);
  output.say(
    `${work.counts.done} made, ${work.counts.unchanged} unchanged, ${work.counts.failed} failed${left.length > 0 ? `; left out: ${left.join(', ')}` : ''}. ` +
      `${site} is for the web server. ${state.folder} is not: it knows the names of files, also of those that failed (scans.tsv).`,
  );
  return work.counts.failed > 0 ? 2 : 0;
}

/** The sources of a folder at work. */
class FolderWork {
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
    this.#made = JSON.stringify([request.version, request.options]);
  }

  /** Does all sources, some at once. */
  async runAll(all: readonly FolderSource[]): Promise<void> {
    const left = all.filter(
      (one) => !this.#read.has(namesOf({ ...one, source: { ...one.source, files: undefined } }, [])[0]),
    );
    let next = 0;
    const worker = async (): Promise<void> => {
      while (next < left.length) await this.#run(left[next++]);
    };
    const jobs = this.request.jobs ?? Math.max(1, availableParallelism() - 1);
    await Promise.all(Array.from({ length: jobs }, worker));
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

  /** Writes the pages of all volumes together. */
  async finish(): Promise<void> {
    const { site, state } = this.at;
    const lines = [...this.#index.values()];
    lines.sort((a, b) => a.title.localeCompare(b.title, 'en', { numeric: true }));
    const page = writeIndex(
      lines.map((line) => ({ ...line, hasPoster: existsSync(join(site, line.id, 'poster.png')) })),
    );
    const index = join(site, 'index.html');
    if (!existsSync(index) || readFileSync(index, 'utf8') !== page) await writeWhole(site, 'index.html', page);
    await writeWhole(state.folder, 'scans.tsv', this.#table.map((row) => `${row}\n`).join(''));
    await this.#copyScript();
  }

  /** The element's script and its parts, where the package is installed, and again after it became another version. */
  async #copyScript(): Promise<void> {
    const { site, output } = this.at;
    const script = findScript();
    const target = join(site, scriptName);
    if (!script) {
      if (!existsSync(target))
        output.say(
          `the pages need ${scriptName}, ${x3domName} and the folder ${partsName}: copy them from the folder dist of the package volume-view into ${site}`,
        );
      return;
    }
    const bytes = readFileSync(script);
    if (existsSync(target) && readFileSync(target).equals(bytes)) return;
    await copyFolder(join(dirname(script), partsName), site, partsName);
    await writeWhole(site, x3domName, readFileSync(join(dirname(script), x3domName)));
    // Last, because where it is, its parts are there too.
    await writeWhole(site, scriptName, bytes);
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
    const result = await pool.run({ place, source, site, salt: state.salt, options: this.request.options });
    const paths = pathsOf(one, result.read);
    for (const name of namesOf(one, result.read)) this.#read.add(name);
    state.keepSource(key, { ...result, stamp: stampAll(paths), made: this.#made });
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

/** The script of the element, where the package is installed. */
function findScript(): string | null {
  for (const from of [import.meta.url, join(process.cwd(), 'package.json')]) {
    try {
      return createRequire(from).resolve(`volume-view/${scriptName}`);
    } catch {
      // Not there.
    }
  }
  return null;
}
