/** The attributes `width` and `height`, as an image has them: the size of the element, where the page's CSS says none. */
export class OwnSize {
  #sheet: CSSStyleSheet | null = null;

  /** @param width - the attribute's text: pixels, or a percentage; what is no length is left out */
  set(root: ShadowRoot, width: string | null, height: string | null): void {
    const text = writeSize(readLength(width), readLength(height));
    if (!this.#sheet && text) {
      // A sheet, as a page's policy may forbid style elements, and the element's own style is the page's.
      this.#sheet = new CSSStyleSheet();
      root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    }
    this.#sheet?.replaceSync(`:host{${text}}`);
  }
}

/** As of an image: what follows the number is overlooked, but for the sign of a percentage. */
function readLength(text: string | null): string | null {
  const [, number, percent] = /^\s*(\d*\.?\d+)(%?)/.exec(text ?? '') ?? [];
  return Number(number) > 0 ? number + (percent || 'px') : null;
}

function writeSize(width: string | null, height: string | null): string {
  if (!width) return height ? `height:${height};width:fit-content` : '';
  return `width:${width};${height ? `height:${height};aspect-ratio:${parseFloat(width)}/${parseFloat(height)}` : ''}`;
}
