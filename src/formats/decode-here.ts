import { VolumeViewError } from '../errors.ts';
import type { Volume } from '../volume/volume.ts';
import { decodeRequest } from './decode-request.ts';
import type { RequestEnvironment } from './decode-request.ts';
import type { LoadRequest } from './load-request.ts';
import { NeedsMainThread } from './needs-main-thread.ts';

/** The worker's work on the main thread, which has nowhere else to send it. */
export async function decodeHere(request: LoadRequest, environment: RequestEnvironment): Promise<Volume> {
  try {
    return await decodeRequest(request, environment);
  } catch (error) {
    if (environment.signal?.aborted) throw environment.signal.reason;
    if (!(error instanceof NeedsMainThread)) throw error;
    throw new VolumeViewError(
      'format/unsupported',
      'the part of volume-view that reads this format could not be loaded, or the browser lacks a canvas; check that all files of the package are on the server',
      { cause: error.cause },
    );
  }
}
