import { existsSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { decodeSource } from '../../../src/prepare/decode-source.ts';
import { makeOmeZarr } from '../../../src/prepare/write-ome-zarr.ts';
import { urlInStore } from '../../../src/sources/byte-store.ts';
import { folderBase, FolderStore } from './folder-store.ts';
import { writeFolder } from './write-folder.ts';

/** Packs a chunk of an array. */
export const packChunk = (chunk: Uint8Array): Uint8Array => gzipSync(chunk, { level: 6 });

/** A folder that was written. */
export interface WrittenZarr {
  readonly folder: string;
  readonly dimensions: readonly number[];
  readonly files: number;
  readonly bytes: number;
  /** What of the file is not in it, in words. */
  readonly left: readonly string[];
}

/**
 * Writes each volume of a file as an OME-Zarr, a folder: NAME.ome.zarr, NAME-2.ome.zarr and so on.
 * @param name - path without an extension
 * @param deviceBytes - that one volume may take in memory
 * @throws {VolumeViewError} `format/…`, `source/…`
 */
export async function* writeZarr(path: string, name: string, deviceBytes: number): AsyncGenerator<WrittenZarr> {
  const store = new FolderStore(dirname(resolve(path)));
  const source = { first: urlInStore(folderBase, basename(path)), phase: 1 } as const;
  for await (const one of decodeSource(store, source, { deviceBytes })) {
    if ('error' in one) throw one.error;
    const folder = `${one.number > 1 ? `${name}-${one.number}` : name}.ome.zarr`;
    // Only what is an OME-Zarr is replaced.
    if (existsSync(folder) && !existsSync(join(folder, 'zarr.json')))
      throw new Error(`${folder} is there, and is no OME-Zarr; expected another name: --out NAME`);
    let [files, bytes] = [0, 0];
    const count = function* () {
      for (const [file, content] of makeOmeZarr(one.volume, packChunk).files) {
        files++;
        bytes += content.length;
        yield [file, content] as const;
      }
    };
    const target = resolve(folder);
    await writeFolder(dirname(target), basename(target), count());
    yield { folder, dimensions: one.volume.grid.dimensions, files, bytes, left: one.volume.left ?? [] };
  }
}
