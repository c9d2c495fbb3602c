// What an author writes between the tags of an element. Editors of web pages put it into paragraphs and divisions: it is found in them.

/** Elements of HTML that only stand around others. */
const wrappers = new Set(['p', 'div', 'span', 'section', 'article', 'figure', 'center']);

/** Whether an element says nothing of itself: what is in it is as if it stood in its place. */
export function isWrapper({ localName }: Element): boolean {
  return wrappers.has(localName);
}

/** The element that what stands in it belongs to: the nearest one around. @param hosts - selector */
export function hostOf(element: Element, hosts = 'volume-view, volume-slice-view[src]'): HTMLElement | null {
  return element.parentElement?.closest<HTMLElement>(hosts) ?? null;
}

/** The elements of a name that belong to a host, however deep they stand in it, in their order. */
export function childrenOf(host: Element, name: string, hosts?: string): Element[] {
  return [...host.getElementsByTagName(name)].filter((one) => hostOf(one, hosts) === host);
}
