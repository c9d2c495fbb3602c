/** An attribute that had another name. */
interface Renamed {
  /** Its present name. */
  readonly attribute: string;
  /** What to write now, where it is not the same value under that name. */
  readonly instead?: string;
  /** What the old text says in the present words, where they differ. */
  readonly translate?: (text: string) => string | null;
}

/** Old names of attributes of <volume-view>. They go on working. */
const renamed: Readonly<Record<string, Renamed>> = {
  window: { attribute: 'value-window' },
  play: { attribute: 'autoplay' },
  'camera-controls': {
    attribute: 'interaction',
    instead: 'interaction="none"',
    translate: (text) => (text.trim().toLowerCase() === 'off' ? 'none' : null),
  },
};

export const oldAttributes = Object.keys(renamed);

const told = new Set<string>();

/** The present name of an attribute. An old one is told, once for all elements of a page. */
export function renameAttribute(name: string): string {
  if (!Object.hasOwn(renamed, name)) return name;
  const { attribute, instead = attribute } = renamed[name];
  warnOfOldName(`the attribute ${name}`, instead);
  return attribute;
}

/** Tell a page's author, once for each name, that one has become old. */
export function warnOfOldName(old: string, now: string): void {
  if (told.has(old)) return;
  told.add(old);
  console.warn(`<volume-view>: ${old} is an old name; write ${now}.`);
}

/** The text of an attribute, by its present name, else by the old one. */
export function readAttribute(element: Element, name: string): string | null {
  const text = element.getAttribute(name);
  if (text !== null) return text;
  for (const [old, { attribute, translate }] of Object.entries(renamed)) {
    const oldText = attribute === name ? element.getAttribute(old) : null;
    if (oldText !== null) return translate ? translate(oldText) : oldText;
  }
  return null;
}

/** Take away what an attribute was called before, as it has a new value now. */
export function removeOldAttributes(element: Element, name: string): void {
  for (const [old, { attribute }] of Object.entries(renamed)) {
    if (attribute === name) element.removeAttribute(old);
  }
}
