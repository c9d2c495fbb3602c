import type { Surface } from '../volume/surface.ts';
import { VolumeViewError } from '../core/errors.ts';
import { loadPart } from '../core/load-part.ts';
import { workOff } from './load.ts';
import type { LoadOptions } from './load.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';
import type { SurfaceRequest } from './surface-request.ts';

/**
 * Loads a surface: in a worker, or on this thread if the page allows none. @throws {VolumeViewError}; the
 * signal's reason
 */
export async function loadSurface(request: SurfaceRequest, options: LoadOptions): Promise<Surface> {
  options.signal.throwIfAborted();
  return workOff({ order: { request, pageOrigin: origin } }, options, (watched) => loadHere(request, watched));
}

async function loadHere(request: SurfaceRequest, { signal, fetch, onProgress }: LoadOptions): Promise<Surface> {
  const { decodeSurface } = await loadPart(import('./decode-surface.ts'), 'reads surfaces');
  try {
    return await decodeSurface(request, {
      signal,
      pageOrigin: origin,
      fetch: fetch && (await loadPart(import('./serve-fetch.ts'), 'reads files')).checkedFetch(fetch),
      onProgress,
    });
  } catch (error) {
    if (!(error instanceof NeedsMainThread)) throw error;
    throw new VolumeViewError(
      'format/unsupported',
      'the part of volume-view that reads surfaces could not be loaded; check that all files of the package are on the server',
      { cause: error },
    );
  }
}
