/** The page is held up for no longer than this at a time, ms. */
const pieceMs = 8;

/**
 * Do what takes long piece by piece; the page goes on in between.
 * @returns null where it was no longer wanted
 */
export async function inPieces<T>(work: Iterator<unknown, T>, isWanted: () => boolean): Promise<T | null> {
  for (let began = performance.now(); isWanted(); ) {
    const { done, value } = work.next();
    if (done) return value;
    if (performance.now() - began < pieceMs) continue;
    await new Promise((resolve) => setTimeout(resolve));
    began = performance.now();
  }
  return null;
}
