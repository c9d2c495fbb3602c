import { html, nothing } from 'lit';
import type { LitElement } from 'lit';
import type { FileNotices } from '../../src/viewer/model/file-notices.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import { applySheet } from '../../src/viewer/overlays/apply-sheet.ts';
import { english } from '../../src/messages/english-notices.ts';
import type { NoticeMessages } from '../../src/messages/notice-messages.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import type { DrawnPart } from './lazy-part.ts';
import { noticeStyles } from './view-notices-styles.ts';

/** Where the notices come from. */
export interface NoticeSource {
  readonly info: Pick<VolumeInfo, 'notices' | 'reduced'> | null;
  /** Notices of additional files, by the object that shows the files. */
  readonly fileNotices: ReadonlyMap<object, readonly FileNotices[]>;
}

/** Maximum number of lines, as nobody reads more: `left` of the volume has them all. */
const maxLines = 40;

/**
 * A sign in a corner of a picture. It says that a part of a file is not in the picture, or is shown differently, and which part. The text
 * opens when the mouse is over the sign, when the sign has the keyboard focus, and when it is pressed; Escape, or a press elsewhere, closes
 * it. The code is loaded when there is a notice.
 */
export class ViewNotices implements DrawnPart {
  readonly #locale: LocaleController<NoticeMessages>;
  readonly #abort = new AbortController();
  /** The reasons why it is open. */
  readonly #open = new Set<'pointed' | 'focused' | 'pressed'>();

  constructor(
    readonly host: LitElement,
    readonly source: () => NoticeSource,
  ) {
    this.#locale = new LocaleController(host, english);
    document.addEventListener(
      'pointerdown',
      (event) => {
        if (
          this.#open.has('pressed') &&
          !event.composedPath().some((part) => part instanceof Element && part.matches('.notice'))
        )
          this.#close();
      },
      { signal: this.#abort.signal, capture: true },
    );
  }

  dispose(): void {
    this.#abort.abort();
    this.host.removeController(this.#locale);
  }

  render(): unknown {
    const lines = this.#list();
    if (lines.length === 0) return nothing;
    applySheet(this.host.renderRoot as ShadowRoot, noticeStyles);
    const { messages } = this.#locale;
    const isOpen = this.#open.size > 0;
    return html`<div class="notice" @keydown=${this.#onKey} @pointerenter=${this.#onEnter} @pointerleave=${this.#onLeave} @focusin=${this.#onFocus} @focusout=${this.#onBlur}>
      <button type="button" part="notice-sign" aria-label=${messages.notices(this.#locale.number(lines.length))} aria-expanded=${String(isOpen)} aria-controls="notices" @click=${this.#onPress}>
        <svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="9"></circle><path d="M12 11v5.5M12 7.5h.01"></path></svg>
      </button>
      <div class="told" id="notices" part="notice-text" ?hidden=${!isOpen} tabindex=${isOpen ? '0' : nothing} role="group" aria-label=${messages.noticesAre}>
        <p>${messages.noticesAre}</p>
        <ul>${lines.slice(0, maxLines).map(({ text, lang }) => html`<li lang=${lang ?? nothing}>${text}</li>`)}</ul>
      </div>
    </div>`;
  }

  /** The notices of readers are in English, as their errors are. */
  #list(): { text: string; lang?: string }[] {
    const { info, fileNotices } = this.source();
    const own = info?.notices ?? [];
    const attached = [...fileNotices.values()]
      .flat()
      .flatMap(({ name, notices }) =>
        notices.filter((notice) => !own.includes(notice)).map((notice) => (name ? `${name}: ${notice}` : notice)),
      );
    const reported = new Set([...own, ...attached]);
    const size = (axes: readonly number[]): string => axes.map((n) => this.#locale.number(n)).join(' × ');
    const smaller = info?.reduced
      ? [{ text: this.#locale.messages.madeSmaller(size(info.reduced.from), size(info.reduced.to)) }]
      : [];
    return [...smaller, ...[...reported].map((text) => ({ text, lang: 'en' }))];
  }

  readonly #onPress = (): void => (this.#open.has('pressed') ? this.#close() : this.#set('pressed', true));

  readonly #onEnter = ({ pointerType }: PointerEvent): void => this.#set('pointed', pointerType === 'mouse');

  readonly #onLeave = (): void => this.#set('pointed', false);

  readonly #onFocus = ({ target }: FocusEvent): void =>
    this.#set('focused', (target as Element).matches(':focus-visible'));

  readonly #onBlur = ({ relatedTarget, currentTarget }: FocusEvent): void => {
    if (!(currentTarget as Element).contains(relatedTarget as Node | null)) this.#set('focused', false);
  };

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || this.#open.size === 0) return;
    event.stopPropagation();
    (event.currentTarget as Element).querySelector('button')!.focus();
    this.#close();
  };

  #set(why: 'pointed' | 'focused' | 'pressed', isSo: boolean): void {
    if (isSo === this.#open.has(why)) return;
    if (isSo) this.#open.add(why);
    else this.#open.delete(why);
    this.host.requestUpdate();
  }

  #close(): void {
    this.#open.clear();
    this.host.requestUpdate();
  }
}
