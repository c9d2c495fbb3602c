import { Budget } from '../../src/formats/base/budget.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import { readZarr } from '../../src/formats/zarr/read-zarr.ts';
import type { ZarrLoad } from '../../src/formats/zarr/read-zarr.ts';
import type { FileTree } from '../../src/formats/zarr/file-tree.ts';
import { roomyLimits } from './decode.ts';
import type { ZarrFiles } from './zarr-bytes.ts';

/** A tree of files in memory, and what was asked of it. */
export interface MemoryTree extends FileTree {
  readonly asked: string[];
  readonly parts: DecodedCartesianVolume[];
  readonly grids: DecodedCartesianVolume['grid'][];
  /** Files that were on their way at the same time. */
  most: number;
}

/** @param waits - whether reading takes a moment, as from a server */
export function memoryTree(
  files: ZarrFiles,
  waits = false,
  choice: Pick<FileTree, 'channel' | 'channels'> = {},
): MemoryTree {
  let running = 0;
  const tree: MemoryTree = {
    ...choice,
    asked: [],
    parts: [],
    grids: [],
    most: 0,
    async read(path, { part, signal } = {}) {
      tree.asked.push(path);
      tree.most = Math.max(tree.most, ++running);
      if (waits) await new Promise((resolve) => setTimeout(resolve, 1));
      running--;
      signal?.throwIfAborted();
      const bytes = files.get(path);
      if (!bytes) return null;
      if (!part) return bytes.slice();
      return 'end' in part ? bytes.slice(part.start, part.end) : bytes.slice(Math.max(0, bytes.length - part.last));
    },
    async showPart(part, grid) {
      tree.parts.push(part);
      tree.grids.push(grid);
    },
  };
  return tree;
}

/** Reads a store as a worker does. */
export async function readStore(
  files: ZarrFiles | FileTree,
  settings: DecodeSettings = {},
  load: Partial<ZarrLoad> = {},
): Promise<DecodedCartesianVolume> {
  return readZarr('read' in files ? files : memoryTree(files), settings, {
    limits: roomyLimits,
    budget: new Budget(),
    onProgress: () => undefined,
    ...load,
  });
}
