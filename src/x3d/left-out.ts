/** The messages for each element, for all scenes of the page: an element may be in several, one after the other. */
const reportedOf = new WeakMap<Element, Set<string>>();

/** The parts of the author's X3D that are left out of a scene. The console names each element and reason once. */
export class LeftOut {
  readonly #elements = new WeakSet<Element>();

  has(element: Element): boolean {
    return this.#elements.has(element);
  }

  /** Leaves an element out of the scene, until something in it changes. */
  without(element: Element, why: string): void {
    this.#elements.add(element);
    this.report(element, `<${element.localName}>`, why);
  }

  /** @returns whether it had been left out */
  clear(element: Element): boolean {
    return this.#elements.delete(element);
  }

  report(element: Element, what: string, why: string): void {
    const reported = reportedOf.get(element) ?? new Set<string>();
    reportedOf.set(element, reported);
    if (reported.has(what + why)) return;
    reported.add(what + why);
    const id = element.id ? ` (id "${element.id}")` : '';
    const of = what.startsWith('<') ? '' : ` of <${element.localName}>`;
    console.warn(`<volume-view>: ${what}${of}${id} was left out of the picture: ${why}.`);
  }
}
