import { NeedsMainThread } from './needs-main-thread.ts';

/** Loads a reader's code. In a worker whose page blocks further scripts it throws, and the main thread does the work. */
export async function loadReader<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (cause) {
    throw new NeedsMainThread({ cause });
  }
}

/**
 * Load what is used where something failed.
 * @returns null if that can't be loaded: perhaps the network failed
 * @throws {NeedsMainThread} in a worker that was built without it
 */
export function loadIfReachable<T>(load: () => Promise<T>): Promise<T | null> {
  return load().catch((cause) => {
    if (cause instanceof NeedsMainThread) throw cause;
    return null;
  });
}
