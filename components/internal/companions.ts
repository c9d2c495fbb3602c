import { coming } from './coming-companions.ts';
import { isOurs } from './define.ts';
import { onNotice } from './notice-root.ts';
import type { openRoots } from './open-roots.ts';

/** Fetch the code of the companions that the page has now or gets later, wherever they are: see `OpenRoots`. */
export function startCompanions(): void {
  // Modules are imported in Node too, where there is no page.
  if (typeof document === 'undefined') return;
  observer = new MutationObserver((records) => {
    for (const { addedNodes } of records) addedNodes.forEach(lookThrough);
  });
  observer.observe(document, { childList: true, subtree: true });
  lookThrough(document);
  onNotice((element) => void watchRoots().then((roots) => roots?.notice(element)));
}

/** Watches the document until `openRoots` does so: that one also watches the shadow roots. */
let observer: MutationObserver;

function lookThrough(node: Node): void {
  if (!node.isConnected) return;
  if (node instanceof Element) see(node);
  if (node instanceof Element || node instanceof Document) node.querySelectorAll('*').forEach(see);
}

function see({ localName, shadowRoot }: Element): void {
  const mayBeOurs = localName.startsWith('volume-');
  if (mayBeOurs) startCompanion(localName);
  if (localName === 'volume-workspace' || (!mayBeOurs && (shadowRoot || localName.includes('-')))) void watchRoots();
}

let watching: Promise<typeof openRoots | null> | null = null;

/** Load the code that watches shadow roots. This happens with the first element that has a shadow root, or may get one. */
function watchRoots(): Promise<typeof openRoots | null> {
  return (watching ??= import('./open-roots.ts')
    .then(({ openRoots: roots }) => {
      observer.disconnect();
      roots.listen({ seen: ({ localName }) => startCompanion(localName) });
      return roots;
    })
    .catch((error: unknown) => {
      watching = null;
      console.error(error);
      return null;
    }));
}

/** Load the code of one of our elements. An element of somebody else may have a name like ours, and a view in its shadow root. */
function startCompanion(localName: string): void {
  if (localName === 'volume-view' || coming.has(localName) || isOurs(localName)) return;
  // If a file could not be loaded, the next element of that name requests it again.
  coming.set(
    localName,
    import('./elements.ts')
      .then(({ elements }): Promise<unknown> =>
        Object.hasOwn(elements, localName) ? elements[localName]() : watchRoots(),
      )
      .catch((error: unknown) => console.error(error))
      .finally(() => coming.delete(localName)),
  );
}
