import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { state } from 'lit/decorators.js';
import { english as companions } from '../../src/messages/english-companions.ts';
import { english } from '../../src/messages/english-drop.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { hasFiles, listDropped } from '../../src/page/dropped-files.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { renderSeriesChoice } from '../internal/series-choice.ts';
import { seriesChoiceStyles } from '../internal/series-choice-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';
import type { ErrorDetail } from '../internal/volume-view-events.ts';
import { styles } from './volume-drop-styles.ts';

/** Milliseconds without a sign of what is dragged, after which it is somewhere else. */
const forgetAfter = 700;

/** All elements of this kind in the page: what is pasted into no field belongs to the first one. */
const all = new Set<VolumeDrop>();

/**
 * Opens files of the reader's device in a `<volume-view>`: by a button, by dragging files or a folder onto the picture, or by pasting them.
 * It says what was read, and lists the series of a DICOM folder to choose from. The files stay on the device, and nothing is sent anywhere.
 * Where they can not be read, it says why, and the last picture stays.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-drop
 * @slot - words of your own in place of the ones about dropping; say there, too, that nothing is uploaded
 * @csspart area - the whole element, onto which files may be dropped, too
 * @csspart button - each button
 * @csspart hint - the words about dropping, or those where there is no view
 * @csspart status - what was read, or why it could not be read
 * @csspart frame - the frame over the picture while files are dragged over it
 * @csspart list - the list of series
 * @csspart row - a series
 * @csspart picture - the small picture of a series, its middle slice
 * @cssproperty --volume-drop-color - colour of the frame over the picture
 * @cssproperty --volume-series-height - maximum height of the list of series, which scrolls then; 20rem by default
 * @cssproperty --volume-series-accent - colour of the chosen series
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 */
export class VolumeDrop extends ReflectingElement {
  static override readonly styles = [companionGap, seriesChoiceStyles, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  @state() private _isOver = false;
  @state() private _status: { readonly text: string; readonly isEnglish?: boolean } | 'reading' | 'read' | null = null;

  readonly #link = withViewWidth(new VolumeLink(this, () => this.#follow()));
  readonly #locale = new LocaleController(this, { ...companions, ...english });
  #view: VolumeView | null = null;
  #forget: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.#listenForFiles(this, 'addEventListener');
  }

