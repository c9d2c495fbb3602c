// Which attributes of <volume-view> the address of the page, and a message, may set. The table of all attributes is written from the code.
import { volumeElements } from '../../lesson-writers/src/volume-elements.ts';

/** Attributes that are not taken, each with its reason in words. */
export const leftAttributes: Readonly<Record<string, string>> = {
  authoring: 'it is for the author of a page, while the page is written',
  crossorigin: 'anybody can write this address, and it would send cookies to a server that they choose',
  crosshair: 'it needs panes of slices, which this page does not have',
  cursor: 'it needs panes of slices, which this page does not have',
  height: 'the frame says how high the picture is',
  'link-state': 'it reads the part after the #, which some sites use for themselves',
  width: 'the frame says how wide the picture is',
};

/** Attributes that are taken as they are. */
export const viewAttributes: ReadonlySet<string> = new Set(
  volumeElements['volume-view'].split(' ').filter((name) => !Object.hasOwn(leftAttributes, name)),
);

/** The longest text of an attribute, in characters: `src` may name many scans. */
export const longestText = 16_000;

/** @returns why the view may not have an attribute, in words; null where it may */
export function checkName(name: string): string | null {
  if (Object.hasOwn(leftAttributes, name)) return `${name} is not taken: ${leftAttributes[name]}`;
  return viewAttributes.has(name) ? null : `${quote(name)} is no attribute of <volume-view> that this page knows`;
}

/**
 * Reads an attribute and its text.
 * @param base - the address of the page, from which others count
 * @returns what is wrong, in words; null where the view may have it
 */
export function checkText(name: string, text: string, base: string): string | null {
  const problem = checkName(name);
  if (problem !== null) return problem;
  if (text.length > longestText) return `${name} has ${text.length} characters; expected at most ${longestText}`;
  if (name !== 'src' && name !== 'poster') return null;
  // A poster is one image: blanks are part of its address.
  const addresses = (name === 'poster' ? [text.trim()] : text.split(/[\t\n\f\r ]+/)).filter(Boolean);
  if (addresses.length === 0) return `${name} names no file`;
  return addresses.every((one) => isFetched(one, base))
    ? null
    : `${name} got an address that this page does not fetch; expected one that begins with https:// or http://, or counts from the folder of this page`;
}

/** Whether an address is of a server: no script, no data in the address, no file that only this page could have. */
export function isFetched(address: string, base: string): boolean {
  try {
    const { protocol, username, password } = new URL(address, base);
    const isKnown = protocol === 'https:' || protocol === 'http:' || protocol === new URL(base).protocol;
    return isKnown && username === '' && password === '';
  } catch {
    return false;
  }
}

/** A name that a stranger wrote, in a sentence: short, and on one line. */
export function quote(name: string): string {
  const plain = name.replace(/[\p{C}\p{Z}]+/gu, ' ').trim();
  return `"${plain.length > 30 ? `${plain.slice(0, 29)}…` : plain}"`;
}
