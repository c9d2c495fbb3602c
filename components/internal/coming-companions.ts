/** Companions whose code is on its way, by name: see companions.ts. */
export const coming = new Map<string, Promise<unknown>>();

/** Resolves when a companion in an element is there, or did not come; null where none is on its way. */
export function companionComing(host: Element): Promise<unknown> | null {
  return [...host.querySelectorAll(':not(:defined)')].map(({ localName }) => coming.get(localName)).find(Boolean) ?? null;
}
