/** A file as the folder lists it. */
export interface SeenFile {
  /** Relative to the folder, with `/`. */
  readonly path: string;
  /** Size and time of change. */
  readonly stamp: string;
  /** Time of change, milliseconds since 1970. */
  readonly changed: number;
}

/** Programs that fetch or copy a file call it so until it is whole. */
const unfinishedName = /(\.(part|partial|filepart|tmp|temp|crdownload|download|inprogress|swp)|~)$/i;

/**
 * Says which files of a folder are whole: those that have not changed for some time. It goes by what it has seen itself, as the clock of
 * a file server may differ from that of this machine.
 */
export class SettledFiles {
  readonly #seen = new Map<string, { readonly stamp: string; readonly since: number }>();

  /** @param quiet - milliseconds without a change */
  constructor(private readonly quiet: number) {}

  /**
   * @param files - all of the folder
   * @param now - milliseconds of a clock that never goes back
   * @param isKnown - whether the file was taken with this stamp before: it is settled at once
   */
  settledOf(files: readonly SeenFile[], now: number, isKnown: (file: SeenFile) => boolean): SeenFile[] {
    const gone = new Set(this.#seen.keys());
    const settled = files.filter((file) => {
      const { path, stamp } = file;
      gone.delete(path);
      if (unfinishedName.test(path)) return false;
      const seen = this.#seen.get(path);
      if (seen?.stamp === stamp) return now - seen.since >= this.quiet;
      // What was taken before counts as seen for ever.
      const since = !seen && isKnown(file) ? -Infinity : now;
      this.#seen.set(path, { stamp, since });
      return now - since >= this.quiet;
    });
    for (const path of gone) this.#seen.delete(path);
    return settled;
  }
}

/** The files that changed last, the newest first; of one time that with the greater name, as names of radar files have the time. */
export function newestOf(files: readonly SeenFile[], count: number): SeenFile[] {
  const sorted = [...files];
  sorted.sort((a, b) => b.changed - a.changed || (a.path < b.path ? 1 : -1));
  return sorted.slice(0, count);
}
