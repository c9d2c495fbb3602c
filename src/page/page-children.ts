// Finds the elements that an author writes between the tags of an element. Editors of web pages wrap them in paragraphs and divisions, so
// we also search in these.

/** Elements of HTML that only contain others. */
const wrappers = new Set(['p', 'div', 'span', 'section', 'article', 'figure', 'center']);

/** Whether an element has no meaning of its own: its contents are treated as if they were in its place. */
export function isWrapper({ localName }: Element): boolean {
  return wrappers.has(localName);
}

/** The element that `element` belongs to: the nearest one around it that matches. @param hosts - selector */
export function hostOf(element: Element, hosts = 'volume-view, volume-slice-view[src]'): HTMLElement | null {
  return element.parentElement?.closest<HTMLElement>(hosts) ?? null;
}

/** The elements of a name that belong to a host, at any depth, in their order. */
export function childrenOf(host: Element, name: string, hosts?: string): Element[] {
  return [...host.getElementsByTagName(name)].filter((one) => hostOf(one, hosts) === host);
}
