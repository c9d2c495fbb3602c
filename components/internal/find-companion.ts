/** A companion in the page that speaks of a view, and is seen. @param name - its tag's */
export function findCompanion(view: HTMLElement, name: string): HTMLElement | null {
  const roots = new Set([document, view.getRootNode() as Document | ShadowRoot]);
  const all = [...roots].flatMap((root) => [...root.querySelectorAll<HTMLElement & { readonly _view?: HTMLElement | null }>(name)]);
  return all.find((one) => one._view === view && one.offsetHeight > 0) ?? null;
}
