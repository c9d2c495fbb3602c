import { isOurs } from './define.ts';
import { onNotice } from './notice-root.ts';

/**
 * Whether the shadow tree of an element of this name may contain elements of ours. Of our own elements, only <volume-workspace> contains
 * such elements.
 */
const mayHoldOthers = (localName: string): boolean => localName === 'volume-workspace' || !isOurs(localName);

/** A tree of a page: the document, or an open shadow root in it. */
type Root = Document | ShadowRoot;

export interface RootsListener {
  /** Called for every element that is in the page now or is added later. */
  seen?(element: Element): void;
  /** Called after elements were added or removed, or an `id` changed. */
  changed?(): void;
}

/**
 * The trees of a page: the document, and all open shadow roots that can be reached from it. They are watched while there are listeners.
 * If an element gets a shadow root long after it came into the page, no mutation can be observed. Such a root is found when the element
 * is defined, when a <volume-view> or a companion in it is connected, or when its host is inserted again. A closed shadow root is watched
 * from when an element of ours in it is connected; `find` does not search it.
 */
class OpenRoots {
  readonly #roots = new Set<Root>();
  readonly #listeners = new Set<RootsListener>();
  /** Names of custom elements whose definition we wait for. */
  readonly #awaited = new Set<string>();
  #observer: MutationObserver | null = null;

  /** @returns a function that stops listening */
  listen(listener: RootsListener): () => void {
    this.#listeners.add(listener);
    if (!this.#observer) {
      this.#observer = new MutationObserver((records) => this.#onMutations(records));
      this.#enter(document);
    } else if (listener.seen) {
      for (const root of this.#roots) root.querySelectorAll('*').forEach((element) => listener.seen!(element));
    }
    return () => this.#forget(listener);
  }

  /** An element was added to the page: watch its root and the roots around it, if there are listeners. */
  notice(element: Element): void {
    if (!this.#observer) return;
    let isNew = false;
    for (let root = element.getRootNode(); root instanceof ShadowRoot; root = root.host.getRootNode()) {
      isNew = this.#enter(root) || isNew;
    }
    if (isNew) this.#notify();
  }

  /** The first result of a search: in the document, else in an open shadow root. */
  find<Found>(search: (root: Root) => Found | null): Found | null {
    for (const root of this.#roots) {
      const isOpen = root.isConnected && !(root instanceof ShadowRoot && root.mode === 'closed');
      const found = isOpen ? search(root) : null;
      if (found !== null) return found;
    }
    return null;
  }

  #forget(listener: RootsListener): void {
    this.#listeners.delete(listener);
    if (this.#listeners.size > 0) return;
    this.#observer?.disconnect();
    this.#observer = null;
    this.#roots.clear();
  }

  /** @returns whether the root was not yet watched */
  #enter(root: Root): boolean {
    if (this.#roots.has(root)) return false;
    this.#roots.add(root);
    this.#observer!.observe(root, { childList: true, subtree: true, attributes: true, attributeFilter: ['id'] });
    root.querySelectorAll('*').forEach((element) => this.#see(element));
    return true;
  }

  #see(element: Element): void {
    for (const listener of this.#listeners) listener.seen?.(element);
    const { localName, shadowRoot } = element;
    if (!mayHoldOthers(localName)) return; // Their trees change often.
    if (shadowRoot) this.#enter(shadowRoot);
    else if (localName.includes('-') && element.matches(':not(:defined)')) void this.#await(localName);
  }

  /** When the element is defined, it may have a shadow root. */
  async #await(localName: string): Promise<void> {
    if (this.#awaited.has(localName)) return;
    this.#awaited.add(localName);
    await customElements.whenDefined(localName);
    this.#awaited.delete(localName);
    if (!this.#observer) return;
    for (const root of this.#roots) root.querySelectorAll(localName).forEach((element) => this.#see(element));
    this.#notify();
  }

  #onMutations(records: readonly MutationRecord[]): void {
    for (const { addedNodes } of records) {
      for (const node of addedNodes) {
        if (!(node instanceof Element) || !node.isConnected) continue;
        for (const element of [node, ...node.querySelectorAll('*')]) this.#see(element);
      }
    }
    for (const root of this.#roots) if (!root.isConnected) this.#roots.delete(root);
    this.#notify();
  }

  #notify(): void {
    for (const listener of this.#listeners) listener.changed?.();
  }
}

export const openRoots = new OpenRoots();
onNotice((element) => openRoots.notice(element));
