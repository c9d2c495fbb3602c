import type { X3dDocument, X3dOwned, X3dViewpoint, X3dom } from './x3dom-types.ts';

/**
 * The author's own X3D children: grafted into the scene from the light DOM, where they stay, and kept in step with it
 * when they are added, removed or changed.
 */
export class AuthorNodes {
  readonly #observer: MutationObserver;
  readonly #grafted = new Set<X3dOwned>();
  readonly #defaults = new WeakMap<Element, ReadonlyMap<string, string>>();

  constructor(
    readonly x3dom: X3dom,
    readonly document: X3dDocument,
    readonly host: Element,
  ) {
    for (const child of host.children) this.#graft(child);
    this.#observer = new MutationObserver((records) => this.#followChildren(records));
    this.#observer.observe(host, { childList: true });
  }

  /** The author's first viewpoint, or null. It wins over the element's camera attributes. */
  get viewpoint(): X3dViewpoint | null {
    for (const element of this.#grafted) {
      const found = [element, ...element.querySelectorAll<X3dOwned>('*')].find((e) => /viewpoint$/i.test(e.localName));
      if (found?._x3domNode) return found._x3domNode as X3dViewpoint;
    }
    return null;
  }

  /** Whether the author gave an attribute: x3dom writes all others into the elements, with their default values. */
  isGiven(element: Element, attribute: string): boolean {
    const value = element.getAttribute(attribute);
    return value !== null && this.#defaults.get(element)?.get(attribute) !== value;
  }

  /** Take all out of the scene and leave the elements as x3dom found them, so that they can be used again. */
  dispose(): void {
    this.#observer.disconnect();
    for (const element of [...this.#grafted]) this.#ungraft(element);
  }

  #followChildren(records: readonly MutationRecord[]): void {
    for (const record of records) {
      for (const node of record.removedNodes) if (this.#grafted.has(node as X3dOwned)) this.#ungraft(node as X3dOwned);
      for (const node of record.addedNodes) if (node.parentNode === this.host) this.#graft(node);
    }
  }

  #graft(node: Node): void {
    if (!this.x3dom.isX3DElement(node)) return;
    const element = node as X3dOwned;
    const scene = this.document._scene;
    const tree = [element, ...element.querySelectorAll('*')];
    const given = tree.map((owned) => new Set(owned.getAttributeNames()));
    const x3dNode = scene._nameSpace.setupTree(element);
    tree.forEach((owned, i) => {
      const added = owned.getAttributeNames().filter((name) => !given[i].has(name));
      this.#defaults.set(owned, new Map(added.map((name) => [name, owned.getAttribute(name)!])));
    });
    this.#grafted.add(element);
    if (x3dNode) scene.addChild(x3dNode);
    scene.nodeChanged();
    this.document.mutationObserver.observe(element, {
      attributes: true,
      attributeOldValue: true,
      childList: true,
      subtree: true,
    });
    if (this.viewpoint && this.viewpoint === x3dNode) this.viewpoint.bind(true);
    this.document.needRender = true;
  }

  #ungraft(element: X3dOwned): void {
    this.#grafted.delete(element);
    const scene = this.document._scene;
    if (element._x3domNode) {
      scene.removeChild(element._x3domNode);
      scene.nodeChanged();
    }
    const tree: X3dOwned[] = [element, ...element.querySelectorAll('*')];
    const fields = tree.map((owned) => Object.keys(owned._x3domNode?._vf ?? {}));
    this.document.removeX3DOMBackendGraph(element);
    for (const [i, owned] of tree.entries()) {
      forget(owned, fields[i]);
      const defaults = this.#defaults.get(owned)?.keys() ?? [];
      for (const name of defaults) if (!this.isGiven(owned, name)) owned.removeAttribute(name);
    }
    scene.updateVolume();
    this.document.needRender = true;
  }
}

/** Members that x3dom puts over an element's own, besides an accessor for each field. */
const overridden = [
  '_x3domNode',
  ...['requestFieldRef', 'releaseFieldRef', 'getFieldValue', 'setFieldValue', 'highlight'],
  ...['addEventListener', 'removeEventListener', '__addEventListener', '__removeEventListener'],
  ...['setAttribute', 'getAttribute', 'hasAttribute', '__setAttribute', '__getAttribute', '__hasAttribute'],
];

function forget(element: Element, fields: readonly string[]): void {
  for (const name of [...overridden, ...fields, ...fields.map((field) => field.toLowerCase())]) {
    if (Object.hasOwn(element, name)) Reflect.deleteProperty(element, name);
  }
}
