import { css } from 'lit';
import type { ReactiveController } from 'lit';
import type { VolumeLink } from './volume-link.ts';

/** The space between a companion and the element above it. The CSS of the page overrides it. */
export const companionGap = css`
  :host {
    margin-block-start: 8px;
  }
`;

/**
 * Keeps a companion as wide as its <volume-view>, where both are in one block and the view is narrower than the block: under a
 * `<volume-view width="640">` the legend ends where the picture ends. Below a small picture it keeps 300 pixels, as less is too narrow to
 * read. In any other layout, the layout decides the width.
 */
class ViewWidth implements ReactiveController {
  readonly #resizing = new ResizeObserver(() => this.#match());
  #sheet: CSSStyleSheet | null = null;
  #view: Element | null = null;

  constructor(readonly link: VolumeLink) {}

  hostUpdated(): void {
    const { view } = this.link;
    if (view === this.#view) return;
    this.#resizing.disconnect();
    this.#view = view;
    if (view) this.#resizing.observe(view);
    this.#match();
  }

  hostDisconnected(): void {
    this.#resizing.disconnect();
    this.#view = null;
  }

  #match(): void {
    const { host, view } = this.link;
    const root = host.shadowRoot!;
    const width = view && isNarrow(view, host) ? `max(300px, ${view.offsetWidth}px)` : 'none';
    if (!this.#sheet) {
      if (width === 'none') return;
      this.#sheet = new CSSStyleSheet();
      root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    }
    this.#sheet.replaceSync(`:host{max-inline-size:${width}}`);
  }
}

/** The link of a companion that has the width of its view. */
export function withViewWidth(link: VolumeLink): VolumeLink {
  link.host.addController(new ViewWidth(link));
  return link;
}

/** Whether a view is narrower than the block that contains it and a companion. */
function isNarrow(view: HTMLElement, { parentElement }: Element): boolean {
  if (!parentElement || view.parentElement !== parentElement) return false;
  const stacks =
    /^(block|flow-root|list-item)$/.test(getComputedStyle(parentElement).display) &&
    getComputedStyle(view).float === 'none';
  return stacks && view.offsetWidth > 0 && view.offsetWidth < parentElement.clientWidth;
}
