// The code of an iframe that shows a view in another page. It is loaded when a person asks for the code.
import { findX3domUrl } from '#x3dom-url';
import type { ControlledView } from '../internal/controlled-view.ts';
import { findCompanion } from '../internal/find-companion.ts';

/** Attributes that are not written to the address of the iframe: they are for scripts, or for the page around. */
const left = new Set([
  'authoring',
  'crossorigin',
  'crosshair',
  'cursor',
  'height',
  'link-state',
  'pickable',
  'poster',
  'width',
  'loading',
]);

/** Gap between the parts of the iframe, CSS pixels. */
const gap = 16;

/**
 * The code of an iframe with the present view, its attributes, and its legend and timeline.
 * @param lang - language of its texts
 * @returns `missing`: the address where the page for iframes was not found
 */
export async function writeEmbedCode(
  view: ControlledView,
  lang: string,
): Promise<{ readonly code: string } | { readonly missing: string }> {
  // The page is next to the other files of the package.
  const page = new URL('embed.html', new URL(findX3domUrl(), document.baseURI));
  const isThere = await fetch(page, { method: 'HEAD' }).then(
    ({ ok }) => ok,
    () => false,
  );
  if (!isThere) return { missing: page.href };
  const given = new Map<string, string>();
  for (const { name, value } of view.attributes) if (isOwn(view, name)) given.set(name, value);
  for (const [name, value] of Object.entries(view.getView())) if (!left.has(name)) given.set(name, value);
  given.set(
    'src',
    view
      .src!.trim()
      .split(/\s+/)
      .map((file) => new URL(file, document.baseURI).href)
      .join(' '),
  );
  if (!/^en\b/i.test(lang)) given.set('lang', lang);
  let height = view.clientHeight;
  for (const name of ['legend', 'timeline']) {
    const companion = findCompanion(view, `volume-${name}`);
    if (!companion) continue;
    given.set(name, '');
    height += companion.offsetHeight + gap;
  }
  const query = [...given]
    .map(([name, value]) => (value === '' ? name : `${name}=${encodeURIComponent(value)}`))
    .join('&');
  const attributes = {
    src: `${page.href}?${query}`,
    title: view.getAttribute('alt') ?? '',
    width: String(view.clientWidth),
    height: String(height),
    allow: 'fullscreen',
    style: 'border: 0',
  };
  return {
    code: `<iframe ${Object.entries(attributes)
      .map(([name, value]) => `${name}="${escape(value)}"`)
      .join(' ')}></iframe>`,
  };
}

/** Whether an attribute belongs to the view. Attributes of HTML, of styles and of scripts stay in the page. */
function isOwn(view: ControlledView, name: string): boolean {
  const { observedAttributes } = view.constructor as unknown as { observedAttributes: readonly string[] };
  return observedAttributes.includes(name) && !left.has(name);
}

function escape(text: string): string {
  return text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;');
}
