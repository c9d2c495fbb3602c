/** Companions whose code is being loaded, by tag name: see companions.ts. */
export const coming = new Map<string, Promise<unknown>>();

/** Resolves when the code of a companion inside `host` has loaded or has failed to load; null where none is being loaded. */
export function companionComing(host: Element): Promise<unknown> | null {
  return (
    [...host.querySelectorAll(':not(:defined)')].map(({ localName }) => coming.get(localName)).find(Boolean) ?? null
  );
}
