import type * as usual from './worker-texts.ts';

/** In place of worker-texts.ts, in the modules for bundlers: the text, which is loaded where a bundler has not copied the worker's file. */
export const listWorkerTexts: typeof usual.listWorkerTexts = () => [async () => (await import('built:worker')).text];
export const isTextSurer: typeof usual.isTextSurer = (url) => !url || url.endsWith('/decode-worker.js');
