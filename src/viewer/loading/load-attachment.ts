import type { LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import { loads } from './load-queue.ts';
import { sharedVolumes } from './shared-volumes.ts';

export interface AttachmentOptions {
  /** The object that will show it, until it is released. Without it, the volume is not kept for anyone. */
  readonly holder?: object;
  /** Instead of the browser's own `fetch`. */
  readonly fetch?: typeof globalThis.fetch | null;
}

/**
 * Load a volume that is attached to another, when it is its turn; it is not loaded again while an element of the page shows or
 * loads the same one.
 * @throws as loadVolume does
 */
export async function loadAttachment(
  request: LoadRequest,
  signal: AbortSignal,
  { holder, fetch }: AttachmentOptions = {},
): Promise<Volume> {
  // A holder that is not released keeps its volume in memory.
  const nobody = {};
  try {
    return await loads.run(
      () => true,
      signal,
      () => sharedVolumes.get(holder ?? nobody, request, { signal, fetch, onProgress: () => {} }),
    );
  } finally {
    sharedVolumes.release(nobody);
  }
}
