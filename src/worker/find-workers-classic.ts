import { scriptUrl } from '../page/script-url.ts';
import type { findWorkers as usual } from './find-workers.ts';
import { chooseWorkers } from './worker-texts-classic.ts';

// scripts/classic/loader.js and the build define these: the numbers of the parts that are workers, the parts that the page has, the name of
// a part among them, and its address from the script.
declare const WORKER_PARTS: readonly number[];
declare const parts: object;
declare const keyOf: (part: number) => string;
declare const fileOf: (part: number) => string;

/**
 * In place of find-workers.ts, in the classic script. Its workers are in the folder `classic`, as its other parts are: a page that has these has
 * them. A page without an origin may start none from a file, and one that has the text of a worker asks for no file.
 */
export const findWorkers: typeof usual = (dataUrl) =>
  chooseWorkers(dataUrl, WORKER_PARTS).flatMap((part) =>
    origin === 'null' || keyOf(part) in parts ? [] : [[new URL(fileOf(part), scriptUrl)]],
  );
