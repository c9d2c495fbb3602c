import type * as usual from './worker-texts.ts';

// In the order of WORKER_PARTS (scripts/classic/build-classic.mjs).
const loads = [
  async () => (await import('built:usual-worker')).text,
  async () => (await import('built:worker')).text,
  async () => (await import('built:whole-worker')).text,
];

/**
 * Of a list about the three workers, what is about those that may read a file, the likely one first: a worker with the readers that pages usually
 * need, one with all readers, and one with the libraries of these too. The name of the file decides where the list begins; a file that one can't
 * read goes to the next one.
 */
export const chooseWorkers = <T>(url: string, list: readonly T[]): readonly T[] =>
  list.slice(/^(data|blob):|\.(nii|img|hdr)(\.gz)?([?#]|$)/i.test(url) ? 0 : 1);

/** In place of worker-texts.ts, in the classic script. */
export const listWorkerTexts: typeof usual.listWorkerTexts = (url) => chooseWorkers(url, loads);
export const isTextSurer: typeof usual.isTextSurer = () => false;
