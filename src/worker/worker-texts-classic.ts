import type * as usual from './worker-texts.ts';

const loadUsual = async () => (await import('built:usual-worker')).text;
const loadAll = async () => (await import('built:worker')).text;

/**
 * In place of worker-texts.ts, in the classic script: a worker with the readers that pages usually need, and one with all readers. The
 * name of the file decides which of them is used first; a file that the first one can't read goes to the other one.
 */
export const listWorkerTexts: typeof usual.listWorkerTexts = (url) =>
  /^(data|blob):|\.(nii|img|hdr)(\.gz)?([?#]|$)/i.test(url) ? [loadUsual, loadAll] : [loadAll];
export const isTextSurer: typeof usual.isTextSurer = () => false;
