import { isOurs } from './define.ts';
import { onNotice } from './notice-root.ts';

/** Whether the shadow tree of an element of this name may have elements of ours in it. Of ours, that of one has. */
const mayHoldOthers = (localName: string): boolean => localName === 'volume-workspace' || !isOurs(localName);

/** A tree of a page: the document, or an open shadow root in it. */
type Root = Document | ShadowRoot;

export interface RootsListener {
  /** Called for every element that is in the page, or comes into it. */
  seen?(element: Element): void;
  /** Called after elements came or went, or an `id` changed. */
  changed?(): void;
}

/**
 * The trees of a page, watched while somebody listens: the document, and all open shadow roots that are reached from it.
 * A shadow root that an element gets long after it came into the page makes no mutation that could be observed: it is
 * found when the definition of its element comes, when a <volume-view> or a companion in it is connected, or when its
 * host is put in anew. What is in a closed shadow root and connected notices it too, and nobody else looks into it.
 */
class OpenRoots {
  readonly #roots = new Set<Root>();
  readonly #listeners = new Set<RootsListener>();
  /** Names of custom elements whose definition is waited for. */
  readonly #awaited = new Set<string>();
  #observer: MutationObserver | null = null;

  /** @returns how to stop */
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

  /** An element is in the page: its root and those around it are watched, if anybody listens. */
  notice(element: Element): void {
    if (!this.#observer) return;
    let isNew = false;
    for (let root = element.getRootNode(); root instanceof ShadowRoot; root = root.host.getRootNode()) {
      isNew = this.#enter(root) || isNew;
    }
    if (isNew) this.#tell();
  }

  /** The first element that a search finds in the document, or else in an open shadow root. */
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

  /** @returns whether it was not watched already */
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

  /** Once an element is defined it may have a shadow root. */
  async #await(localName: string): Promise<void> {
    if (this.#awaited.has(localName)) return;
    this.#awaited.add(localName);
    await customElements.whenDefined(localName);
    this.#awaited.delete(localName);
    if (!this.#observer) return;
    for (const root of this.#roots) root.querySelectorAll(localName).forEach((element) => this.#see(element));
    this.#tell();
  }

  #onMutations(records: readonly MutationRecord[]): void {
    for (const { addedNodes } of records) {
      for (const node of addedNodes) {
        if (!(node instanceof Element) || !node.isConnected) continue;
        for (const element of [node, ...node.querySelectorAll('*')]) this.#see(element);
      }
    }
    for (const root of this.#roots) if (!root.isConnected) this.#roots.delete(root);
    this.#tell();
  }

  #tell(): void {
    for (const listener of this.#listeners) listener.changed?.();
  }
}

export const openRoots = new OpenRoots();
onNotice((element) => openRoots.notice(element));
