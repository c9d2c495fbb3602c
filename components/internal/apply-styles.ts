import { adoptStyles, supportsAdoptingStyleSheets } from 'lit';
import type { LitElement } from 'lit';

/**
 * Apply the styles of an element again. A style sheet works in one document only: an element that is moved to an iframe loses its sheets,
 * and can't use them there.
 */
export function applyStyles({ shadowRoot: root, constructor }: LitElement): void {
  const { elementStyles } = constructor as typeof LitElement;
  if (!root || (!supportsAdoptingStyleSheets && root.querySelector('style'))) return; // Style elements move with the element.
  const page = root.ownerDocument;
  if (page === document || !supportsAdoptingStyleSheets) return adoptStyles(root, elementStyles);
  const Sheet = (page.defaultView as typeof globalThis | null)?.CSSStyleSheet;
  if (!Sheet) return; // A document that is not displayed.
  root.adoptedStyleSheets = elementStyles.map((style) => {
    const sheet = new Sheet();
    sheet.replaceSync('cssText' in style ? style.cssText : [...style.cssRules].map((rule) => rule.cssText).join(''));
    return sheet;
  });
}
