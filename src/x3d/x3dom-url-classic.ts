import { scriptUrl } from '../page/script-url.ts';
import type { findX3domUrl as usual } from './x3dom-url.ts';

/** In place of x3dom-url.ts, in the classic script. */
export const findX3domUrl: typeof usual = () => {
  try {
    return new URL('x3dom.js', scriptUrl).href;
  } catch {
    return './x3dom.js';
  }
};
