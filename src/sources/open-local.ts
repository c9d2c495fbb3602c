import type { LocalFiles } from '../formats/base/load-request.ts';
import { LocalStore } from './local-store.ts';
import { openHandles } from './open-handles.ts';
import { receiveFiles } from './receive-files.ts';

/** Files that a page sends can be received once, and a load may need them again. */
const received = new WeakMap<MessagePort, Promise<readonly unknown[]>>();

/**
 * The files that a person chose, with all that is in chosen folders.
 * @throws {VolumeViewError} as openHandles and LocalStore say; the signal's reason
 */
export async function openLocal({ base, files, rest }: LocalFiles, signal?: AbortSignal): Promise<LocalStore> {
  if (rest && !received.has(rest)) received.set(rest, receiveFiles(rest, signal));
  return new LocalStore(await openHandles(rest ? await received.get(rest)! : files), base);
}
