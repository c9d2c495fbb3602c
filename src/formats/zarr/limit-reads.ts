import { VolumeViewError } from '../../core/errors.ts';
import type { Queue } from '../base/queue.ts';
import { untilAborted } from '../base/shared-work.ts';
import type { FileTree } from './file-tree.ts';

/** Milliseconds after which a request is given up, with all its repetitions. */
const patienceMs = 60_000;

/**
 * A tree that reads no more files at once than a queue allows. What is given up before its turn is never asked for; a server that does not answer holds a
 * place for a minute.
 */
export function limitReads(tree: Pick<FileTree, 'read'>, queue: Queue): Pick<FileTree, 'read'> {
  return {
    read(path, options = {}) {
      const { signal } = options;
      const reading = queue.run(async () => {
        signal?.throwIfAborted();
        const own = new AbortController();
        const stop = (): void => own.abort(signal!.reason);
        signal?.addEventListener('abort', stop, { once: true });
        const timer = setTimeout(() => own.abort(stalled()), patienceMs);
        try {
          return await tree.read(path, { ...options, signal: own.signal });
        } finally {
          clearTimeout(timer);
          signal?.removeEventListener('abort', stop);
        }
      });
      return signal ? untilAborted(reading, signal) : reading;
    },
  };
}

function stalled(): VolumeViewError {
  return new VolumeViewError(
    'source/stalled',
    `a file of the Zarr did not come within ${patienceMs / 1000} seconds; check the network and load it again`,
  );
}
