import { opendir, open, stat } from 'node:fs/promises';
import { basename, dirname, join, resolve, sep } from 'node:path';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { urlInStore } from '../../../src/sources/byte-store.ts';
import type { ByteStore, FileStat, ReadOptions } from '../../../src/sources/byte-store.ts';

/** URLs of files of a folder begin with this: no server can have this name (RFC 2606). */
export const folderBase = 'https://folder.invalid/';

export interface FolderStoreOptions {
  /** The paths of the files in it; all if undefined. */
  readonly only?: readonly string[];
  /** Absolute paths of folders that are left out. */
  readonly without?: readonly string[];
}

/** The files of a folder of this machine. Links are not followed: they may lead in a circle, or out of the folder. */
export class FolderStore implements ByteStore {
  #list: readonly string[] | null = null;

  /** @param folder - absolute */
  constructor(
    readonly folder: string,
    private readonly options: FolderStoreOptions = {},
  ) {}

  async list(): Promise<readonly string[]> {
    this.#list ??= (this.options.only ?? (await this.#walk())).map((path) => urlInStore(folderBase, path));
    return this.#list;
  }

  async stat(url: string): Promise<FileStat> {
    return { size: (await this.#about(stat(this.pathOf(url)))).size };
  }

  async read(url: string, { range, maxBytes }: ReadOptions = {}) {
    const path = this.pathOf(url);
    const handle = await this.#about(open(path));
    try {
      const { size } = await handle.stat();
      const [start, end] = [Math.min(size, range?.start ?? 0), Math.min(size, range?.end ?? size)];
      if (maxBytes !== undefined && end - start > maxBytes)
        throw new VolumeViewError('format/too-large', `a file has ${size} bytes; expected at most ${maxBytes}`);
      const bytes = new Uint8Array(Math.max(0, end - start));
      let at = 0;
      while (at < bytes.length) {
        // One call reads at most 2 GiB.
        const { bytesRead } = await handle.read(bytes, at, Math.min(2 ** 30, bytes.length - at), start + at);
        if (bytesRead === 0) break;
        at += bytesRead;
      }
      return { bytes: at < bytes.length ? bytes.slice(0, at) : bytes, url, contentType: '' };
    } finally {
      await handle.close();
    }
  }

  /** The path of a file on this machine. @throws {VolumeViewError} `source/not-found` where a URL leads out of the folder */
  pathOf(url: string): string {
    const path = url.startsWith(folderBase)
      ? resolve(this.folder, decodeURIComponent(url.slice(folderBase.length)))
      : null;
    if (path === null || !path.startsWith(this.folder.endsWith(sep) ? this.folder : this.folder + sep))
      throw notFound();
    return path;
  }

  async #about<T>(work: Promise<T>): Promise<T> {
    try {
      return await work;
    } catch (cause) {
      throw Object.assign(notFound(), { cause });
    }
  }

  async #walk(): Promise<string[]> {
    const found: string[] = [];
    const without = new Set(this.options.without);
    const folders = [''];
    for (let folder = folders.pop(); folder !== undefined; folder = folders.pop()) {
      for await (const entry of await opendir(join(this.folder, folder))) {
        const path = folder ? `${folder}/${entry.name}` : entry.name;
        if (entry.isDirectory() && !without.has(join(this.folder, path))) folders.push(path);
        else if (entry.isFile()) found.push(path);
      }
    }
    found.sort();
    return found;
  }
}

function notFound(): VolumeViewError {
  return new VolumeViewError(
    'source/not-found',
    'a file can not be read: it was moved or removed, or may not be read by you; check it, and run the command again',
  );
}

/** A file alone, as a store and its URL. */
export function storeOfFile(path: string): { readonly store: FolderStore; readonly url: string } {
  const store = new FolderStore(dirname(path), { only: [basename(path)] });
  return { store, url: urlInStore(folderBase, basename(path)) };
}
