import { fileAttributes } from './allowed-html.ts';
import { listAddresses, type LessonNode } from './check-lesson-html.ts';
import { readAddress } from './lesson-paths.ts';

const signs: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

/** A text in HTML or XML, between tags or in an attribute. Characters that XML does not have become U+FFFD. */
export function escapeMarkup(text: string): string {
  return text
    .replace(/\p{Cc}|\p{Cs}|[\ufffe\uffff]/gu, (sign) => (/[\t\n\r\x7f-\x9f]/.test(sign) ? sign : '\ufffd'))
    .replace(/[&<>"']/g, (sign) => signs[sign]);
}

/** The text that `escapeMarkup` was given; a host may have written an apostrophe in another way. */
export const unescapeMarkup = (text: string): string =>
  text.replace(/&(?:amp|lt|gt|quot|#0?39);/g, (sign) =>
    sign === '&#039;' ? "'" : Object.keys(signs).find((one) => signs[one] === sign)!,
  );

const empty = new Set(['br', 'hr', 'img', 'wbr']);

/** How a page writes what depends on its form. */
export interface HtmlForm {
  /** The address of a file of the lesson, without its fragment. */
  readonly addressOf: (path: string) => string;
  /** Whether links open in a window of their own, so that a frame keeps the lesson. */
  readonly linksLeave: boolean;
  /** Attributes that this form leaves out. */
  readonly leftOut: readonly string[];
}

/** The HTML of nodes that were checked. */
export function writeNodes(nodes: readonly LessonNode[], form: HtmlForm): string {
  return nodes
    .map((node) => {
      if (typeof node === 'string') return escapeMarkup(node);
      const { name, attributes, children } = node;
      const written = attributes
        .filter(([attribute]) => !form.leftOut.includes(attribute))
        .map(([attribute, value]) => ` ${attribute}="${escapeMarkup(writeValue(attribute, value, form))}"`);
      const away = attributes.some(([attribute, value]) => attribute === 'href' && !value.trim().startsWith('#'));
      if (away) written.push(` rel="noopener noreferrer"${form.linksLeave ? ' target="_blank"' : ''}`);
      const begin = `<${name}${written.join('')}>`;
      return empty.has(name) ? begin : `${begin}${writeNodes(children, form)}</${name}>`;
    })
    .join('');
}

function writeValue(attribute: string, value: string, { addressOf }: HtmlForm): string {
  if (!fileAttributes.includes(attribute)) return value;
  return listAddresses(value)
    .flatMap((address) => {
      const file = readAddress(address);
      return file ? [addressOf(file.path) + file.fragment] : [];
    })
    .join(' ');
}
