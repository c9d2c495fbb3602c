import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { crc32 } from '../formats/codecs/crc32.ts';
import { unpack } from '../formats/codecs/gunzip.ts';
import { DeflateError, Inflater } from '../formats/codecs/inflate.ts';
import { joinPieces } from '../formats/base/join-pieces.ts';
import { pathOf, urlInStore } from './byte-store.ts';
import type { ByteRange, ByteStore, FileStat, ReadOptions } from './byte-store.ts';
import { maxFileBytes } from './download.ts';
import { asGzip } from './packed-file.ts';
import { refuseSize } from './store-errors.ts';
import { corruptZip, localBytes, readDirectory, unsupportedZip } from './zip-directory.ts';
import type { ReadBytes, ZipEntry } from './zip-directory.ts';

/** Ways of packing that are not read. Source: APPNOTE.TXT 6.3.10, 4.4.5 */
const methods: Readonly<Record<number, string>> = {
  9: 'Deflate64',
  12: 'bzip2',
  14: 'LZMA',
  93: 'Zstandard',
  95: 'xz',
  99: 'AES',
};

/** Packed bytes that are read in addition to those of a range, for what says how they are packed. */
const startOnTrust = 2 ** 10;

/** Bytes of a name and other fields before a file, and of what may follow it, that are read with it. */
const maxHeader = 2 ** 12;

/** The archive itself. */
interface Archive {
  readonly readBytes: ReadBytes;
  /** Where it can be read again. */
  readonly source: () => Blob | string | null;
}

/** The files in a ZIP archive, which is itself a file of another store. */
export class ZipStore implements ByteStore {
  /** Where the packed bytes of files begin: each header is read once. */
  readonly #dataStarts = new Map<ZipEntry, number>();
  #kept: Blob | null = null;

  /**
   * @param base - of the files' URLs, ends with a slash
   * @param name - of the archive, for messages
   */
  private constructor(
    readonly base: string,
    readonly name: string,
    readonly entries: ReadonlyMap<string, ZipEntry>,
    private readonly archive: Archive,
  ) {}

  /** Reads the list of an archive's files. @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large` */
  static async open(store: ByteStore, url: string, base: string, name: string): Promise<ZipStore> {
    const { size } = await store.stat(url);
    if (size === null)
      throw new VolumeViewError(
        'source/unavailable',
        `the server does not say how large ${name} is, so that no part of it can be read`,
      );
    const readBytes: ReadBytes = async (start, end, signal) => {
      const { bytes } = await store.read(url, { range: { start, end }, signal });
      if (bytes.length < end - start) throw corruptZip(name, 'is cut short');
      return bytes;
    };
    const entries = await readDirectory(readBytes, size, name);
    // Of files of the same name the last one counts, as for other programs.
    const named = new Map(entries.map((entry) => [urlInStore(base, entry.path), entry]));
    return new ZipStore(base, name, named, { readBytes, source: () => store.sourceOf?.(url) ?? null });
  }

  async list(): Promise<readonly string[]> {
    return [...this.entries.keys()];
  }

