import { scriptUrl } from '../page/script-url.ts';
import type { findWorkers as usual } from './find-workers.ts';
import { chooseWorkers } from './worker-texts-classic.ts';

/** The names of the parts that are workers: scripts/classic/loader.js. */
declare const WORKER_PARTS: readonly string[];

/**
 * In place of find-workers.ts, in the classic script. Its workers are in the folder `classic`, as its other parts are: a page that has these has
 * them. A page without an origin may start none from a file.
 */
export const findWorkers: typeof usual = (dataUrl) =>
  origin === 'null' ? [] : chooseWorkers(dataUrl, WORKER_PARTS).map((name) => [new URL(name, scriptUrl)]);
