import { VolumeViewError } from '../core/errors.ts';
import { maxEntries } from './zip-directory.ts';

/** Folders in each other: those of scanners and archives have fewer than ten. */
const maxDepth = 32;

/** What `files` may have in addition to files: a file or a folder that the page may read. */
type Handle = FileSystemFileHandle | FileSystemDirectoryHandle;

function isHandle(given: unknown): given is Handle {
  return typeof given === 'object' && given !== null && 'kind' in given && !(given instanceof Blob);
}

/**
 * Opens handles of files and folders, with all that is in them; all else stays as it is.
 * @throws {VolumeViewError} `format/too-large` where there are too many files, `source/not-found` where a folder can not be read
 */
export async function openHandles(given: readonly unknown[]): Promise<readonly unknown[]> {
  const opened: unknown[] = [];
  const add = (file: unknown): void => {
    if (opened.push(file) > maxEntries)
      throw new VolumeViewError(
        'format/too-large',
        `files got more than ${maxEntries.toLocaleString('en')} files; expected those of one scan. Choose a folder further inside`,
      );
  };
  const open = async (handle: Handle, folder: string, depth: number): Promise<void> => {
    if (handle.kind === 'directory') {
      if (depth > maxDepth) return;
      // The compiler does not know that a folder lists what is in it.
      const { values } = handle as unknown as { values(): AsyncIterable<Handle> };
      for await (const inner of values.call(handle)) await open(inner, `${folder}${handle.name}/`, depth + 1);
      return;
    }
    const file = await handle.getFile();
    Object.defineProperty(file, 'webkitRelativePath', { value: folder + file.name });
    add(file);
  };
  for (const one of given) {
    if (!isHandle(one)) add(one);
    else {
      try {
        await open(one, '', 0);
      } catch (cause) {
        if (cause instanceof VolumeViewError) throw cause;
        throw new VolumeViewError(
          'source/not-found',
          'the chosen folder can not be read: it was moved or removed, or this page may not read it any more. Choose it again',
        );
      }
    }
  }
  return opened;
}
