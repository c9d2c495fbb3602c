import { adoptStyles, supportsAdoptingStyleSheets } from 'lit';
import type { LitElement } from 'lit';

/** Give an element its styles. Sheets serve one document: one that is moved to a frame loses them, and can't have them there. */
export function wearStyles({ shadowRoot: root, constructor }: LitElement): void {
  const { elementStyles } = constructor as typeof LitElement;
  if (!root || (!supportsAdoptingStyleSheets && root.querySelector('style'))) return; // These move with the element.
  const page = root.ownerDocument;
  if (page === document || !supportsAdoptingStyleSheets) return adoptStyles(root, elementStyles);
  const Sheet = (page.defaultView as typeof globalThis | null)?.CSSStyleSheet;
  if (!Sheet) return; // A document that nobody sees.
  root.adoptedStyleSheets = elementStyles.map((style) => {
    const sheet = new Sheet();
    sheet.replaceSync('cssText' in style ? style.cssText : [...style.cssRules].map((rule) => rule.cssText).join(''));
    return sheet;
  });
}
