/**
 * Keeps x3dom away from an author's `<x3d>` in one of our elements. x3dom would make a scene of its own of it, with a
 * second canvas and context, and write into the author's elements. It skips elements that are marked as running.
 */
export function keepFromX3dom(host: ParentNode): void {
  for (const frame of host.querySelectorAll<Element & { hasRuntime?: boolean }>('x3d')) {
    // A page's own x3dom ran first. The properties that it set in place of attributes are not what the author wrote.
    if (frame.hasRuntime)
      for (const one of frame.querySelectorAll('*'))
        for (const name of ['getAttribute', 'setAttribute', 'hasAttribute']) Reflect.deleteProperty(one, name);
    frame.hasRuntime ??= false;
  }
}

/** Now, and again before a page's own x3dom looks for its scenes: the element's content may come after its tag. */
export function keepScenesFromX3dom(host: ParentNode): void {
  keepFromX3dom(host);
  if (document.readyState !== 'complete')
    addEventListener('load', () => keepFromX3dom(host), { capture: true, once: true });
}
