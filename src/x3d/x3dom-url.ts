/**
 * The URL of x3dom. It has its own file, because in dist it lies next to x3dom. A script that does not know its own URL
 * looks next to the page.
 */
export function findX3domUrl(): string {
  try {
    return new URL('../../node_modules/x3dom/x3dom.js', import.meta.url).href;
  } catch {
    return './x3dom.js';
  }
}
