import { VolumeViewError } from '../core/errors.ts';
import type { FileTree } from '../formats/zarr/file-tree.ts';
import { urlInStore } from './byte-store.ts';
import type { DecodedVolume } from '../formats/base/decoded-volume.ts';
import type { ByteStore } from './byte-store.ts';
import type { OpenedFiles } from './opened-files.ts';
import { reasonOf } from './private-store.ts';
import { showPart } from './show-part.ts';
import type { FolderLoad } from './show-part.ts';

/** Files that only a Zarr has. */
const metadata = /^(.*\/)?(zarr\.json|\.zgroup|\.zattrs|\.zarray)$/;

/**
 * The folders of a store that are a Zarr each, those that are the least deep first: paths that end with a slash, or '' for all files.
 * @param urls - of all files of the store @param base - of these URLs
 */
export function findTrees(urls: readonly string[], base: string): readonly string[] {
  const folders = urls.flatMap((url) => {
    const found = metadata.exec(decodeURIComponent(url.slice(base.length)));
    return found ? [found[1] ?? ''] : [];
  });
  const depth = (folder: string): number => folder.split('/').length;
  const sorted = [...new Set(folders)];
  sorted.sort((a, b) => depth(a) - depth(b));
  const trees = new Set<string>();
  for (const folder of sorted) if (findTree(folder, trees) === null) trees.add(folder);
  return [...trees];
}

/** The one of these folders in which a path is; null where it is in none. */
export function findTree(path: string, trees: ReadonlySet<string>): string | null {
  for (let end = path.length; end > 0; end = path.lastIndexOf('/', end - 2) + 1)
    if (trees.has(path.slice(0, end))) return path.slice(0, end);
  return trees.has('') ? '' : null;
}

/** Opens a Zarr in an archive or in chosen files. @param folder - its path, as findTrees says @param base - of the URLs of the store */
export async function openTree(
  store: ByteStore,
  { folder, base }: { readonly folder: string; readonly base: string },
  load: FolderLoad | undefined,
  { kind, ...choice }: { readonly kind: SourceInfo['kind'] } & ChannelChoice,
): Promise<OpenedFiles> {
  const urls = (await store.list()) ?? [];
  return openedTree(new StoreTree(store, new Set(urls), urlInStore(base, folder) + (folder && '/')), load, {
    source: { kind, count: urls.length },
    ...choice,
  });
}

type SourceInfo = NonNullable<DecodedVolume['source']>;

/** Which channels the address asks for. */
type ChannelChoice = Pick<FileTree, 'channel' | 'channels'>;

/** What opening a Zarr gives. */
export function openedTree(
  files: Pick<FileTree, 'read'>,
  load: FolderLoad | undefined,
  { source, ...choice }: { readonly source?: SourceInfo } & ChannelChoice,
): OpenedFiles {
  return {
    first: '',
    describe: (volume) => ({ ...volume, source }),
    tree: {
      ...choice,
      read: files.read.bind(files),
      async showPart(part, grid) {
        if (load) await showPart(load, part, grid);
      },
    },
    // Its reader reads all of its files.
    read: async (url) => ({ bytes: new Uint8Array(), url, contentType: '', missing: 1 }),
  };
}

/** A folder of a store. Errors have no names: those of chosen files may be names of patients. */
class StoreTree implements Pick<FileTree, 'read'> {
  constructor(
    private readonly store: ByteStore,
    private readonly files: ReadonlySet<string>,
    private readonly folder: string,
  ) {}

  async read(
    ...[path, { part, maxBytes, signal } = {}]: Parameters<FileTree['read']>
  ): Promise<Uint8Array<ArrayBuffer> | null> {
    const url = urlInStore(this.folder, path);
    if (!this.files.has(url)) return null;
    try {
      let range = part && 'end' in part ? part : undefined;
      if (part && 'last' in part) {
        const { size } = await this.store.stat(url);
        range = { start: Math.max(0, size! - part.last), end: size! };
      }
      return (await this.store.read(url, { range, maxBytes, signal })).bytes;
    } catch (cause) {
      signal?.throwIfAborted();
      if (!(cause instanceof VolumeViewError)) throw cause;
      throw new VolumeViewError(cause.code, `a file of the Zarr can not be read: ${reasonOf(cause)}`);
    }
  }
}
