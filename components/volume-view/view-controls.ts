import { html, nothing } from 'lit';
import { listStandardViews } from '../../src/viewer/camera/standard-views.ts';
import type { StandardView } from '../../src/viewer/camera/standard-views.ts';
import { zoomFrom } from '../../src/viewer/camera/camera-moves.ts';
import type { Viewer } from '../../src/viewer/view/viewer.ts';
import { english } from '../../src/messages/english-controls.ts';
import type { ControlMessages } from '../../src/messages/messages.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { readControls } from '../../src/viewer/model/settings.ts';
import { LazyPart } from '../internal/lazy-part.ts';
import { findCompanion } from '../internal/find-companion.ts';
import type * as MarkerPart from './orientation-marker.ts';
import { renderBar, renderCopied, renderHelp, renderHint, renderMore, renderViews } from './view-controls-parts.ts';
import type { Act, ControlName } from './view-controls-parts.ts';
import { styles as markerStyles } from './orientation-marker-styles.ts';
import { styles } from './view-controls-styles.ts';
import type { ControlledView } from '../internal/controlled-view.ts';

/** The panel that is open above the bar. */
type Panel = 'views' | 'more' | 'help' | 'copied' | 'failed';

/** The attributes of the appearance that a person can change. */
const edited = ['transfer-function', 'transfer-function-2d', 'opacity-factor', 'light-factor', 'shading'];

/** The factor by which one press of a zoom button changes the distance. */
const zoomPerPress = 1.25;

/** Servers refuse longer addresses, and so do the programs into which people paste them. */
const longestSource = 8000;

/** The hint is shown until a person has turned a view in this page. */
let isHintNeeded = true;

/**
 * The controls over a picture. The element draws them as a part of itself. The code is loaded when an element has `controls`, or one of the
 * attributes that need a part of them: `auto-rotate`, which a person has to be able to stop, `orientation-marker`, or `authoring`.
 */
export class ViewControls {
  readonly #locale: LocaleController<ControlMessages>;
  readonly #abort = new AbortController();
  #panel: Panel | null = null;
  /** The contents of the open panel: a sentence, and a text that a person may copy by hand. */
  #message = { sentence: '', text: '' };
  #marker: typeof MarkerPart | null = null;
  readonly #authoring: LazyPart;

  /** @param hand - the viewer whose camera the buttons move; null while there is no picture */
  constructor(
    readonly view: ControlledView,
    readonly hand: () => Pick<Viewer, 'resetCamera' | 'turnTo' | 'invalidate' | 'rig'> | null,
  ) {
    this.#locale = new LocaleController(view, english);
    this.#authoring = new LazyPart(view, async () => new (await import('./view-authoring.ts')).ViewAuthoring(view));
    view.addController(this);
    const root = view.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, ...sheets];
    const { signal } = this.#abort;
    view.addEventListener('camera-change', () => this.#endHint(), { signal });
    document.addEventListener('fullscreenchange', () => view.requestUpdate(), { signal });
    void customElements.whenDefined('volume-timeline').then(() => view.requestUpdate()); // The timeline has a play button, too.
    // A press anywhere else closes the panel, as with menus.
    document.addEventListener(
      'pointerdown',
      (event) => {
        if (this.#panel && !event.composedPath().some((part) => part instanceof Element && part.matches('.controls')))
          this.#open(null);
      },
      { signal, capture: true },
    );
  }

  /** Called when the attribute has been removed. */
  dispose(): void {
    this.#abort.abort();
    this.#authoring.follow(false);
    this.view.removeController(this);
    const root = this.view.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((sheet) => !sheets.includes(sheet));
    this.view.removeController(this.#locale);
  }

  hostUpdated(): void {
    this.#authoring.follow(this.view.authoring);
  }

  render(): unknown {
    return html`${this.#renderMarker()}${this.#authoring.render()}${this.view.controls || (this.view.autoRotate && this.#has('rotate')) ? this.#renderControls() : nothing}`;
  }

  #renderMarker(): unknown {
    const { orientationMarker, volume, camera } = this.view;
    if (!orientationMarker || !volume || !camera) return nothing;
    if (this.#marker) return this.#marker.renderMarker(volume, camera, this.#locale.messages, this.#turn);
    void import('./orientation-marker.ts').then((part) => {
      this.#marker = part;
      this.view.requestUpdate();
    }, console.warn);
    return nothing;
  }

  readonly #turn = ({ theta, phi }: StandardView): void => {
    this.hand()?.turnTo(theta, phi);
    this.#endHint();
  };

  #has(name: ControlName): boolean {
    if (this.#left.has(`no${name}`)) return false;
    if (!this.view.controls) return name === 'rotate';
    if (name === 'link') return this.view.linkState && this.view.id !== '';
    return name !== 'embed' || isEmbeddable(this.view);
  }

  #renderControls(): unknown {
    const { view } = this;
    const { messages } = this.#locale;
    const has = (name: ControlName): boolean => this.#has(name);
    const isPlayable = has('play') && view.times.length > 1 && !findCompanion(view, 'volume-timeline');
    const isLong = isPlayable || view.autoRotate;
    const hint = isHintNeeded && this.#panel === null && has('hint') && readControls(view.interaction);
    return html`<div class="controls ${isLong ? 'long' : ''} ${hint ? 'hinted' : ''}" part="controls" role="group" aria-label=${messages.controls} @keydown=${this.#onKey}>
      ${this.#renderPanel(messages, has)}
      <div class="row">
        ${hint ? renderHint(messages) : nothing}
        ${renderBar(
          messages,
          {
            open: this.#panel,
            playing: isPlayable ? !view.paused : null,
            rotating: view.autoRotate && has('rotate') ? !socketOf(view).last('rotation')?.stopped : null,
            isFull: isFullscreen(view),
            has: (name) => has(name) && (name !== 'fullscreen' || document.fullscreenEnabled),
          },
          this.#act,
        )}
      </div>
    </div>`;
  }

