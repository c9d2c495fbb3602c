import { linkAttributes } from './link-attributes.ts';

/** What a link says. */
export interface ViewLink {
  /** Number of the open step of the tour; null where the link has none. */
  readonly step: number | null;
  /** Texts of attributes by their names, all of `linkAttributes`. */
  readonly attributes: ReadonlyMap<string, string>;
}

/** The longest part after the `#` that is read, characters: servers and programs cut off longer addresses. */
const longestHash = 8000;

/** The longest text of an attribute, characters. */
const longestText = 4000;

/**
 * Read the part of an address from its `#` on: `#heart?step=2&camera-orbit=30deg+70deg+90`.
 * @param id - of the view
 * @returns null where the address is not for this view. What a link may not have is left out
 */
export function readLink(hash: string, id: string): ViewLink | null {
  const split = hash.indexOf('?');
  if (id === '' || split < 0 || !hash.startsWith('#') || hash.length > longestHash) return null;
  if (decode(hash.slice(1, split)) !== id) return null;
  let step: number | null = null;
  const attributes = new Map<string, string>();
  // URLSearchParams throws nothing, also where the encoding is broken.
  for (const [name, text] of new URLSearchParams(hash.slice(split + 1))) {
    if (name === 'step' && /^\d{1,4}$/.test(text)) step ??= Number(text);
    if (linkAttributes.includes(name) && text.length <= longestText && !attributes.has(name))
      attributes.set(name, text);
  }
  return { step, attributes };
}

/** Write the part of an address from its `#` on. */
export function writeLink(id: string, { step, attributes }: ViewLink): string {
  const said = [...(step === null ? [] : [['step', `${step}`] as const]), ...attributes];
  // Programs that find addresses in a text stop at a blank, and many at a bracket.
  const encode = (text: string): string =>
    encodeURIComponent(text)
      .replace(/%20/g, '+')
      .replace(/%2C/g, ',')
      .replace(/[()'!*]/g, (sign) => `%${sign.charCodeAt(0).toString(16)}`);
  return `#${encodeURIComponent(id)}?${said.map(([name, text]) => `${name}=${encode(text)}`).join('&')}`;
}

function decode(text: string): string | null {
  try {
    return decodeURIComponent(text);
  } catch {
    return null;
  }
}
