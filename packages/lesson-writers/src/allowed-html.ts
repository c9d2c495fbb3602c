import { volumeElements } from './volume-elements.ts';

// What a lesson may have: text, pictures and the elements of the package. Nothing that runs, loads from elsewhere, or changes the page around it.

/** Attributes that each element may have. */
const everywhere = 'id class lang dir title hidden slot role tabindex';

/** Elements of HTML, with attributes of their own. */
const html: Readonly<Record<string, string>> = {
  ...Object.fromEntries(
    [
      ...['h1', 'h2', 'h3', 'h4', 'h5', 'h6', 'p', 'div', 'section', 'article', 'aside', 'header', 'footer', 'main'],
      ...['hr', 'br', 'wbr', 'ul', 'dl', 'dt', 'dd', 'blockquote', 'pre', 'figure', 'figcaption', 'summary', 'span'],
      ...['em', 'strong', 'b', 'i', 'u', 's', 'small', 'sub', 'sup', 'mark', 'abbr', 'cite', 'code', 'kbd', 'samp'],
      ...['var', 'dfn', 'q', 'bdi', 'bdo', 'ruby', 'rt', 'rp', 'table', 'caption', 'thead', 'tbody', 'tfoot', 'tr'],
    ].map((name) => [name, '']),
  ),
  ol: 'start type reversed',
  li: 'value correct',
  a: 'href',
  img: 'src alt width height loading',
  time: 'datetime',
  details: 'open',
  th: 'colspan rowspan scope',
  td: 'colspan rowspan',
};

const table = new Map(
  Object.entries({ ...html, ...volumeElements }).map(([name, own]) => [
    name,
    new Set(`${everywhere} ${own}`.trim().split(/\s+/)),
  ]),
);

/** Attributes that name files, on every element. */
export const fileAttributes: readonly string[] = ['src', 'poster', 'table'];

/** Whether a lesson may have an element. */
export const isAllowedElement = (name: string): boolean => table.has(name);

/** Whether a lesson may have an attribute. */
export function isAllowedAttribute(element: string, attribute: string): boolean {
  return table.get(element)?.has(attribute) === true || /^aria-[a-z]{1,30}$/.test(attribute);
}
