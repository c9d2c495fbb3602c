import { fieldOf } from './author-allowed.ts';
import { authorChildren, isAround, withoutFrame } from './author-children.ts';
import { AuthorCopies } from './author-copies.ts';
import { explainInfinite, hasNoDirection, isFiniteField } from './finite-field.ts';
import { LeftOut } from './left-out.ts';
import { meantParent } from '../page/unclosed.ts';
import type { X3dBindable, X3dDocument, X3dNode, X3dOwned, X3dViewpoint, X3dom } from './x3dom-types.ts';
import { keepFromX3dom } from './own-scenes.ts';

/** Attributes that say which node an element is, or where it belongs. */
const identity = new Set(['def', 'use', 'id', 'containerfield']);

/**
 * The author's own X3D children. They stay in the light DOM, and copies of them join the scene, which follow when
 * elements are added, removed or changed. Elements that x3dom can't handle are left out, with a message in the console.
 */
export class AuthorNodes {
  readonly #observer: MutationObserver;
  readonly #left = new LeftOut();
  /** The element of the first viewpoint, or null; undefined before the search. */
  #viewpoint: [Element | null] | null = null;
  #bound: X3dViewpoint | null = null;
  #boundBackground: X3dBindable | null = null;
  readonly #copies = new AuthorCopies((element, what, why) => this.#left.report(element, what, why));

  constructor(
    readonly x3dom: X3dom,
    readonly document: X3dDocument,
    readonly host: Element,
  ) {
    for (const child of authorChildren(host)) this.#add(child);
    this.#observer = new MutationObserver((records) => this.#follow(records));
    this.#observer.observe(host, { childList: true, subtree: true, attributes: true });
  }

  /** The author's first viewpoint, or null. It overrides the element's camera attributes. */
  get viewpoint(): X3dViewpoint | null {
    const node = this.#viewpointElement && this.#copies.copyOf(this.#viewpointElement)?._x3domNode;
    return (node as X3dViewpoint | undefined) ?? null;
  }

  /** The scene's copy of an author's element; null if there is none. */
  nodeOf(element: Element): X3dNode | null {
    return this.#copies.copyOf(element)?._x3domNode ?? null;
  }

  /** Whether the author gave the viewpoint an attribute. */
  isGivenByViewpoint(attribute: string): boolean {
    return this.#viewpointElement?.hasAttribute(attribute) ?? false;
  }

