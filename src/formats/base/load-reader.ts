import { NeedsMainThread } from './needs-main-thread.ts';

/** Load code. A worker whose page lets it load no further script leaves the work to the main thread. */
export async function loadReader<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (cause) {
    throw new NeedsMainThread({ cause });
  }
}
