import type { findX3domUrl as usual } from './x3dom-url.ts';

// The build writes `import.meta.url` in its place, as in create-worker-dist.ts.
declare const OWN_URL: string;

/** In place of x3dom-url.ts, in dist: the modules for bundlers and for pages. */
export const findX3domUrl: typeof usual = () => {
  try {
    return new URL('./x3dom.js', OWN_URL).href;
  } catch {
    return './x3dom.js';
  }
};
