/**
 * An author's `<x3d>` in one of our elements is ours: x3dom would make a scene of its own of it, with a canvas and a context beside ours,
 * and write into the author's elements. It leaves out those of which it has been told.
 */
export function keepFromX3dom(host: ParentNode): void {
  for (const frame of host.querySelectorAll<Element & { hasRuntime?: boolean }>('x3d')) {
    // A page's own x3dom was here first. What it reads and writes in place of attributes is not what the author wrote.
    if (frame.hasRuntime) for (const one of frame.querySelectorAll('*')) for (const name of ['getAttribute', 'setAttribute', 'hasAttribute']) Reflect.deleteProperty(one, name);
    frame.hasRuntime ??= false;
  }
}

/** Now, and before a page's own x3dom looks for its scenes: what is in the element may come after its tag. */
export function keepScenesFromX3dom(host: ParentNode): void {
  keepFromX3dom(host);
  if (document.readyState !== 'complete') addEventListener('load', () => keepFromX3dom(host), { capture: true, once: true });
}