  override connectedCallback(): void {
    super.connectedCallback();
    all.add(this);
    this.ownerDocument.addEventListener('paste', this.#onPaste);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    all.delete(this);
    this.ownerDocument.removeEventListener('paste', this.#onPaste);
    this.#leave();
  }

  /** Keep to the view that belongs to this element. */
  #follow(): void {
    const { view } = this.#link;
    this.requestUpdate();
    if (view === this.#view) return;
    for (const [one, act] of [
      [this.#view, 'removeEventListener'],
      [view, 'addEventListener'],
    ] as const) {
      if (!one) continue;
      this.#listenForFiles(one, act);
      one[act]('load', this.#onLoad);
      one[act]('error', this.#onError as EventListener);
    }
    this.#view = view;
    this._status = null;
  }

  #listenForFiles(element: HTMLElement, act: 'addEventListener' | 'removeEventListener'): void {
    for (const type of ['dragenter', 'dragover'] as const) element[act](type, this.#onDrag as EventListener);
    element[act]('dragleave', this.#onLeave as EventListener);
    element[act]('drop', this.#onDrop as EventListener);
  }

  readonly #onDrag = (event: DragEvent): void => {
    if (!hasFiles(event.dataTransfer)) return;
    event.preventDefault(); // Else the browser leaves the page to show the file.
    event.dataTransfer!.dropEffect = this.#view ? 'copy' : 'none';
    if (!this.#view) return;
    this._isOver = true;
    clearTimeout(this.#forget);
    this.#forget = setTimeout(() => this.#leave(), forgetAfter);
  };

  readonly #onLeave = ({ relatedTarget, currentTarget }: DragEvent): void => {
    // Some browsers don't say where it goes; then the time without a sign ends it.
    if (relatedTarget instanceof Node && !(currentTarget as Node).contains(relatedTarget)) this.#leave();
  };

  readonly #onDrop = (event: DragEvent): void => {
    this.#leave();
    if (!hasFiles(event.dataTransfer) || event.defaultPrevented) return;
    event.preventDefault();
    if (this.#view) void this.#take(event.dataTransfer!);
  };

  readonly #onPaste = (event: ClipboardEvent): void => {
    const data = event.clipboardData;
    if (!this.#view || event.defaultPrevented || !data || data.files.length === 0) return;
    const path = event.composedPath();
    const isMine = path.includes(this) || path.includes(this.#view);
    const isNobodys = path[0] === this.ownerDocument.body || path[0] === this.ownerDocument.documentElement;
    if (!isMine && !(isNobodys && [...all][0] === this)) return;
    event.preventDefault();
    void this.#take(data);
  };

  #leave(): void {
    clearTimeout(this.#forget);
    this._isOver = false;
  }

  async #take(data: DataTransfer): Promise<void> {
    try {
      this.#open(await listDropped(data));
    } catch {
      this._status = { text: this.#locale.messages.dropEmpty }; // A folder that the browser may not read.
    }
  }

  #open(files: readonly File[] | FileList): void {
    if (!this.#view) return;
    if (files.length === 0) {
      this._status = { text: this.#locale.messages.dropEmpty };
      return;
    }
    this._status = 'reading';
    this.#view.series = null;
    this.#view.files = files;
  }

  readonly #onLoad = (): void => {
    this._status = this.#view?.files ? 'read' : null;
  };

  readonly #onError = ({ detail }: CustomEvent<ErrorDetail>): void => {
    if (this._status === 'reading') this._status = { text: detail.message, isEnglish: true };
  };

  /** The dialog of the browser in which a person chooses. */
  #ask(isFolder: boolean): void {
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    input.webkitdirectory = isFolder;
    input.addEventListener('change', () => input.files && this.#open(input.files));
    input.click();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override updated(): void {
    const frame = this.renderRoot.querySelector<HTMLElement>('.frame');
    if (!frame || !this.#view) return;
    const { left, top, width, height } = this.#view.getBoundingClientRect();
    Object.assign(frame.style, {
      left: `${left}px`,
      top: `${top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
    if (!frame.matches(':popover-open')) frame.showPopover();
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    const view = this.#view;
    if (!view)
      return html`<p class="hint" part="hint"><span dir="auto">${this.#link.describeLack(messages)}</span></p>`;
    return html`<div class=${this._isOver ? 'drop over' : 'drop'} part="area">
      <div class="buttons">
        <button type="button" part="button" @click=${() => this.#ask(false)}>${messages.openFiles}</button>
        <button type="button" part="button" @click=${() => this.#ask(true)}>${messages.openFolder}</button>
      </div>
      <p part="hint"><slot>${messages.dropHint}</slot></p>
      <p class="status" part="status" role="status">${this.#renderStatus()}</p>
      ${renderSeriesChoice(view, messages, (...value) => this.#locale.number(...value))}
      ${this._isOver ? html`<div class="frame" part="frame" popover="manual">${messages.dropHere}</div>` : nothing}
    </div>`;
  }

  #renderStatus(): unknown {
    const { messages } = this.#locale;
    const status = this._status;
    if (status === null) return nothing;
    if (status === 'reading') return messages.dropReading;
    if (status !== 'read')
      return status.isEnglish ? html`<span lang="en" dir="ltr">${status.text}</span>` : status.text;
    const { volume } = this.#view!;
    if (!volume) return nothing;
    const number = (value: number): string => this.#locale.number(value);
    return messages.dropRead(
      volume.format,
      volume.dimensions.map(number).join(' × '),
      number(volume.source?.count ?? 1),
    );
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-drop': VolumeDrop;
  }
}
