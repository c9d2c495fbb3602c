import { VolumeViewError } from '../core/errors.ts';
import type { Volume } from '../volume/volume.ts';
import { Budget } from '../formats/base/budget.ts';
import { decodeRequest } from './decode-request.ts';
import type { RequestEnvironment } from './decode-request.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';

/** Bytes of a file, and of what is made of it, that are taken on where the page stands still meanwhile. */
const mostBytes = 2 ** 28;

/** Share of the steps that a worker may take. */
const effort = 1 / 8;

/** The worker's work on the main thread, which has nowhere else to send it. */
export async function decodeHere(request: LoadRequest, environment: RequestEnvironment): Promise<Volume> {
  try {
    return await decodeRequest(request, { ...environment, budget: new Budget(mostBytes, effort), breathe });
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

/** Let the page do what waits: draw, and follow its reader. */
function breathe(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

/** The same file may be fine in a worker, and whoever reads this should know. */
function explainLimits({ code, message, cause }: VolumeViewError): VolumeViewError {
  const limits = `at most ${mostBytes / 2 ** 20} MiB`;
  return new VolumeViewError(
    code,
    `${message}. The file was read by the page itself, which allows no worker or whose browser can not read it in one, and there ${limits} are taken on, ` +
      'as the page stands still meanwhile. Allow workers (Content-Security-Policy: worker-src), or use a smaller file',
    { cause },
  );
}