  async stat(url: string): Promise<FileStat> {
    return { size: this.#find(url).size };
  }

  async read(url: string, { range, maxBytes = maxFileBytes, signal }: ReadOptions = {}): Promise<DecodeInput> {
    const entry = this.#find(url);
    const [start, end] = [Math.min(range?.start ?? 0, entry.size), Math.min(range?.end ?? entry.size, entry.size)];
    if (end - start > maxBytes) throw refuseSize(this.#describe(entry), end - start, maxBytes);
    // Who reads a whole file is to know whether it is damaged; who looks at its start is not.
    const bytes = !range
      ? await this.#unpackWhole(entry, await this.#readPacked(entry, { signal }))
      : entry.method === 0
        ? (await this.#readPacked(entry, { range: { start, end }, signal })).slice()
        : await this.#unpackPart(entry, { start, end }, signal);
    return { bytes, url, contentType: '', packedBytes: entry.packed, missing: entry.size - end };
  }

  /** A file as a gzip file, of parts of the archive; null where the archive is on a server, or the file was not looked at. */
  sourceOf(url: string): Blob | null {
    const entry = this.#find(url);
    const start = this.#dataStarts.get(entry);
    if (start === undefined) return null;
    const source = this.#kept ?? this.archive.source();
    if (!(source instanceof Blob)) return null;
    this.#kept = source;
    // A part of a file has no name.
    return new Blob(asGzip(entry, start, (from, to) => source.slice(from, to)));
  }

  #find(url: string): ZipEntry {
    const entry = this.entries.get(url);
    if (entry) return entry;
    throw new VolumeViewError(
      'source/not-found',
      `the ZIP archive ${this.name} does not hold ${pathOf(url)}; expected it in the archive`,
    );
  }

  #describe({ path }: ZipEntry): string {
    return `${path.slice(0, 200)} in the ZIP archive ${this.name}`;
  }

  /** Reads a file as it lies in the archive. Of a range, these bytes; all if undefined. */
  async #readPacked(
    entry: ZipEntry,
    { range, signal }: Pick<ReadOptions, 'range' | 'signal'>,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const { isEncrypted, method, start, packed } = entry;
    if (isEncrypted)
      throw unsupportedZip(this.name, 'is encrypted', 'expected one without a password: pack the files again');
    if (method !== 0 && method !== 8) {
      throw unsupportedZip(
        this.name,
        `is packed with ${methods[method] ?? `method ${method}`}`,
        'expected Deflate, which every program for ZIP archives can write',
      );
    }
    // Of most files the header is short, so that it comes with the rest in one request.
    if (!range && entry.end - start <= localBytes + packed + maxHeader) {
      const all = await this.archive.readBytes(start, entry.end, signal);
      const from = this.#dataStart(all);
      this.#dataStarts.set(entry, start + from);
      if (from + packed > all.length) throw corruptZip(this.name, 'lists files that overlap');
      return all.subarray(from, from + packed);
    }
    const known = this.#dataStarts.get(entry);
    const dataStart = known ?? start + this.#dataStart(await this.archive.readBytes(start, start + localBytes, signal));
    this.#dataStarts.set(entry, dataStart);
    const { start: first, end } = range ?? { start: 0, end: packed };
    return this.archive.readBytes(dataStart + first, dataStart + Math.min(end, packed), signal);
  }

  /** Where the packed bytes of a file begin after its header. */
  #dataStart(header: Uint8Array<ArrayBuffer>): number {
    const view = new DataView(header.buffer, header.byteOffset, localBytes);
    if (view.getUint32(0, true) !== 0x04034b50) throw corruptZip(this.name, 'has no file where its list says');
    return localBytes + view.getUint16(26, true) + view.getUint16(28, true);
  }

  /** Unpacks a file, and checks its length and its checksum. */
  async #unpackWhole(entry: ZipEntry, packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
    const { method, size, crc } = entry;
    const what = this.#describe(entry);
    const damaged = (cause?: unknown): VolumeViewError =>
      new VolumeViewError('format/corrupt', `${what} is damaged; fetch the archive again, or pack it again`, { cause });
    if (method === 0) {
      if (crc32(packed) !== crc) throw damaged();
      return packed.slice();
    }
    const bytes = new Uint8Array(size);
    let at = 0;
    const gzip = joinPieces(asGzip(entry, 0, (start, end) => packed.subarray(start, end)));
    for await (const piece of unpack(gzip, 'gzip', what)) {
      if (at + piece.length > size) throw damaged();
      bytes.set(piece, at);
      at += piece.length;
    }
    if (at < size) throw damaged();
    return bytes;
  }

  /** Unpacks a file up to the end of a range. Of the packed bytes it reads few first: they are enough where packing made them fewer. */
  async #unpackPart(
    entry: ZipEntry,
    range: ByteRange,
    signal: AbortSignal | undefined,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const few = range.end + startOnTrust;
    if (few >= entry.packed) return this.#unpackUpTo(entry, await this.#readPacked(entry, { signal }), range)!;
    return (
      this.#unpackUpTo(entry, await this.#readPacked(entry, { range: { start: 0, end: few }, signal }), range) ??
      this.#unpackUpTo(entry, await this.#readPacked(entry, { signal }), range)!
    );
  }

  /** @returns null where the packed bytes are only the first ones, and not enough */
  #unpackUpTo(
    entry: ZipEntry,
    packed: Uint8Array<ArrayBuffer>,
    { start, end }: ByteRange,
  ): Uint8Array<ArrayBuffer> | null {
    const bytes = new Uint8Array(end - start);
    let at = 0;
    try {
      for (const piece of new Inflater().unpack(packed, 0)) {
        const part = piece.subarray(Math.max(0, start - at), Math.max(0, end - at));
        bytes.set(part, Math.max(0, at - start));
        at += piece.length;
        if (at >= end) break;
      }
    } catch (cause) {
      if (cause instanceof DeflateError && cause.isCut && packed.length < entry.packed) return null;
      if (cause instanceof DeflateError)
        throw new VolumeViewError(
          'format/corrupt',
          `${this.#describe(entry)} ${cause.message}; fetch the archive again, or pack it again`,
          { cause },
        );
      throw cause;
    }
    return bytes;
  }
}
