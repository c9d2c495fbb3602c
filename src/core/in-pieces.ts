import { later } from './later.ts';

/** The page is blocked for no longer than this at a time, ms. */
const pieceMs = 8;

/**
 * Do long work piece by piece; the page can work in between.
 * @returns null where the work was no longer needed
 */
export async function inPieces<T>(work: Iterator<unknown, T>, isWanted: () => boolean): Promise<T | null> {
  for (let began = performance.now(); isWanted();) {
    const { done, value } = work.next();
    if (done) return value;
    if (performance.now() - began < pieceMs) continue;
    await later();
    began = performance.now();
  }
  return null;
}
