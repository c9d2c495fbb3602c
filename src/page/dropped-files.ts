// The files in what a person drops or pastes, with those in folders. Loaded with <volume-drop>.

/** As many as an archive may have: more are no scan. */
const maxFiles = 2 ** 14;

/** Folders in each other. */
const maxDepth = 32;

/** What systems add to folders by themselves; the metadata of a Zarr have such names too. */
const litter = /^(\.(?!z(array|attrs|group|metadata)$).*|__MACOSX|Thumbs\.db|desktop\.ini)$/i;

/** Whether something has files, before it is dropped: until then nobody may see them. */
export function hasFiles(data: DataTransfer | null): boolean {
  return data?.types.includes('Files') ?? false;
}

/**
 * The files, in the order in which they come. It must be called within the event: afterwards the browser has forgotten them.
 * @returns at most one more than are allowed, so that the reader of the files says that there are too many
 */
export function listDropped(data: DataTransfer): Promise<readonly File[]> {
  const entries = Array.from(data.items, (item) => (item.kind === 'file' ? item.webkitGetAsEntry() : null));
  const files = [...data.files];
  // Pictures of the clipboard have no entry.
  if (!entries.some((entry) => entry?.isDirectory)) return Promise.resolve(files);
  return walk(entries.filter((entry) => entry !== null));
}

async function walk(start: readonly FileSystemEntry[]): Promise<readonly File[]> {
  const files: File[] = [];
  const visit = async (entry: FileSystemEntry, depth: number): Promise<void> => {
    if (litter.test(entry.name) || depth > maxDepth || files.length > maxFiles) return;
    if (entry.isFile) {
      const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
      // A header finds its data by the path, and files of one name in several folders stay two.
      // As its name, the path reaches the worker; nothing is read for it.
      const { type, lastModified } = file;
      files.push(new File([file], entry.fullPath.replace(/^\//, ''), { type, lastModified }));
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    // A browser gives a hundred at a time, and then none.
    for (;;) {
      const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
      if (some.length === 0) return;
      for (const one of some) await visit(one, depth + 1);
    }
  };
  for (const entry of start) await visit(entry, 0);
  return files;
}
