/** Attributes of `<volume-view>` by their old names, and what they are called now. */
export const oldAttributes: Readonly<Record<string, string>> = { play: 'autoplay' };

const told = new Set<string>();

/** Tell a page's author, once for each name, that one has become old. It goes on working. */
export function warnOfOldName(old: string, now: string): void {
  if (told.has(old)) return;
  told.add(old);
  console.warn(`volume-view: ${old} is an old spelling; use ${now} instead.`);
}
