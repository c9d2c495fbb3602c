/** A frame that is removed does not tell what is in it, and observers would go on without end: so its window is asked. */
export function onFrameGone(element: Element, act: () => void): void {
  const frame = element.ownerDocument.defaultView;
  if (frame && frame !== window) frame.addEventListener('pagehide', () => element.ownerDocument.defaultView === frame && act(), { once: true });
}
