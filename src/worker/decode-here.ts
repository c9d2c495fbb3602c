import { VolumeViewError } from '../core/errors.ts';
import type { Volume } from '../volume/volume.ts';
import { Budget } from '../formats/base/budget.ts';
import { decodeRequest } from './decode-request.ts';
import { checkedFetch } from './serve-fetch.ts';
import type { RequestEnvironment } from './decode-request.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';

/** Maximum bytes of a file and its decoded data on the main thread, which blocks the page meanwhile. */
const maxBytes = 2 ** 28;

/** Share of the steps that a worker may take. */
const effort = 1 / 8;

/** Does the worker's work on the main thread, which can't send it anywhere else. */
export async function decodeHere(request: LoadRequest, environment: RequestEnvironment): Promise<Volume> {
  try {
    const { fetch } = environment;
    // Only a worker reads bricks.
    return await decodeRequest(
      { ...request, finer: false },
      {
        ...environment,
        fetch: fetch && checkedFetch(fetch),
        budget: new Budget(maxBytes, effort),
        breathe,
      },
    );
  } catch (error) {
    if (environment.signal?.aborted) throw environment.signal.reason;
    if (error instanceof VolumeViewError && error.code === 'format/too-large') throw explainLimits(error);
    if (!(error instanceof NeedsMainThread)) throw error;
    throw new VolumeViewError(
      'format/unsupported',
      'the part of volume-view that reads this format could not be loaded, or the browser lacks a canvas; check that all files of the package are on the server',
      { cause: error.cause },
    );
  }
}

/** Lets the page do pending work: draw, and respond to its reader. */
function breathe(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

/** Adds that the same file may load in a worker, where the limits are larger. */
function explainLimits({ code, message, cause }: VolumeViewError): VolumeViewError {
  const limits = `at most ${maxBytes / 2 ** 20} MiB`;
  return new VolumeViewError(
    code,
    `${message}. The file was read by the page itself, which allows no worker or whose browser can not read it in one, and there ${limits} are taken on, ` +
      'as the page stands still meanwhile. Allow workers (Content-Security-Policy: worker-src), or use a smaller file',
    { cause },
  );
}
