// Opens a volume among the files of an archive, or among chosen files: finds those that there are, and chooses one.
import { VolumeViewError } from '../core/errors.ts';
import { checkFileCount } from '../formats/base/check-file-count.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { keptBytes } from '../formats/base/format.ts';
import type { ByteStore, ReadOptions } from './byte-store.ts';
import { choosePart, listVolumes, withLeft } from './choose-volume.ts';
import type { VolumePart } from './choose-volume.ts';
import type { FilePart } from './divide-files.ts';
import { findVolumes, isLitter } from './find-volume.ts';
import type { FindOptions, FoundVolumes } from './find-volume.ts';
import { FolderReader } from './folder-reader.ts';
import { HttpStore } from './http-store.ts';
import { openNested } from './nested-store.ts';
import type { OpenedFiles } from './opened-files.ts';
import { PrivateStore, reasonOf } from './private-store.ts';
import type { FolderLoad } from './show-part.ts';
import { findTree, findTrees, openTree } from './store-tree.ts';

export type OpenOptions = Pick<FindOptions, 'isStack' | 'signal'> & {
  /** Reads files of series in parts for this load; they are read as a whole if undefined. */
  readonly load?: FolderLoad;
  /** The number of the volume, from 1; as the load says if undefined, which may leave it to this. */
  readonly series?: number;
};

/** Files of which it is not known yet what they are. */
export interface UnknownFiles {
  readonly store: ByteStore;
  readonly base: string;
  /** What holds them, for messages. @param count - of the files */
  readonly what: (count: number) => string;
  readonly kind: 'archive' | 'files';
  /** Whether their names are not to be seen. */
  readonly isPrivate: boolean;
}

/** @throws {VolumeViewError} `format/…`, `source/…`, `attribute/invalid` */
export async function openStore(given: UnknownFiles, options: OpenOptions): Promise<OpenedFiles> {
  const { base, kind, isPrivate } = given;
  const { load, signal, isStack, series: wanted = load?.request.settings?.series } = options;
  const all = await openNested(given.store, { isArchive: kind === 'archive', signal, budget: load?.budget });
  const trees = findTrees((await all.list()) ?? [], base);
  const inTrees = new Set(trees);
  const isOther = (url: string): boolean =>
    !isLitter(url) && (trees.length === 0 || findTree(decodeURIComponent(url.slice(base.length)), inTrees) === null);
  const store = isPrivate ? await PrivateStore.of(all, base, (url) => !isOther(url)) : all;
  const listed = (await store.list()) ?? [];
  const urls = isPrivate ? listed : listed.filter(isOther);
  const source = {
    kind,
    count: (isPrivate && trees.length === 0 ? listed : ((await all.list()) ?? [])).length,
  } as const;
  const tree = (folder: string): Promise<OpenedFiles> => openTree(all, { folder, base }, load, { kind });
  if (trees.length === 1 && urls.length === 0) return tree(trees[0]);
  const what = given.what(urls.length);
  const found =
    urls.length === 0 && trees.length > 0
      ? nothing
      : // Looking at many files takes a while: whoever waits is to know that it goes on.
        await findVolumes(store, urls, {
          what,
          isStack,
          isBeside: trees.length > 0,
          signal,
          onLook: () => load?.onProgress(0, 0),
        });
  const parts = [...(await describeTrees(all, base, trees)), ...(await describeParts(store, found.parts))];
  const place = choosePart(parts, parts.length > 1 ? wanted : undefined);
  const choice = { shown: place, isWanted: wanted !== undefined };
  const part = found.parts[place - trees.length];
  const opened: OpenedFiles = part
    ? await openPart(part, { store, base, what, starts: found.starts }, options)
    : await tree(trees[place]);
  return {
    ...opened,
    ...(parts.length > 1 && { before: place }),
    describe: (volume) => ({
      ...withLeft(parts.length > 1 ? listVolumes(volume, parts, choice) : volume, describeUnread(found)),
      source,
    }),
  };
}

const nothing: FoundVolumes = { parts: [], images: [], refused: [] };

async function describeTrees(store: ByteStore, base: string, trees: readonly string[]): Promise<VolumePart[]> {
  if (trees.length === 0) return [];
  const all = new Set(trees);
  const of = new Map(trees.map((tree) => [tree, { count: 0, bytes: 0 }]));
  for (const url of (await store.list()) ?? []) {
    const tree = findTree(decodeURIComponent(url.slice(base.length)), all);
    if (tree === null) continue;
    const counts = of.get(tree)!;
    counts.count++;
    counts.bytes += (await store.stat(url)).size ?? 0;
  }
  return [...of.values()].map((counts) => ({ of: 'tree', format: 'OME-Zarr', ...counts }));
}

async function describeParts(store: ByteStore, parts: readonly FilePart[]): Promise<VolumePart[]> {
  const described: VolumePart[] = [];
  for (const { of, format, files } of parts) {
    let bytes: number | null = 0;
    for (const url of files) {
      const { size } = await store.stat(url);
      bytes = bytes === null || size === null ? null : bytes + size;
    }
    described.push({ of, format, count: files.length, bytes });
  }
  return described;
}

/** What of the files is in no volume. */
function describeUnread({ images, refused }: FoundVolumes): string[] {
  const count = images.length.toLocaleString('en');
  return [
    ...(images.length > 0 ? [`${images.length > 1 ? `${count} images` : 'an image'} in the other files`] : []),
    ...refused,
  ];
}

async function openPart(
  { of, files }: FilePart,
  {
    store,
    base,
    what,
    starts,
  }: Pick<UnknownFiles, 'store' | 'base'> & Pick<FoundVolumes, 'starts'> & { readonly what: string },
  { load, signal, isStack }: OpenOptions,
): Promise<OpenedFiles> {
  const isSeries = of === 'slices';
  if (of !== 'volume') checkFileCount(what, files.length);
  const readOne: ByteStore['read'] = (url, reading) => readPrivate(store, url, files, reading);
  const folder =
    load && isSeries && files.length > 1
      ? await FolderReader.of(store, files, readOne, { load, starts, signal })
      : null;
  return {
    first: files[0],
    ...((files.length > 1 || (isStack && of === 'images')) && { files }),
    ...(isSeries && { isPrivate: true }),
    ...(folder && { folder }),
    describe: (volume) => volume,
    sourceOf: (url) => store.sourceOf?.(url) ?? null,
    async read(url, reading) {
      if (url.startsWith(base))
        // The start of the first file says its format. Its reader reads all of them by itself.
        return folder
          ? { ...(await folder.readStart(url, keptBytes)), missing: 0 }
          : (isSeries ? readOne : store.read.bind(store))(url, reading);
      if (url.startsWith('data:')) return new HttpStore({ pageOrigin: '' }).read(url, reading);
      // A file from anywhere must not make the page request what its author has not named.
      throw new VolumeViewError(
        'source/not-found',
        `${what} names ${url.slice(0, 300)}, which it does not hold; expected all files of the volume in it`,
      );
    },
  };
}

/** Reads a file whose name is not to be seen: errors have its number instead. */
async function readPrivate(
  store: ByteStore,
  url: string,
  files: readonly string[],
  options: ReadOptions = {},
): Promise<DecodeInput> {
  try {
    return await store.read(url, options);
  } catch (cause) {
    options.signal?.throwIfAborted();
    if (!(cause instanceof VolumeViewError)) throw cause;
    throw new VolumeViewError(
      cause.code,
      `file ${files.indexOf(url) + 1} of ${files.length} (in the order of their names) can not be read: ${reasonOf(cause)}`,
    );
  }
}