  get #left(): ReadonlySet<string> {
    return new Set(this.view.controlslist?.toLowerCase().split(/\s+/));
  }

  #renderPanel(messages: ControlMessages, has: (name: ControlName) => boolean): unknown {
    switch (this.#panel) {
      case 'views':
        return renderViews(messages, listStandardViews(this.view.volume ?? {}), this.#turn);
      case 'more':
        return renderMore(messages, has, this.#act);
      case 'help':
        return renderHelp(messages);
      case 'copied':
        return renderCopied(this.#message);
      case 'failed':
        return html`<div class="panel" part="controls-panel" role="alert"><p>${this.#message.sentence}</p></div>`;
      case null:
        return nothing;
    }
  }

  readonly #act: Act = (action) => {
    switch (action) {
      case 'views':
      case 'more':
      case 'help':
        return this.#open(this.#panel === action ? null : action);
      case 'play':
        if (this.view.paused) this.view.play().catch(() => undefined); // The view itself shows the error.
        else this.view.pause();
        return;
      case 'rotate':
        return socketOf(this.view).last('rotation')?.toggle();
      case 'zoomin':
      case 'zoomout':
        return this.#zoom(action === 'zoomin' ? 1 / zoomPerPress : zoomPerPress);
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
      case 'link':
        return void this.#copyLink();
      case 'embed':
        return void this.#embed();
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

  #zoom(factor: number): void {
    const hand = this.hand();
    if (!hand) return;
    zoomFrom(hand.rig, factor, [0, 0]);
    hand.invalidate();
  }

  #fail(sentence: string): void {
    this.#message = { sentence, text: '' };
    this.#open('failed');
  }

  async #save(): Promise<void> {
    try {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(await this.view.toBlob());
      link.download = `${nameOfPicture(this.view)}.png`;
      link.click();
      // By then the browser has finished with the link.
      setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
      this.#open(null);
    } catch {
      this.#fail(this.#locale.messages.saveFailed);
    }
  }

  async #copy(): Promise<void> {
    const { view } = this;
    const { cameraOrbit, cameraTarget } = view;
    const text = Object.entries({
      ...(cameraOrbit && { 'camera-orbit': cameraOrbit }),
      ...(cameraTarget && { 'camera-target': cameraTarget.join(' ') }),
      ...Object.fromEntries(
        ['field-of-view', ...edited].flatMap((name) => {
          const given = view.getAttribute(name);
          return given === null ? [] : [[name, given]];
        }),
      ),
      ...view.getView(),
    })
      .map(([name, value]) => `${name}="${value}"`)
      .join(' ');
    const { copied, copyByHand } = this.#locale.messages;
    await this.#offer(text, copied, copyByHand);
  }

  async #copyLink(): Promise<void> {
    const { copiedLink, copyLinkByHand, linkFailed } = this.#locale.messages;
    const link = await this.view.getLink().catch(() => null);
    if (link === null) this.#fail(linkFailed);
    else await this.#offer(link, copiedLink, copyLinkByHand);
  }

  async #embed(): Promise<void> {
    const { copiedEmbed, copyEmbedByHand, embedMissing, embedFailed } = this.#locale.messages;
    const written = await import('./embed-code.ts')
      .then(({ writeEmbedCode }) => writeEmbedCode(this.view, this.#locale.lang()))
      .catch(() => null);
    if (!written) this.#fail(embedFailed);
    else if ('missing' in written) this.#fail(embedMissing(written.missing));
    else await this.#offer(written.code, copiedEmbed, copyEmbedByHand);
  }

  /** Copy a text to the clipboard; if the page may not do so, show a field from which a person copies it. */
  async #offer(text: string, copied: string, byHand: string): Promise<void> {
    const isCopied = await Promise.resolve()
      .then(() => navigator.clipboard.writeText(text))
      .then(
        () => true,
        () => false,
      );
    this.#message = isCopied ? { sentence: copied, text: '' } : { sentence: byHand, text };
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

const sheets = [styles.styleSheet!, markerStyles.styleSheet!];

/** Whether another page can load the source of a view. It can't load files on a person's own computer. */
function isEmbeddable({ src, files }: ControlledView): boolean {
  return (
    location.protocol !== 'file:' &&
    files === null &&
    src !== null &&
    src.trim() !== '' &&
    src.length < longestSource &&
    !/(^|\s)(blob|file):/i.test(src)
  );
}

function isFullscreen(view: ControlledView): boolean {
  const root = view.getRootNode();
  return (root instanceof ShadowRoot ? root : document).fullscreenElement === view;
}

/** An iframe without the permission refuses; then the button is hidden, or a press has no effect. */
async function toggleFullscreen(view: ControlledView): Promise<void> {
  await (isFullscreen(view) ? document.exitFullscreen() : view.requestFullscreen()).catch(() => undefined);
}

/** The name of a file without its extension, with characters that all systems allow. */
function nameOfPicture({ src, files }: ControlledView): string {
  const path = (files ? '' : (src ?? ''))
    .trim()
    .split(/\s+/)[0]
    .replace(/[?#].*$/, '');
  const name = path.startsWith('data:') || path.startsWith('blob:') ? '' : path.slice(path.lastIndexOf('/') + 1);
  return (
    name
      .replace(/\.[^.]*$/, '')
      .replace(/[^\w.-]+/g, '-')
      .slice(0, 60) || 'volume'
  );
}
