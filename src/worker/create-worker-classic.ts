import { scriptUrl } from '../page/script-url.ts';
import type { createWorker as usual } from './create-worker.ts';

/** In place of create-worker.ts, in the classic script. */
export const createWorker: typeof usual = () => new Worker(new URL('decode-worker.js', scriptUrl), { type: 'module' });
