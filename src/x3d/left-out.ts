/** Of all scenes of the page, as an element may be in several, one after the other. */
const toldOf = new WeakMap<Element, Set<string>>();

/** What of the author's X3D is left out of a scene. The console says so, once for each element and reason. */
export class LeftOut {
  readonly #elements = new WeakSet<Element>();

  has(element: Element): boolean {
    return this.#elements.has(element);
  }

  /** An element is not in the scene, until something of it changes. */
  without(element: Element, why: string): void {
    this.#elements.add(element);
    this.tell(element, `<${element.localName}>`, why);
  }

  /** @returns whether it had been left out */
  forgive(element: Element): boolean {
    return this.#elements.delete(element);
  }

  tell(element: Element, what: string, why: string): void {
    const told = toldOf.get(element) ?? new Set<string>();
    toldOf.set(element, told);
    if (told.has(what + why)) return;
    told.add(what + why);
    const id = element.id ? ` (id "${element.id}")` : '';
    const of = what.startsWith('<') ? '' : ` of <${element.localName}>`;
    console.warn(`<volume-view>: ${what}${of}${id} was left out of the picture: ${why}.`);
  }
}
