import type { injectOwnText as usual } from './x3dom-text.ts';

/** In place of x3dom-text.ts, in the modules for bundlers: the text is loaded where a bundler has not copied x3dom's file. */
export const injectOwnText: typeof usual = async (url, inject) =>
  (await import('./inject-text.ts')).injectText(url, inject);
