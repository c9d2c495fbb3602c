import { VolumeViewError } from '../core/errors.ts';
import type { ErrorCode } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { urlInStore } from './byte-store.ts';
import type { ByteStore, FileStat, ReadOptions } from './byte-store.ts';

/** Endings of names that say what is in a file, and nothing about who is in it. */
const known =
  /(\+orig|\+tlrc)?(\.(nii|gz|dcm|dicom|ima|nrrd|nhdr|mha|mhd|raw|zraw|hdr|img|head|brik|mgh|mgz|mrcs?|ccp4|map|vti|npy|mnc|json|png|jpe?g|webp|h5|hdf5?|nc4?|bin|dat|txt|csv|ctbl|label|zip|tiff?|bz2|zst|xz|z|rtf|pdf|doc|docx|html|xml))+$/i;

/**
 * The files of another store under names that say nothing: `folder-1/file-12.dcm`. People call files after patients, and messages
 * have the names of files. A header that names the file of its data still finds it, and so does one whose data has the same name with
 * another ending.
 */
export class PrivateStore implements ByteStore {
  /** The paths of the inner store by those of this one. */
  readonly #real = new Map<string, string>();
  /** Names without ending, and folders, by what they are called here, with the folder. */
  readonly #parts = new Map<string, string>();

  /** Set where the inner store has it. A file has a name, which whoever gets it must not say. */
  readonly sourceOf?: ByteStore['sourceOf'];

  private constructor(
    private readonly store: ByteStore,
    readonly base: string,
  ) {
    if (store.sourceOf) this.sourceOf = (url) => store.sourceOf!(urlInStore(base, this.#find(pathIn(url, base))));
  }

  /** @param base - of the URLs of both stores, ends with a slash @param isLeftOut - by its path, for what is no file of a volume */
  static async of(store: ByteStore, base: string, isLeftOut: (url: string) => boolean): Promise<PrivateStore> {
    const all = ((await store.list()) ?? []).filter((url) => !isLeftOut(url)).map((url) => pathIn(url, base));
    const { compare } = new Intl.Collator('en', { numeric: true });
    all.sort(compare);
    const hidden = new PrivateStore(store, base);
    const words = { file: 'file', folder: 'folder' };
    // A name that a file has already would be that of two files.
    while (all.some((path) => path.includes(`${words.file}-`) || path.includes(`${words.folder}-`)))
      Object.assign(words, { file: `${words.file}_`, folder: `${words.folder}_` });
    const given = new Map<string, string>();
    const counts = { file: 0, folder: 0 };
    const call = (inside: string, kind: keyof typeof words, part: string): string => {
      const key = `${inside}${kind}/${part}`;
      const called = given.get(key) ?? `${words[kind]}-${++counts[kind]}`;
      given.set(key, called);
      return called;
    };
    for (const path of all) {
      const parts = path.split('/');
      const name = parts.pop()!;
      let inside = '';
      for (const part of parts) {
        const called = call(inside, 'folder', part);
        hidden.#parts.set(`${inside}${called}`, part);
        inside += `${called}/`;
      }
      const stem = name.replace(known, '');
      const called = call(inside, 'file', stem);
      hidden.#parts.set(`${inside}${called}`, stem);
      hidden.#real.set(`${inside}${called}${name.slice(stem.length)}`, path);
    }
    return hidden;
  }

  /** What a file of the inner store is called here. @throws {VolumeViewError} `source/not-found` */
  hide(url: string): string {
    const path = pathIn(url, this.base);
    for (const [called, real] of this.#real) if (real === path) return urlInStore(this.base, called);
    throw new VolumeViewError(
      'source/not-found',
      `a file of the volume is not there any more; ${reasons['source/not-found']}`,
    );
  }

  async list(): Promise<readonly string[]> {
    return [...this.#real.keys()].map((path) => urlInStore(this.base, path));
  }

  async stat(url: string): Promise<FileStat> {
    return this.#about(url, (real) => this.store.stat(real));
  }

  async read(url: string, options: ReadOptions = {}): Promise<DecodeInput> {
    const input = await this.#about(url, (real) => this.store.read(real, options), options.signal);
    return { ...input, url };
  }

  async readTogether(
    urls: readonly string[],
    options: Pick<ReadOptions, 'range' | 'signal'>,
  ): Promise<readonly DecodeInput[] | null> {
    const real = urls.map((url) => urlInStore(this.base, this.#find(pathIn(url, this.base))));
    const read = await this.store.readTogether?.(real, options).catch(() => null);
    options.signal?.throwIfAborted();
    return read?.map((input, i) => ({ ...input, url: urls[i] })) ?? null;
  }

  /** Does something with a file; its errors have no name of it. */
  async #about<T>(url: string, act: (real: string) => Promise<T>, signal?: AbortSignal): Promise<T> {
    const path = pathIn(url, this.base);
    try {
      return await act(urlInStore(this.base, this.#find(path)));
    } catch (cause) {
      signal?.throwIfAborted();
      if (!(cause instanceof VolumeViewError)) throw cause;
      throw this.#real.has(path)
        ? new VolumeViewError(
            cause.code,
            `${this.#real.size > 1 ? `${path.split('/').at(-1)} (counted in the order of their names)` : 'the chosen file'} can not be read: ${reasonOf(cause)}`,
          )
        : new VolumeViewError(
            'source/not-found',
            `a file that belongs to the volume${endingOf(path)} is not among the chosen files; choose it together with the others`,
          );
    }
  }

  /** The inner path. A header names other files as they are called there. */
  #find(path: string): string {
    const real = this.#real.get(path);
    if (real !== undefined) return real;
    const parts = path.split('/');
    const name = parts.pop()!;
    let inside = '';
    const folders = parts.map((part) => {
      const called = this.#parts.get(inside + part) ?? part;
      inside += `${part}/`;
      return called;
    });
    const stem = name.replace(known, '');
    return this.#nearest([...folders, (this.#parts.get(inside + stem) ?? stem) + name.slice(stem.length)].join('/'));
  }

  /**
   * A header may name folders that were not chosen, or a name in another case: then it means the only file of that name, in
   * its folder or in one around it. In other folders, the file may belong to another header.
   */
  #nearest(path: string): string {
    const wanted = path.toLowerCase();
    const name = wanted.split('/').at(-1)!;
    const all = [...this.#real.values()];
    const named = all.filter((real) => real.toLowerCase().split('/').at(-1) === name);
    const [only] = named;
    const isAround = named.length === 1 && wanted.startsWith(only.toLowerCase().slice(0, -name.length));
    return isAround && !all.includes(path) ? only : path;
  }
}

/** The path of a file below a base, without the percent signs of URLs. */
function pathIn(url: string, base: string): string {
  return decodeURIComponent(url.slice(base.length));
}

function endingOf(path: string): string {
  const [ending] = known.exec(path) ?? [];
  return ending ? `, with the ending ${ending},` : '';
}

/** Why a file of a store is not read, without its name. */
export function reasonOf({ code }: VolumeViewError): string {
  return reasons[code] ?? 'it is damaged; fetch or pack the files again';
}

const reasons: Partial<Record<ErrorCode, string>> = {
  'source/not-found': 'it was moved, changed or removed since it was chosen, or it is a folder; choose the files again',
  'format/too-large': 'it is too large',
  'format/unsupported': 'it is encrypted, or packed with another method than Deflate; pack the files again',
};
