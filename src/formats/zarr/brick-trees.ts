// Where bricks are read: views that show one pyramid share its tree and its chunks. Loaded when it is needed.
import { chooseKeptBytes } from '../base/brick-limits.ts';
import type { Queue } from '../base/queue.ts';
import { untilAborted } from '../base/shared-work.ts';
import { ByteCache } from './byte-cache.ts';
import { ChunkSource } from './chunk-source.ts';
import type { KeptOfZarr } from './chunk-source.ts';
import type { FileTree } from './file-tree.ts';
import { limitReads } from './limit-reads.ts';

/** A tree, which reads as many files at once as it may, and its chunks, of which those that were used last are kept. */
export interface BrickTree {
  readonly tree: FileTree;
  /** So many volumes of other files are numbered before its images. */
  readonly before: number;
  readonly chunks: ChunkSource;
}

interface SharedTree {
  /** Null for what is no Zarr. */
  readonly opened: Promise<BrickTree | null>;
  readonly end: AbortController;
  users: number;
}

/** Opens a tree. @param signal - ends all that it reads */
export type OpenTree = (signal: AbortSignal) => Promise<{ readonly tree?: FileTree; readonly before?: number }>;

/** By what is opened, and how. */
const shared = new Map<string, SharedTree>();

/** Chunks of all trees: a page has one limit, however many pyramids it shows. */
let kept: KeptOfZarr | null = null;
let count = 0;

/**
 * Opens a tree, or takes the one that another view has opened.
 * @param key - of views that may share it; null for one that is nobody else's
 * @param requests - limits the files that are read at once
 * @param signal - leaves it: who has the tree no longer reads from it then
 * @returns null for what is no Zarr @throws as `open`; the signal's reason
 */
export function takeTree(
  key: string | null,
  { open, requests }: { readonly open: OpenTree; readonly requests: Queue },
  signal: AbortSignal,
): Promise<BrickTree | null> {
  signal.throwIfAborted();
  const name = key ?? `own ${count}`;
  const known = shared.get(name);
  const one = known ?? openShared(open, requests);
  if (!known) shared.set(name, one);
  one.users++;
  const leave = (): void => {
    if (--one.users > 0) return;
    one.end.abort(signal.reason);
    if (shared.get(name) === one) shared.delete(name);
  };
  signal.addEventListener('abort', leave, { once: true });
  // A server may have what it did not have before.
  one.opened.catch(() => shared.get(name) === one && shared.delete(name));
  return untilAborted(one.opened, signal);
}

function openShared(open: OpenTree, requests: Queue): SharedTree {
  const end = new AbortController();
  const prefix = `${count++}:`;
  const read = async (): Promise<BrickTree | null> => {
    const { tree: found, before = 0 } = await open(end.signal);
    if (!found) return null;
    const tree = { ...found, ...limitReads(found, requests) };
    kept ??= new ByteCache(chooseKeptBytes());
    const all = kept;
    const own: Pick<KeptOfZarr, 'get' | 'set'> = {
      get: (path) => all.get(prefix + path),
      set: (path, value) => all.set(prefix + path, value),
    };
    return { tree, before, chunks: new ChunkSource(tree, own) };
  };
  return { opened: read(), end, users: 0 };
}
