import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { ByteStore, FileStat, ReadOptions } from './byte-store.ts';

/** One file that was read already. What is read of it are views of its memory. */
export class MemoryStore implements ByteStore {
  constructor(readonly file: DecodeInput) {}

  async list(): Promise<readonly string[]> {
    return [this.file.url];
  }

  async stat(): Promise<FileStat> {
    return { size: this.file.bytes.length };
  }

  /** A copy that the browser keeps outside of the page's memory. */
  sourceOf(): Blob {
    return new Blob([this.file.bytes]);
  }

  async read(_url: string, { range }: ReadOptions = {}): Promise<DecodeInput> {
    return { ...this.file, bytes: this.file.bytes.subarray(range?.start, range?.end) };
  }
}
