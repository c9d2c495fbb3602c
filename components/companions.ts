/** Elements that keep company with <volume-view>, and where their code is. It is fetched when a page has such an element. */
const companions: Record<string, () => Promise<unknown>> = {
  'volume-legend': () => import('./volume-legend.ts'),
  'volume-slice': () => import('./volume-slice.ts'),
  'volume-timeline': () => import('./volume-timeline.ts'),
  'volume-transfer-function': () => import('./volume-transfer-function.ts'),
};

const started = new Set<string>();

/** Fetch the code of every companion at or below an element. */
function startBelow(node: Node): void {
  if (!(node instanceof Element)) return;
  for (const { localName } of [node, ...node.querySelectorAll(Object.keys(companions).join())]) {
    if (!Object.hasOwn(companions, localName) || started.has(localName)) continue;
    started.add(localName);
    // A file that did not come is asked for again by the next such element.
    companions[localName]().catch((error: unknown) => {
      started.delete(localName);
      console.error(error);
    });
  }
}

// Modules are imported in Node too, where there is no page.
if (typeof document !== 'undefined') {
  startBelow(document.documentElement);
  const observer = new MutationObserver((records) => records.forEach(({ addedNodes }) => addedNodes.forEach(startBelow)));
  observer.observe(document, { childList: true, subtree: true });
}
