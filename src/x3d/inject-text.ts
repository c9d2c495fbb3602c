import { text } from 'built:x3dom';
import type { X3dom } from './x3dom-types.ts';

/** Runs x3dom's own text as a script, or the file at `url` if the page forbids that. @param inject - runs the script of a URL */
export async function injectText(url: string, inject: (url: string) => Promise<X3dom>): Promise<X3dom> {
  const own = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  try {
    return await inject(own);
  } catch {
    return await inject(url);
  } finally {
    URL.revokeObjectURL(own);
  }
}
