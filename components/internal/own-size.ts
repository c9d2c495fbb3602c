/** The attributes `width` and `height`, as on an image: the size of the element where the CSS of the page sets none. */
export class OwnSize {
  #sheet: CSSStyleSheet | null = null;
  #looked = false;

  /** Apply the two attributes. @param width - text of the attribute: pixels, or a percentage; invalid lengths are ignored */
  set(root: ShadowRoot, width: string | null, height: string | null): void {
    const text = writeSize(readLength(width), readLength(height));
    if (!this.#sheet && text) {
      // We use a style sheet: the page's policy may forbid style elements, and the `style` attribute belongs to the page.
      this.#sheet = new CSSStyleSheet();
      root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    }
    this.#sheet?.replaceSync(`:host{${text}}`);
    if (root.isConnected && !this.#looked) warnOfInline(root.host);
    this.#looked ||= root.isConnected;
  }
}

/** An inline element has no width and no height that a picture could take. */
function warnOfInline(host: Element): void {
  if (getComputedStyle(host).display === 'inline')
    console.warn(
      '<volume-view>: the CSS of the page makes it display: inline, a box without a size; write display: block or inline-block.',
    );
}

/** Read a length as images do: ignore what follows the number, except a percent sign. */
function readLength(text: string | null): string | null {
  const [, number, percent] = /^\s*(\d*\.?\d+)(%?)/.exec(text ?? '') ?? [];
  return Number(number) > 0 ? number + (percent || 'px') : null;
}

function writeSize(width: string | null, height: string | null): string {
  if (!width) return height ? `height:${height};width:fit-content;aspect-ratio:4/3` : '';
  return `width:${width};${height ? `height:${height};aspect-ratio:${parseFloat(width)}/${parseFloat(height)}` : ''}`;
}
