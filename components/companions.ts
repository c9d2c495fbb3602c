import { openRoots } from './open-roots.ts';

/** Elements that keep company with <volume-view>, and where their code is. It is fetched when a page has such an element. */
const companions: Record<string, () => Promise<unknown>> = {
  'volume-legend': () => import('./define/volume-legend.ts'),
  'volume-slice': () => import('./define/volume-slice.ts'),
  'volume-timeline': () => import('./define/volume-timeline.ts'),
  'volume-transfer-function': () => import('./define/volume-transfer-function.ts'),
};

/** Fetch the code of the companions that the page has, or will have, wherever they are: see `OpenRoots`. */
export function startCompanions(): void {
  // Modules are imported in Node too, where there is no page.
  if (typeof document === 'undefined') return;
  openRoots.listen({ seen: ({ localName }) => startCompanion(localName) });
}

const started = new Set<string>();

function startCompanion(localName: string): void {
  if (!Object.hasOwn(companions, localName) || started.has(localName) || customElements.get(localName)) return;
  started.add(localName);
  // A file that did not come is asked for again by the next such element.
  companions[localName]().catch((error: unknown) => {
    started.delete(localName);
    console.error(error);
  });
}
