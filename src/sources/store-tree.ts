import { VolumeViewError } from '../core/errors.ts';
import type { FileTree } from '../formats/zarr/file-tree.ts';
import { urlInStore } from './byte-store.ts';
import type { ByteStore } from './byte-store.ts';
import type { OpenedFiles } from './opened-files.ts';
import { reasonOf } from './private-store.ts';
import { showPart } from './show-part.ts';
import type { FolderLoad } from './show-part.ts';

/** Files that only a Zarr has. */
const metadata = /^(.*\/)?(zarr\.json|\.zgroup|\.zattrs|\.zarray)$/;

/**
 * The Zarr in an archive or in chosen files, if there is one: the folder that is the least deep, and has its metadata.
 * @param base - of the URLs of the store
 */
export async function openTree(
  store: ByteStore,
  base: string,
  load: FolderLoad | undefined,
  { kind, ...choice }: { readonly kind: NonNullable<OpenedFiles['source']>['kind'] } & ChannelChoice,
): Promise<OpenedFiles | null> {
  const urls = (await store.list()) ?? [];
  const folders = urls.flatMap((url) => {
    const found = metadata.exec(decodeURIComponent(url.slice(base.length)));
    return found ? [found[1] ?? ''] : [];
  });
  if (folders.length === 0) return null;
  const depth = (folder: string): number => folder.split('/').length;
  const folder = folders.reduce((least, one) => (depth(one) < depth(least) ? one : least));
  return openedTree(new StoreTree(store, new Set(urls), urlInStore(base, folder) + (folder && '/')), load, {
    source: { kind, count: urls.length },
    ...choice,
  });
}

/** Which channels the address asks for. */
type ChannelChoice = Pick<FileTree, 'channel' | 'channels'>;

/** What opening a Zarr gives. */
export function openedTree(
  files: Pick<FileTree, 'read'>,
  load: FolderLoad | undefined,
  { source, ...choice }: { readonly source?: OpenedFiles['source'] } & ChannelChoice,
): OpenedFiles {
  return {
    first: '',
    source,
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
