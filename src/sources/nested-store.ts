import type { Budget } from '../formats/base/budget.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { pathOf } from './byte-store.ts';
import type { ByteStore, FileStat, ReadOptions } from './byte-store.ts';
import { isZip } from './is-zip.ts';
import { LocalStore } from './local-store.ts';
import { maxEntries } from './zip-directory.ts';
import { ZipStore } from './zip-store.ts';

/** Archives in archives: a disk of a hospital has one archive, which a person may have packed again. */
const maxDepth = 2;

/** At most so many archives are opened. */
const maxArchives = 64;

/** Archives in an archive are unpacked as a whole, so all of them may have so many bytes, and a quarter of what the device holds. */
const maxInnerBytes = 2 ** 30;

/** Other programs call their files so too, and put archives into them that hold no volume. */
const archiveName = /\.(zip|ozx)$/i;

interface NestedOptions {
  readonly signal?: AbortSignal;
  readonly budget?: Pick<Budget, 'deviceBytes'>;
  /** Whether the files lie in an archive, which is the first one. */
  readonly isArchive: boolean;
}

/**
 * The files of a store with those in its archives, in place of the archives: `study/images.zip` becomes a folder. An archive that can not
 * be read stays a file.
 * @returns the store itself where it has no archive
 * @throws the signal's reason
 */
export async function openNested(store: ByteStore, options: NestedOptions): Promise<ByteStore> {
  let opened = store;
  for (let depth = options.isArchive ? 1 : 0; depth < maxDepth; depth++) {
    const next = await openArchives(opened, { ...options, isArchive: depth > 0 });
    if (!next) return opened;
    opened = next;
  }
  return opened;
}

/** @returns null where there is no archive */
async function openArchives(store: ByteStore, options: NestedOptions): Promise<ByteStore | null> {
  const urls = (await store.list()) ?? [];
  const archives = urls.filter((url) => archiveName.test(pathOf(url))).slice(0, maxArchives);
  const inside = new Map<string, ZipStore>();
  let count = urls.length;
  let room = Math.min(maxInnerBytes, (options.budget?.deviceBytes ?? Infinity) / 4);
  for (const url of archives) {
    options.signal?.throwIfAborted();
    const zip = await openArchive(store, url, { ...options, room }).catch(() => null);
    if (!zip || count + zip.entries.size > maxEntries || !isReadable(zip)) continue;
    if (options.isArchive) room -= (await store.stat(url)).size ?? 0;
    count += zip.entries.size;
    inside.set(url, zip);
  }
  options.signal?.throwIfAborted();
  return inside.size > 0 ? NestedStore.of(store, inside) : null;
}

/** An archive with a password, or packed in another way, stays a file that is not read: the others are no worse for it. */
const isReadable = ({ entries }: ZipStore): boolean =>
  [...entries.values()].every(({ isEncrypted, method }) => !isEncrypted && (method === 0 || method === 8));

/** @param options - with the bytes that an archive in an archive may have */
async function openArchive(
  store: ByteStore,
  url: string,
  { signal, isArchive, room }: NestedOptions & { readonly room: number },
): Promise<ZipStore | null> {
  const { bytes } = await store.read(url, { range: { start: 0, end: 4 }, signal });
  if (!isZip(bytes)) return null;
  // Parts of a file of a disk can be read where they are wanted; a file that is packed has to be unpacked up to them.
  const source = isArchive ? await unpackFile(store, url, { signal, maxBytes: room }) : store;
  return ZipStore.open(source, url, `${url}/`, 'in it');
}

/** A packed file, unpacked, kept by the browser outside of the page's memory. */
async function unpackFile(
  store: ByteStore,
  url: string,
  options: Pick<ReadOptions, 'signal' | 'maxBytes'>,
): Promise<ByteStore> {
  const { bytes } = await store.read(url, options);
  return new OneFile(url, new LocalStore([new File([bytes], 'a.zip')], 'https://packed.invalid/'));
}

/** A file under the URL that it has elsewhere. */
class OneFile implements ByteStore {
  readonly #inner = 'https://packed.invalid/a.zip';

  constructor(
    private readonly url: string,
    private readonly store: LocalStore,
  ) {}

  async list(): Promise<readonly string[]> {
    return [this.url];
  }

  stat(): Promise<FileStat> {
    return this.store.stat(this.#inner);
  }

  sourceOf(): Blob {
    return this.store.sourceOf(this.#inner);
  }

  async read(url: string, options?: ReadOptions): Promise<DecodeInput> {
    return { ...(await this.store.read(this.#inner, options)), url };
  }
}

class NestedStore implements ByteStore {
  /** Of each file the store that has it. */
  readonly #files = new Map<string, ByteStore>();

  private constructor(private readonly outer: ByteStore) {}

  static async of(outer: ByteStore, archives: ReadonlyMap<string, ZipStore>): Promise<NestedStore> {
    const nested = new NestedStore(outer);
    for (const url of (await outer.list()) ?? []) {
      const zip = archives.get(url);
      if (!zip) nested.#files.set(url, outer);
      else for (const inner of await zip.list()) nested.#files.set(inner, zip);
    }
    return nested;
  }

  async list(): Promise<readonly string[]> {
    return [...this.#files.keys()];
  }

  async stat(url: string): Promise<FileStat> {
    return this.#find(url).stat(url);
  }

  async read(url: string, options?: ReadOptions): Promise<DecodeInput> {
    return this.#find(url).read(url, options);
  }

  sourceOf(url: string): Blob | string | null {
    return this.#find(url).sourceOf?.(url) ?? null;
  }

  async readTogether(
    urls: readonly string[],
    options: Pick<ReadOptions, 'range' | 'signal'>,
  ): Promise<readonly DecodeInput[] | null> {
    return urls.every((url) => this.#find(url) === this.outer)
      ? ((await this.outer.readTogether?.(urls, options)) ?? null)
      : null;
  }

  /** A file that is not there is asked of the outer store, which says so in its words. */
  #find(url: string): ByteStore {
    return this.#files.get(url) ?? this.outer;
  }
}
