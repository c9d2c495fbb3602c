import type * as usual from './worker-texts.ts';

const loadUsual = async () => (await import('built:usual-worker')).text;
const loadAll = async () => (await import('built:worker')).text;
const loadWhole = async () => (await import('built:whole-worker')).text;

/**
 * In place of worker-texts.ts, in the classic script: a worker with the readers that pages usually need, one with all readers, and one with
 * the libraries of these too. The name of the file decides which of them is used first; a file that one can't read goes to the next one.
 */
export const listWorkerTexts: typeof usual.listWorkerTexts = (url) =>
  /^(data|blob):|\.(nii|img|hdr)(\.gz)?([?#]|$)/i.test(url) ? [loadUsual, loadAll, loadWhole] : [loadAll, loadWhole];
export const isTextSurer: typeof usual.isTextSurer = () => false;
