import { trust } from '../core/trust.ts';
import { findWorkers } from '#find-workers';
import { isTextSurer, listWorkerTexts } from '#worker-texts';
import { takeWorker } from './spare-worker.ts';
import type { LiveWorker } from './spare-worker.ts';

/**
 * Ways to have a decode worker, the best first: the free one, or a new one. Each returns a worker that may still fail before its first message,
 * because a Content-Security-Policy, an opaque origin or a missing file show only then. In a browser without workers
 * all of them fail.
 * @param dataUrl - URL of the file that the worker will read
 */
export function listWorkerStarts(dataUrl: string): readonly (() => Promise<LiveWorker>)[] {
  const workers = findWorkers(dataUrl);
  const [[url, options] = []] = workers;
  const href = url?.href;
  const isOwn = url?.origin === origin;
  const starts = isOwn
    ? workers.map(
        ([own]) =>
          () =>
            takeWorker(own!.href, () => new Worker(trust(own!.href, 'createScriptURL'), options)),
      )
    : [];
  // Two builds carry the worker's text: the classic script, which may be a page's only file, or have no file that a
  // worker may load; and the modules for bundlers, some of which leave the worker's file out.
  const texts = listWorkerTexts(dataUrl).map((load) => () => takeWorker(load, async () => startFromText(await load())));
  if (texts.length > 0) starts[isTextSurer(href) ? 'unshift' : 'push'](...texts);
  // A script of another origin, such as a CDN's, may not be a worker. A script of this page's that imports it may.
  else if (url && !isOwn)
    starts.push(() => takeWorker(href, () => startFromText(`import ${JSON.stringify(href)};`, options)));
  return starts;
}

/** Starts a worker from its text. */
export function startFromText(text: string, options?: WorkerOptions): Worker {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const release = (): void => URL.revokeObjectURL(url);
  try {
    const worker = new Worker(trust(url, 'createScriptURL'), options);
    worker.terminate = () => {
      release();
      Worker.prototype.terminate.call(worker);
    };
    return worker;
  } catch (error) {
    release();
    throw error;
  }
}