  get #viewpointElement(): Element | null {
    this.#viewpoint ??= [
      [...this.host.querySelectorAll('*')].find(
        (e) => /viewpoint$/i.test(e.localName) && this.#copies.copyOf(e)?._x3domNode,
      ) ?? null,
    ];
    return this.#viewpoint[0];
  }

  /** Whether none of the author's elements are in the scene. */
  get isEmpty(): boolean {
    return !authorChildren(this.host).some((child) => this.#copies.copyOf(child));
  }

  /**
   * Finds the author's children that prevent the scene from being drawn, and leaves them out.
   * @param works - whether the present scene can be drawn
   * @returns whether it can be drawn now
   */
  leaveOutCulprits(works: () => boolean): boolean {
    const shown = authorChildren(this.host).filter((child) => this.#copies.copyOf(child));
    for (const child of shown) this.#remove(child, this.host);
    const isTheirs = works();
    for (const child of shown) {
      this.#add(child);
      if (!isTheirs || !this.#copies.copyOf(child) || works()) continue;
      this.#leaveOut(child, 'the scene can not be drawn with it');
      works();
    }
    return isTheirs;
  }

  /** Removes all of them from the scene. */
  dispose(): void {
    this.#observer.disconnect();
    for (const child of authorChildren(this.host)) this.#remove(child, this.host);
  }

  #follow(records: readonly MutationRecord[]): void {
    for (const { type, target, attributeName, removedNodes, addedNodes } of records) {
      if (type === 'attributes') this.#change(target as Element, attributeName!);
      for (const node of removedNodes)
        if (node.nodeType === 1)
          for (const one of [node as Element, ...withoutFrame(node as Element)])
            this.#remove(one, meantParent(node as Element, target as Element)!);
      for (const node of addedNodes)
        if (node.nodeType === 1 && node.parentNode === target)
          for (const one of withoutFrame(node as Element)) this.#add(one);
      this.#retry(target as Element);
    }
  }

  /** Adds elements that were left out again, if something in them has changed: they may be valid now. */
  #retry(changed: Element): void {
    for (let one: Element | null = changed; one && one !== this.host; one = one.parentElement) {
      if (this.#left.clear(one)) this.#add(one);
    }
  }

  #add(element: Element): void {
    keepFromX3dom(this.host);
    const parent = meantParent(element)!;
    const isOutermost = isAround(parent, this.host);
    this.#viewpoint = null;
    if (isOutermost && !this.x3dom.isX3DElement(element)) return;
    const around = isOutermost ? this.document._scene._xmlNode : this.#copies.copyOf(parent);
    if (!around || this.#copies.copyOf(element) || this.#left.has(element)) return;
    const copy = this.#copies.copy(element);
    if (!copy) return;
    if (!isOutermost) around.append(copy); // Else x3dom, which watches the scene's own elements, would add it twice.
    try {
      this.#join(copy, around, isOutermost);
      const wrong = this.#findInfinite(element);
      if (wrong) throw new RangeError(wrong);
      for (const one of [element, ...element.querySelectorAll('*')]) this.#leaveOutDark(one);
    } catch (error) {
      this.#leaveOut(element, error);
    }
    this.#bindFirst();
    this.document.needRender = true;
  }

  /** Binds the author's first viewpoint and first background, however deep they stand, if others were bound. */
  #bindFirst(): void {
    this.#viewpoint = null;
    const { viewpoint } = this;
    if (viewpoint && viewpoint !== this.#bound) viewpoint.bind(true);
    this.#bound = viewpoint;
    const background = this.#background;
    if (background && background !== this.#boundBackground) background.bind(true);
    this.#boundBackground = background;
  }

  /** The author's first background, or null: the scene's own is transparent. */
  get #background(): X3dBindable | null {
    const [first] = [...this.host.querySelectorAll('background')].flatMap((one) => this.nodeOf(one) ?? []);
    return (first as X3dBindable | undefined) ?? null;
  }

  #leaveOut(element: Element, error: unknown): void {
    this.#left.without(element, error instanceof Error ? error.message : String(error));
    this.#remove(element, meantParent(element)!);
    this.document._viewarea.resetNavHelpers(); // A viewpoint with invalid numbers leaves them there.
  }

  /** Leaves out lights without a direction: their effect in x3dom depends on the device. */
  #leaveOutDark(element: Element): void {
    const node = this.nodeOf(element);
    if (node && hasNoDirection(node))
      this.#leaveOut(
        element,
        `direction got "${(element.getAttribute('direction') ?? '').slice(0, 40)}"; expected three numbers, not all of them 0, like "0 -1 0"`,
      );
  }

  #join(copy: X3dOwned, around: X3dOwned, isOutermost: boolean): void {
    if (!isOutermost) return this.document.onNodeAdded(copy, around);
    const scene = this.document._scene;
    const node = scene._nameSpace.setupTree(copy);
    this.#viewpoint = null; // The search may have run while only a part of it was there.
    if (node) scene.addChild(node);
    scene.nodeChanged();
    scene.updateVolume();
  }

  #remove(node: Node, around: Node): void {
    const copy = this.#copies.copyOf(node);
    if (!copy) return;
    const scene = this.document._scene;
    const parent = isAround(around as Element, this.host) ? scene._xmlNode! : this.#copies.copyOf(around);
    try {
      if (parent) this.document.onNodeRemoved(copy, parent);
      else this.document.removeX3DOMBackendGraph(copy);
    } catch (error) {
      console.warn(error); // It is removed from the picture in any case.
      if (copy._x3domNode) scene.removeChild(copy._x3domNode);
    }
    copy.remove();
    this.#copies.forget(node as Element);
    this.#bindFirst();
    this.document.needRender = true;
  }

  /** Applies an attribute that was changed or removed. */
  #change(element: Element, name: string): void {
    const copy = this.#copies.copyOf(element);
    if (!copy?._x3domNode || !element.parentElement) return;
    const value = this.#copies.valueOf(element, name);
    if (value === null || identity.has(name.toLowerCase()) || copy._x3domNode._xmlNode !== copy)
      return this.#renew(element);
    copy.setAttribute(name, value);
    try {
      copy._x3domNode.updateField(name, value);
      if (!isFiniteField(copy._x3domNode, fieldOf(name))) throw new RangeError(explainInfinite(element, name));
      this.#leaveOutDark(element);
    } catch (error) {
      this.#leaveOut(element, error);
    }
    this.document.needRender = true;
  }

  #renew(element: Element): void {
    this.#remove(element, meantParent(element)!);
    this.#add(element);
  }

  /** @returns a message about a number that is not finite, or too large for a GPU; null if there is none */
  #findInfinite(element: Element): string | null {
    for (const one of [element, ...element.querySelectorAll('*')]) {
      const node = this.#copies.copyOf(one)?._x3domNode;
      const wrong = node && one.getAttributeNames().find((name) => !isFiniteField(node, fieldOf(name)));
      if (wrong) return explainInfinite(one, wrong);
    }
    return null;
  }
}
