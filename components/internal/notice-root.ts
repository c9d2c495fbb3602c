const listeners = new Set<(element: Element) => void>();

/** Call `listener` for each of our elements that is added to a shadow root. */
export function onNotice(listener: (element: Element) => void): void {
  listeners.add(listener);
}

/**
 * Call this when an element is added to the page. If it is in a shadow root, the code that watches shadow roots may not know that root yet.
 */
export function noticeRoot(element: Element): void {
  if (element.getRootNode() instanceof ShadowRoot) for (const listener of listeners) listener(element);
}
