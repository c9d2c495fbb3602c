import { isWrapper } from '../page/page-children.ts';
import { meantChildren, meantParent, swallowedBy } from '../page/unclosed.ts';

/**
 * X3D's volume nodes, the frame of a scene, what an editor of pages wraps it in and the groups around a volume are read apart from the scene: what else they hold, because a page
 * has a whole scene or did not close a tag, is as if it stood beside them.
 */
const isOpen = (element: Element): boolean => isWrapper(element) || /volume(style|data)$|^(x3d|scene)$/i.test(element.localName);

/** What belongs to a volume node itself. */
const isPart = (element: Element): boolean => /^material$|texture/i.test(element.localName) && /volume/i.test(meantParent(element)?.localName ?? '');

/** The elements that an author has put into a scene, as its outermost. */
export function authorChildren(host: Element): Element[] {
  return outermostOf(meantChildren(host));
}

function outermostOf(elements: readonly Element[]): Element[] {
  return elements.flatMap((one) => (isOpen(one) ? authorChildren(one) : isPart(one) ? [] : [one]));
}

/** Whether what is in an element is outermost in the scene of a host. */
export function isAround(element: Element, host: Element): boolean {
  let one: Element | null = element;
  while (one && one !== host && isOpen(one)) one = meantParent(one);
  return one === host;
}

/** An element, or what of it is outermost. */
export function withoutFrame(element: Element): Element[] {
  return outermostOf([element, ...swallowedBy(element)]);
}
