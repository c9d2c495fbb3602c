/** The attributes `width` and `height`, as an image has them: the size of the element, where the page's CSS says none. */
export class OwnSize {
  #sheet: CSSStyleSheet | null = null;
  #looked = false;

  /** @param width - the attribute's text: pixels, or a percentage; what is no length is left out */
  set(root: ShadowRoot, width: string | null, height: string | null): void {
    const text = writeSize(readLength(width), readLength(height));
    if (!this.#sheet && text) {
      // A sheet, as a page's policy may forbid style elements, and the element's own style is the page's.
      this.#sheet = new CSSStyleSheet();
      root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    }
    this.#sheet?.replaceSync(`:host{${text}}`);
    if (root.isConnected && !this.#looked) warnOfInline(root.host);
    this.#looked ||= root.isConnected;
  }
}

/** A line of text has no width and no height that a picture could take. */
function warnOfInline(host: Element): void {
  if (getComputedStyle(host).display === 'inline') console.warn('<volume-view>: the CSS of the page makes it display: inline, a box without a size; write display: block or inline-block.');
}

/** As of an image: what follows the number is overlooked, but for the sign of a percentage. */
function readLength(text: string | null): string | null {
  const [, number, percent] = /^\s*(\d*\.?\d+)(%?)/.exec(text ?? '') ?? [];
  return Number(number) > 0 ? number + (percent || 'px') : null;
}

function writeSize(width: string | null, height: string | null): string {
  if (!width) return height ? `height:${height};width:fit-content;aspect-ratio:4/3` : '';
  return `width:${width};${height ? `height:${height};aspect-ratio:${parseFloat(width)}/${parseFloat(height)}` : ''}`;
}
