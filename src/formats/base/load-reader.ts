import { NeedsMainThread } from './needs-main-thread.ts';

/** Loads a reader's code. In a worker whose page blocks further scripts it throws, and the main thread does the work. */
export async function loadReader<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (cause) {
    throw new NeedsMainThread({ cause });
  }
}
