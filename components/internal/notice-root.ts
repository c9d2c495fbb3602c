const listeners = new Set<(element: Element) => void>();

/** Be told of each element of ours that comes into a shadow root. */
export function onNotice(listener: (element: Element) => void): void {
  listeners.add(listener);
}

/** An element is in the page. Where it is in a shadow root, whoever looks through these may not know that one yet. */
export function noticeRoot(element: Element): void {
  if (element.getRootNode() instanceof ShadowRoot) for (const listener of listeners) listener(element);
}
