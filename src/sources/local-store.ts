import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { pathOf, urlInStore } from './byte-store.ts';
import type { ByteStore, FileStat, ReadOptions } from './byte-store.ts';
import { Download } from './download.ts';
import { refuseSize } from './store-errors.ts';

/** Parts of a file of at most so many bytes are read in one piece. */
const atOnce = 2 ** 22;

/**
 * Files from the reader's disk: those that a person chose, or a folder. Their URLs are below `base`, with the path inside
 * of the folder where a folder was chosen.
 */
export class LocalStore implements ByteStore {
  readonly #files: ReadonlyMap<string, Blob>;

  /**
   * @param base - a URL that ends with a slash
   * @throws {VolumeViewError} `attribute/invalid` where one of them is no file
   */
  constructor(files: readonly unknown[], base: string) {
    const named = new Map<string, Blob>();
    for (const [i, file] of files.entries()) {
      const url = urlInStore(base, nameFile(file, i));
      // Files of several folders may have the same name, where the browser does not say their folders.
      named.set(named.has(url) ? urlInStore(`${base}${i + 1}/`, nameFile(file, i)) : url, file as Blob);
    }
    this.#files = named;
  }

  async list(): Promise<readonly string[]> {
    return [...this.#files.keys()];
  }

  async stat(url: string): Promise<FileStat> {
    return { size: this.#find(url).size };
  }

  async read(
    url: string,
    { range, maxBytes, signal, isEnough, onProgress = () => undefined }: ReadOptions = {},
  ): Promise<DecodeInput> {
    const file = this.#find(url);
    const size = range ? Math.max(0, Math.min(range.end, file.size) - range.start) : file.size;
    const missing = range ? Math.max(0, file.size - range.end) : 0;
    const name = this.#nameOf(url);
    if (maxBytes !== undefined && size > maxBytes) throw refuseSize(name, size, maxBytes);
    try {
      const part = range ? file.slice(range.start, range.end) : file;
      // A stream is worth its time only where somebody waits for the first bytes of many.
      if (size <= atOnce) {
        const bytes = new Uint8Array(await part.arrayBuffer());
        signal?.throwIfAborted();
        onProgress(bytes.length, bytes.length);
        return { bytes, url, contentType: file.type, missing };
      }
      const download = new Download(url, { signal, maxBytes, pageOrigin: '', isEnough, onProgress });
      const read = await download.read(
        new Response(part, {
          headers: { 'content-length': String(size), 'content-type': file.type, 'accept-ranges': 'bytes' },
        }),
      );
      return range ? { ...read, missing } : read;
    } catch (cause) {
      signal?.throwIfAborted();
      throw new VolumeViewError(
        'source/not-found',
        `${name} can not be read from the disk: it was moved, changed or removed since it was chosen, or it is a folder; expected a file. Choose it again`,
        { cause },
      );
    }
  }

  sourceOf(url: string): Blob {
    return this.#find(url);
  }

  async readTogether(
    urls: readonly string[],
    { range, signal }: Pick<ReadOptions, 'range' | 'signal'>,
  ): Promise<readonly DecodeInput[] | null> {
    const files = urls.map((url) => this.#find(url));
    let all: Uint8Array<ArrayBuffer>;
    const parts = range ? files.map((file) => file.slice(range.start, range.end)) : files;
    try {
      all = new Uint8Array(await new Blob(parts).arrayBuffer());
    } catch {
      all = new Uint8Array();
    }
    signal?.throwIfAborted();
    if (all.length !== parts.reduce((sum, { size }) => sum + size, 0)) return null;
    let at = 0;
    return urls.map((url, i) => {
      const bytes = all.subarray(at, (at += parts[i].size));
      const missing = range ? Math.max(0, files[i].size - range.end) : 0;
      return { bytes, url, contentType: files[i].type, missing };
    });
  }

  /** The name of a single file may be that of a patient, and says nothing new. */
  #nameOf(url: string): string {
    return this.#files.size > 1 ? pathOf(url) : 'the chosen file';
  }

  #find(url: string): Blob {
    const file = this.#files.get(url);
    if (file) return file;
    throw new VolumeViewError(
      'source/not-found',
      `${pathOf(url)} is not among the chosen files; choose it together with the others`,
    );
  }
}

/** The path of a file in its folder, or its name. Pictures of the clipboard and the like have none. */
function nameFile(file: unknown, place: number): string {
  if (!(file instanceof Blob))
    throw new VolumeViewError(
      'attribute/invalid',
      `files got something that is no file at place ${place + 1}; expected a FileList, or an array of File objects.`,
    );
  const { name, webkitRelativePath } = file as Partial<File>;
  return webkitRelativePath || name || `file ${place + 1}`;
}
