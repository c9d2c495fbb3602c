import type { LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import { loads } from './load-queue.ts';
import { sharedVolumes } from './shared-volumes.ts';

/**
 * Load a volume that is shown beside another, when it is its turn; not again while an element of the page shows or loads the same.
 * @param holder - who will show it, until it is released. Without, nobody is known to
 * @throws as loadVolume does
 */
export async function loadBeside(request: LoadRequest, signal: AbortSignal, holder?: object): Promise<Volume> {
  // Whoever is kept there stays in memory.
  const nobody = {};
  try {
    return await loads.run(() => true, signal, () => sharedVolumes.get(holder ?? nobody, request, { signal, onProgress: () => {} }));
  } finally {
    sharedVolumes.release(nobody);
  }
}
