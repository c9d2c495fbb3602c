/** The present name of an attribute that had another name before. */
interface Renamed {
  /** Its present name. */
  readonly attribute: string;
  /** What authors should write now, where it is more than the new name. */
  readonly instead?: string;
  /** Translates the old value to the present one, where they differ. */
  readonly translate?: (text: string) => string | null;
}

/** Old names of attributes of <volume-view>. They still work. */
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

const reported = new Set<string>();

/** The present name of an attribute. An old name causes a warning, once for all elements of a page. */
export function renameAttribute(name: string): string {
  if (!Object.hasOwn(renamed, name)) return name;
  const { attribute, instead = attribute } = renamed[name];
  warnOfOldName(`the attribute ${name}`, instead);
  return attribute;
}

/** Warn the author of the page that a name is old, once for each name. */
export function warnOfOldName(old: string, now: string): void {
  if (reported.has(old)) return;
  reported.add(old);
  console.warn(`<volume-view>: ${old} is an old name; write ${now}.`);
}

/** The text of an attribute: under its present name, else under its old name. */
export function readAttribute(element: Element, name: string): string | null {
  const text = element.getAttribute(name);
  if (text !== null) return text;
  for (const [old, { attribute, translate }] of Object.entries(renamed)) {
    const oldText = attribute === name ? element.getAttribute(old) : null;
    if (oldText !== null) return translate ? translate(oldText) : oldText;
  }
  return null;
}

/** Remove the attribute under its old names, as it now has a value under its present name. */
export function removeOldAttributes(element: Element, name: string): void {
  for (const [old, { attribute }] of Object.entries(renamed)) {
    if (attribute === name) element.removeAttribute(old);
  }
}
