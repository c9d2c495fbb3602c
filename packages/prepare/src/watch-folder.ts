import { mkdirSync, readdirSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { isLitter } from '../../../src/sources/find-volume.ts';
import { ChildPool } from './child-pool.ts';
import { findJobs, stampOf } from './find-jobs.ts';
import type { FolderSource } from './find-jobs.ts';
import type { FolderRequest, Output } from './folder-request.ts';
import { FolderStore } from './folder-store.ts';
import { FolderWork, isTried, madeBy } from './folder-work.ts';
import type { DoneLine } from './job.ts';
import { Misuse } from './misuse.ts';
import { PrivateState } from './private-state.ts';
import { newestScans, readTimedScan, removeOthers, rollingFolder, scanFolder, writeRolling } from './rolling-pages.ts';
import type { TimedScan } from './rolling-pages.ts';
import { newestOf, SettledFiles } from './settled-files.ts';
import type { SeenFile } from './settled-files.ts';
import { copyScript, writeIndexPage } from './site-files.ts';
import { removeUnfinished, writeWhole } from './write-folder.ts';

/** How a folder is watched. */
export interface WatchOptions {
  /** Scans of a page of newest scans. */
  readonly newest: number;
  /** Seconds between two looks at the folder. */
  readonly every: number;
  /** Seconds for which a file has to stay as it is before it is read. */
  readonly settle: number;
}

/**
 * Keeps pages of the newest scans of a folder into which a radar writes, until it is ended.
 * @returns a function that ends it, at any moment
 */
export async function watchFolder(request: FolderRequest, options: WatchOptions, output: Output): Promise<() => void> {
  const state = new PrivateState(`${resolve(request.site)}.private`);
  const site = resolve(request.site);
  mkdirSync(site, { recursive: true });
  // Old scans are removed: those of other runs must not be.
  if (!state.watched && readdirSync(site).some((name) => scanFolder.test(name))) {
    state.unlock();
    throw new Misuse(
      'got a site with scans of a run without --watch; expected another --out, as --watch removes old scans',
    );
  }
  await state.keepWatched(state.watched ?? []);
  await removeUnfinished(site);
  const pool = new ChildPool(request.child, request.timeout);
  const watch = new FolderWatch(request, options, { site, state, pool, output });
  await watch.begin();
  void (async () => {
    for (;;) {
      await watch.look();
      await new Promise((done) => setTimeout(done, 1000 * options.every));
    }
  })();
  return () => {
    pool.close();
    state.unlock();
  };
}

/** A folder that is being watched. */
class FolderWatch {
  readonly #folder: string;
  readonly #made: string;
  readonly #settled: SettledFiles;
  /** Archives that can't be read, and their stamps. */
  readonly #bad = new Map<string, string>();
  #scriptIsThere = false;
  #seriesWereFound = false;
  #wasRolled = false;
  #problem = '';

  constructor(
    private readonly request: FolderRequest,
    private readonly options: WatchOptions,
    private readonly at: {
      readonly site: string;
      readonly state: PrivateState;
      readonly pool: ChildPool;
      readonly output: Output;
    },
  ) {
    this.#folder = resolve(request.folder);
    this.#made = madeBy(request);
    this.#settled = new SettledFiles(1000 * options.settle);
  }

  /** Forgets scans whose folders somebody has removed. */
  async begin(): Promise<void> {
    const { state, site } = this.at;
    const there = new Set(readdirSync(site));
    const kept = [...state.sources].filter(
      ([, { lines, removed }]) => removed || lines.every((line) => line.status === 'failed' || there.has(line.id)),
    );
    await state.compact(new Set(state.files.keys()), new Set(kept.map(([key]) => key)));
  }

  /** One look at the folder. What goes wrong is said once, and tried again at the next look. */
  async look(): Promise<void> {
    const { output } = this.at;
    try {
      await this.#takeNew();
      this.#problem = '';
    } catch (error) {
      const { code = 'an error' } = error as NodeJS.ErrnoException;
      const problem = `the folder or the site can not be used now (${code}); it is tried again every ${this.options.every} seconds`;
      if (problem !== this.#problem) output.say(problem);
      this.#problem = problem;
    }
  }

  async #takeNew(): Promise<void> {
    const { site, state, pool, output } = this.at;
    const files = await this.#list();
    const isKnown = ({ path, stamp }: SeenFile): boolean => state.files.get(join(this.#folder, path))?.stamp === stamp;
    const settled = this.#settled.settledOf(files, performance.now(), isKnown);
    const pages = Math.max(1, state.watched!.length);
    const only = newestOf(settled, this.#stay * pages).map(({ path }) => path);
    const found = await findJobs(this.#folder, { only }, state, () => undefined);
    const work = new FolderWork(this.request, { folder: this.#folder, site, state, pool, output });
    for (const { key, ...line } of found.bad) {
      const stamp = stampOf(join(this.#folder, key));
      if (this.#bad.get(key) !== stamp) work.report(key, [line], false);
      this.#bad.set(key, stamp);
    }
    if (!this.#seriesWereFound && found.sources.some(({ source }) => source.files))
      output.say('DICOM series are left out: it is not known when one is whole. A run without --watch takes them');
    this.#seriesWereFound ||= found.sources.some(({ source }) => source.files);
    const fresh = found.sources.filter((one) => this.#isFresh(one));
    for (const phase of [0, 1, 2]) await work.runAll(fresh.filter(({ source }) => source.phase === phase));
    if (!this.#scriptIsThere) await copyScript(site, this.request.player);
    this.#scriptIsThere = true;
    // At the start too: another run may have had other options.
    if (fresh.length === 0 && (this.#wasRolled || state.sources.size === 0)) return;
    await this.#roll(new Set(files.map(({ path }) => join(this.#folder, path))));
    this.#wasRolled = true;
    if (fresh.length === 0) return;
    const { done, failed } = work.counts;
    output.say(`${new Date().toISOString()} ${done} made, ${failed} failed`);
  }

  /** So many of the newest scans keep their folders: an open page may have a list of before. */
  get #stay(): number {
    return 2 * this.options.newest;
  }

  /** All files, and when they changed. */
  async #list(): Promise<SeenFile[]> {
    const { site, state } = this.at;
    const store = new FolderStore(this.#folder, { without: [site, state.folder] });
    const files: SeenFile[] = [];
    for (const url of await store.list()) {
      if (isLitter(url)) continue;
      const path = store.pathOf(url);
      const found = statSync(path, { throwIfNoEntry: false });
      if (found)
        files.push({ path: path.slice(this.#folder.length + 1), stamp: stampOf(path), changed: found.mtimeMs });
    }
    return files;
  }

  /** Of a series of DICOM nobody knows whether all its files are there. */
  #isFresh(one: FolderSource): boolean {
    return !one.source.files && !isTried(one, this.at.state.sources.get(one.key), this.#made);
  }

  /** Writes the pages of what is newest now, and removes what is old. @param files - absolute paths of all in the folder */
  async #roll(files: ReadonlySet<string>): Promise<void> {
    const { site, state } = this.at;
    const lines = [...state.sources.values()].flatMap((known) =>
      known.lines.filter((line): line is DoneLine => line.status === 'done'),
    );
    const scans = new Map(lines.map((line) => [line.id, readTimedScan(site, line)]));
    const timed = [...scans.values()].filter((one) => one !== null);
    const staying = newestScans(timed, this.#stay);
    const kinds = [...new Set([...state.watched!, ...staying.keys()])];
    await state.keepWatched(kinds);
    const shown: DoneLine[] = [];
    for (const [kind, all] of staying) {
      const folder = rollingFolder(kinds.indexOf(kind));
      const newest = all.slice(-this.options.newest);
      await writeRolling(site, folder, newest, this.options.every);
      shown.push(...newest.map(({ line }) => ({ ...line, scans: `${folder}/index.html` })));
    }
    const others = lines.filter(({ id, page }) => scans.get(id) === null && this.#isThere(page));
    await writeIndexPage(site, [...shown, ...others]);
    const kept = [...[...staying.values()].flat().map(({ line }: TimedScan) => line), ...others];
    await this.#remember(files, new Set(kept.map(({ id }) => id)));
    await removeOthers(site, kept);
  }

  /** A key is the path of a file, or of one in an archive. */
  #hasFile(files: ReadonlySet<string>, key: string): boolean {
    const parts = key.split('/');
    return parts.some((_, i) => files.has(join(this.#folder, ...parts.slice(0, i + 1))));
  }

  #isThere(page: string): boolean {
    return statSync(join(this.at.site, page), { throwIfNoEntry: false }) !== undefined;
  }

  /** Sources whose files are there are remembered, so that they are not made again; others as long as their scans stay. */
  async #remember(files: ReadonlySet<string>, kept: ReadonlySet<string>): Promise<void> {
    const { state } = this.at;
    const keys = new Set<string>();
    const rows: string[] = [];
    for (const [key, known] of state.sources) {
      const { lines } = known;
      const stays = lines.some((line) => line.status === 'done' && kept.has(line.id));
      if (!stays && !this.#hasFile(files, key)) continue;
      keys.add(key);
      if (!stays && lines.some(({ status }) => status === 'done')) state.sources.set(key, { ...known, removed: true });
      for (const line of lines)
        rows.push([keys.size, line.status, line.status === 'done' ? line.id : line.code, key].join('\t'));
    }
    await state.compact(files, keys);
    await writeWhole(state.folder, 'scans.tsv', rows.map((row) => `${row}\n`).join(''));
  }
}
