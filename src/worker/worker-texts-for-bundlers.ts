import type * as usual from './worker-texts.ts';

const load = async () => (await import('built:worker')).text;

/** In place of worker-texts.ts, in the modules for bundlers: the text, which is loaded where a bundler has not copied the worker's file. */
export const listWorkerTexts: typeof usual.listWorkerTexts = () => [load];
export const isTextSurer: typeof usual.isTextSurer = (url) => !url || url.endsWith('/decode-worker.js');
