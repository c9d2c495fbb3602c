const applying = new WeakMap<ShadowRoot, Map<string, CSSStyleSheet>>();

/**
 * Give a view's shadow root the styles of a part that is loaded later. It uses a style sheet object, because a page's policy may
 * forbid style elements; each document needs its own sheet.
 */
export function applySheet(root: ShadowRoot, styles: string): void {
  const known = applying.get(root) ?? new Map<string, CSSStyleSheet>();
  applying.set(root, known);
  if (root.adoptedStyleSheets.includes(known.get(styles)!)) return;
  const { CSSStyleSheet: Sheet } = root.ownerDocument.defaultView as typeof globalThis & Window;
  const sheet = new Sheet();
  sheet.replaceSync(styles);
  root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
  known.set(styles, sheet);
}
