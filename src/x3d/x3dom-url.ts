/** Where x3dom is. A file of its own, because in dist it lies beside x3dom. A script that does not know its own address looks beside the page. */
export function findX3domUrl(): string {
  try {
    return new URL('../../node_modules/x3dom/x3dom.js', import.meta.url).href;
  } catch {
    return './x3dom.js';
  }
}
