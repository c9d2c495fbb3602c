/** When an iframe is removed, its elements are not notified, and observers would run forever. So we listen to the window of the frame. */
export function onFrameGone(element: Element, act: () => void): void {
  const frame = element.ownerDocument.defaultView;
  if (frame && frame !== window)
    frame.addEventListener('pagehide', () => element.ownerDocument.defaultView === frame && act(), { once: true });
}
