import type { createWorker as usual } from './create-worker.ts';

// The build writes `import.meta.url` in its place: its own bundler would replace the whole expression by an address of the source.
declare const OWN_URL: string;

/** In place of create-worker.ts, in dist: the modules for bundlers and for pages. */
export const createWorker: typeof usual = () => new Worker(new URL('./decode-worker.js', OWN_URL), { type: 'module' });
