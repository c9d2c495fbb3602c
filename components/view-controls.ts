import { html, nothing } from 'lit';
import { listStandardViews } from '../src/viewer/standard-views.ts';
import type { Viewer } from '../src/viewer/viewer.ts';
import { english } from '../src/words/english-controls.ts';
import type { ControlTerms } from '../src/words/terms.ts';
import { Words } from '../src/words/words.ts';
import { readControls } from '../src/viewer/settings.ts';
import { renderBar, renderCopied, renderHelp, renderHint, renderMore, renderViews } from './view-controls-parts.ts';
import type { ControlName } from './view-controls-parts.ts';
import { styles } from './view-controls-styles.ts';
import type { ControlledView } from './controlled-view.ts';

/** What is open above the bar. */
type Panel = 'views' | 'more' | 'help' | 'copied' | 'failed';

/** A hint is for those who have not yet turned anything in this page. */
let isHintNeeded = true;

/** The controls over a picture: the element draws them as a part of itself. Loaded when one has the attribute `controls`. */
export class ViewControls {
  readonly #words: Words<ControlTerms>;
  readonly #abort = new AbortController();
  #panel: Panel | null = null;
  #copied = '';

  /** @param hand - moves the camera, while there is a picture */
  constructor(readonly view: ControlledView, readonly hand: () => Pick<Viewer, 'resetCamera' | 'turnTo'> | null) {
    this.#words = new Words(view, english);
    const root = view.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, styles.styleSheet!];
    const { signal } = this.#abort;
    view.addEventListener('camera-change', () => this.#endHint(), { signal });
    document.addEventListener('fullscreenchange', () => view.requestUpdate(), { signal });
    // A press anywhere else closes what is open, as menus do.
    document.addEventListener('pointerdown', (event) => {
      if (this.#panel && !event.composedPath().some((part) => part instanceof Element && part.matches('.controls'))) this.#open(null);
    }, { signal, capture: true });
  }

  /** The attribute is gone. */
  dispose(): void {
    this.#abort.abort();
    const root = this.view.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((sheet) => sheet !== styles.styleSheet);
    this.view.removeController(this.#words);
  }

  render(): unknown {
    const { view } = this;
    const { terms } = this.#words;
    const has = (name: ControlName): boolean => !this.#left.has(`no${name}`);
    return html`<div class="controls" part="controls" role="group" aria-label=${terms.controls} @keydown=${this.#onKey}>
      ${isHintNeeded && this.#panel === null && has('hint') && readControls(view.interaction) ? renderHint(terms) : nothing}
      ${this.#renderPanel(terms, has)}
      ${renderBar(terms, {
        open: this.#panel,
        playing: has('play') && view.times.length > 1 ? !view.paused : null,
        isFull: isFullscreen(view),
        has: (name) => has(name) && (name !== 'fullscreen' || document.fullscreenEnabled),
      }, this.#act)}
    </div>`;
  }

  get #left(): ReadonlySet<string> {
    return new Set(this.view.controlslist?.toLowerCase().split(/\s+/));
  }

  #renderPanel(terms: ControlTerms, has: (name: ControlName) => boolean): unknown {
    switch (this.#panel) {
      case 'views':
        return renderViews(terms, listStandardViews(this.view.volume ?? {}), ({ theta, phi }) => {
          this.hand()?.turnTo(theta, phi);
          this.#endHint();
        });
      case 'more':
        return renderMore(terms, has, this.#act);
      case 'help':
        return renderHelp(terms);
      case 'copied':
        return renderCopied(terms, this.#copied);
      case 'failed':
        return html`<div class="panel" part="controls-panel" role="alert"><p>${terms.saveFailed}</p></div>`;
      case null:
        return nothing;
    }
  }

  readonly #act = (action: ControlName | 'more'): void => {
    switch (action) {
      case 'views':
      case 'more':
      case 'help':
        return this.#open(this.#panel === action ? null : action);
      case 'play':
        if (this.view.paused) this.view.play().catch(() => undefined); // What stands in the way, the view shows itself.
        else this.view.pause();
        return;
      case 'reset':
        this.#open(null);
        return this.hand()?.resetCamera();
      case 'fullscreen':
        this.#open(null);
        return void toggleFullscreen(this.view);
      case 'save':
        return void this.#save();
      case 'copy':
        return void this.#copy();
      case 'hint':
        return this.#endHint();
    }
  };

  #open(panel: Panel | null): void {
    this.#panel = panel;
    this.view.requestUpdate();
  }

  #endHint(): void {
    isHintNeeded = false;
    this.view.requestUpdate();
  }

  async #save(): Promise<void> {
    try {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(await this.view.toBlob());
      link.download = `${nameOfPicture(this.view)}.png`;
      link.click();
      // The browser has taken what it needs when the page next has time.
      setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
      this.#open(null);
    } catch {
      this.#open('failed');
    }
  }

  /** Into the clipboard, or, where the page may not, into a field from which a person copies it. */
  async #copy(): Promise<void> {
    const text = Object.entries(this.view.getView()).map(([name, value]) => `${name}="${value}"`).join(' ');
    const isCopied = await Promise.resolve().then(() => navigator.clipboard.writeText(text)).then(() => true, () => false);
    this.#copied = isCopied ? '' : text;
    this.#open('copied');
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || this.#panel === null) return;
    event.stopPropagation();
    const opener = this.#panel === 'views' ? 'views' : 'more';
    this.#open(null);
    (this.view.renderRoot as ShadowRoot).querySelector<HTMLElement>(`.bar [data-action="${opener}"]`)?.focus();
  };
}

function isFullscreen(view: ControlledView): boolean {
  const root = view.getRootNode();
  return (root instanceof ShadowRoot ? root : document).fullscreenElement === view;
}

/** A frame without the permission refuses; the button is then hidden, or a person sees that nothing happens. */
async function toggleFullscreen(view: ControlledView): Promise<void> {
  await (isFullscreen(view) ? document.exitFullscreen() : view.requestFullscreen()).catch(() => undefined);
}

/** A file's name without its ending, of letters that all systems take. */
function nameOfPicture({ src }: ControlledView): string {
  const path = (src ?? '').trim().split(/\s+/)[0].replace(/[?#].*$/, '');
  const name = path.startsWith('data:') || path.startsWith('blob:') ? '' : path.slice(path.lastIndexOf('/') + 1);
  return name.replace(/\.[^.]*$/, '').replace(/[^\w.-]+/g, '-').slice(0, 60) || 'volume';
}
