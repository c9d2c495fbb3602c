import type * as usual from './worker-texts.ts';

const load = async () => (await import('built:worker')).text;
const loadWhole = async () => (await import('built:whole-worker')).text;

/** In place of worker-texts.ts, in the modules for bundlers: the text, which is loaded where a bundler has not copied the worker's file, and one with large libraries for a file that needs them. */
export const listWorkerTexts: typeof usual.listWorkerTexts = () => [load, loadWhole];
export const isTextSurer: typeof usual.isTextSurer = (url) => !url || url.endsWith('/decode-worker.js');
