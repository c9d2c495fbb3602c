import { isWrapper } from '../page/page-children.ts';
import { meantChildren, meantParent, swallowedBy } from '../page/unclosed.ts';

/**
 * X3D's volume nodes, the frame of a scene, wrappers that a page editor adds, and the groups around a volume are read
 * apart from the scene. They may hold other elements, because a page has a whole scene or did not close a tag. Those
 * are treated as if they stood next to them.
 */
const isOpen = (element: Element): boolean =>
  isWrapper(element) || /volume(style|data)$|^(x3d|scene)$/i.test(element.localName);

/** What belongs to a volume node itself. */
const isPart = (element: Element): boolean =>
  /^material$|texture/i.test(element.localName) && /volume/i.test(meantParent(element)?.localName ?? '');

/** The outermost elements that an author has put into a scene. */
export function authorChildren(host: Element): Element[] {
  return outermostOf(meantChildren(host));
}

function outermostOf(elements: readonly Element[]): Element[] {
  return elements.flatMap((one) => (isOpen(one) ? authorChildren(one) : isPart(one) ? [] : [one]));
}

/** Whether an element's children are outermost in the scene of a host. */
export function isAround(element: Element, host: Element): boolean {
  let one: Element | null = element;
  while (one && one !== host && isOpen(one)) one = meantParent(one);
  return one === host;
}

/** An element, or its outermost children if it is only a frame. */
export function withoutFrame(element: Element): Element[] {
  return outermostOf([element, ...swallowedBy(element)]);
}
