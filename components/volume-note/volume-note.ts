import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { asVolumeViewError, VolumeViewError } from '../../src/core/errors.ts';
import { english } from '../../src/messages/english-notes.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import type { NoteMessages } from '../../src/messages/note-messages.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { maxNotes, NoteLayer } from '../../src/viewer/notes/note-layer.ts';
import type { NoteOwner } from '../../src/viewer/notes/note-mark.ts';
import { locateNote, readNoteHide, readNotePlace } from '../../src/viewer/notes/note-place.ts';
import type { NoteHide, NotePlace } from '../../src/viewer/notes/note-place.ts';
import type { NoteSight } from '../../src/viewer/notes/see-places.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { CustomStates } from '../internal/custom-states.ts';
import { flag, number, vector } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { emit } from '../internal/volume-view-events.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { styles } from './volume-note-styles.ts';

/**
 * A note at a place of the volume: a pin, a line, and its `label` at the side of the picture. A click, a tap or Enter opens what is between
 * its tags, any HTML; a tap elsewhere or Escape closes it. A note behind other parts of the volume is dimmed, or not shown: what counts is
 * how much of the light of its place reaches the eye.
 *
 * It belongs to the `<volume-view>` around it. With `for` it may stand elsewhere in the page: then it stays there as a text with a number,
 * and text and place show which belongs to which.
 *
 * `<volume-note position="12 -40 30" label="LAD"><p>Left anterior descending artery</p></volume-note>`
 *
 * @tag volume-note
 * @slot - what the note says
 * @csspart number - outside of a view: the button with the number of the note, which marks its place in the picture
 * @cssproperty --volume-note-color - colour of its pin
 * @cssproperty --volume-note-line-color - colour of its line
 * @cssproperty --volume-note-background - background of its label
 * @cssproperty --volume-note-active-background - background of its label while it is open, or a person points at it
 * @cssproperty --volume-note-text-color - colour of its label and of the text that opens
 * @cssproperty --volume-note-text-background - background of the text that opens
 * @cssproperty --volume-note-highlight - outside of a view: background of the text whose place a person points at. In the `<volume-view>` the pin is its part `note-pin`, the line `note-line`, the label `note`, and the text that opens `note-text`
 * @fires {CustomEvent<boolean>} note-toggle - a person has opened it (true) or closed it (false); it bubbles
 * @fires {CustomEvent<ErrorDetail>} error - its attributes can't be read, or its place is not known
 */
export class VolumeNote extends ReflectingElement {
  static override readonly styles = styles;

  /** The id of the `<volume-view>`; by default the one around the note, or the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * Its place, `x y z`, in world units: for medical files mm to the patient's right, front and head; for a radar metres east, north and
   * above the antenna, before the exaggeration of heights. It may lie outside of the volume.
   */
  @property({ kind: vector }) position!: Vector3 | null;

  /** In place of `position`: the id of a label. The note is at the middle of the largest part of this label. */
  @property({ kind: number }) of!: number | null;

  /** In place of `position`, for a radar: degrees north. */
  @property({ kind: number }) latitude!: number | null;

  /** Degrees east. */
  @property({ kind: number }) longitude!: number | null;

  /**
   * With `latitude` and `longitude`: metres above sea level where the file gives the altitude of the radar, else above its antenna.
   * @default 0
   */
  @property({ kind: number }) height!: number | null;

  /** A short name. Without it the note has a number. */
  @property() label!: string | null;

  /**
   * When it is not shown: `never`, `veiled` (less than half of the light of its place reaches the eye) or `hidden` (less than 5 % does). Keys
   * reach it in any case.
   * @default hidden
   */
  @property() hide!: string | null;

  /** Whether its text is open. */
  @property({ kind: flag }) open!: boolean;

  readonly #locale = new LocaleController<NoteMessages>(this, english);
  readonly #link = new VolumeLink(this, () => this.requestUpdate(), ['load', 'optics-change', 'labels-change']);
  readonly #states = new CustomStates<'active' | 'linked'>(this);
  #layer: NoteLayer | null = null;
  #at: Vector3 | null = null;
  #hide: NoteHide = 'hidden';
  #transmittance: number | null = null;
  #number = 0;
  /** What is wrong with it, if anything. */
  #problem: VolumeViewError | null = null;
  readonly #owner: NoteOwner = ownerOf(this, {
    at: () => this.#at,
    hide: () => this.#hide,
    messages: () => this.#locale.messages,
    around: () => this.#around,
    toggle: (isOpen) => this.#toggle(isOpen),
    pointed: (isPointed) => this.#states.set('active', !this.#around && (isPointed || this.open)),
    seen: (transmittance) => (this.#transmittance = transmittance),
    numbered: (count) => {
      if (count === this.#number) return;
      this.#number = count;
      this.requestUpdate();
    },
  });

  constructor() {
    super();
    new MutationObserver(() => this.requestUpdate()).observe(this, {
      attributes: true,
      attributeFilter: ['hidden', 'style', 'class'],
      childList: true,
    });
    for (const type of ['pointerenter', 'pointerleave', 'focusin', 'focusout'] as const)
      this.addEventListener(type, () => this.#point(type === 'pointerenter' || type === 'focusin'));
  }

  /**
   * The share of the light of its place that reaches the eye, 0 to 1, measured when the camera rests; null before that, and where the place
   * is not in front of the eye.
   */
  get transmittance(): number | null {
    return this.#transmittance;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override updated(): void {
    this.#read();
    this.#show();
  }

  get #around(): HTMLElement | null {
    const { view } = this.#link;
    return view?.contains(this) ? view : null;
  }

  #read(): void {
    this.#at = null;
    try {
      this.#hide = readNoteHide(this.readText('hide'));
      this.#at = this.#locate(readNotePlace((name) => this.readText(name)));
      this.#report(null);
    } catch (thrown) {
      this.#report(asVolumeViewError(thrown, '<volume-note>'));
    }
  }

  #locate(place: NotePlace): Vector3 | null {
    const { view, volume } = this.#link;
    if (!view || !volume) return null;
    return locateNote(place, {
      volume,
      labels: socketOf(view).last('labels')?.shown ?? null,
      labelsMayCome: view.querySelector('volume-labels, segmentedvolumedata') !== null,
    });
  }

  /** Send an error to the page, unless it is the last one. */
  #report(error: VolumeViewError | null): void {
    if (error?.message === this.#problem?.message) return;
    this.#problem = error;
    if (!error) return;
    const { code, message, cause } = error;
    emit(this, 'error', { code, message, cause });
  }

  #show(): void {
    const { view } = this.#link;
    if (this.#layer && this.#layer.view !== view) this.#leave();
    const picture = view?.shadowRoot?.querySelector('.picture');
    this.#states.set('linked', view !== null && !this.#around);
    this.#states.set('active', !this.#around && this.open);
    if (!view || !picture || this.hidden) return this.#leave();
    this.#layer ??= NoteLayer.of(view, picture);
    if (this.#layer.add(this.#owner)) this.#layer.changed();
    else this.#report(tooMany());
    this.#layer.blame(this.#owner, this.#problem);
  }

  #leave(): void {
    this.#layer?.drop(this.#owner);
    this.#layer = null;
    this.#number = 0;
    this.#transmittance = null;
    this.#states.set('linked', false);
    this.#states.set('active', false);
  }

  #toggle(isOpen: boolean): void {
    if (isOpen === this.open) return;
    this.open = isOpen;
    if (isOpen && !this.#around) this.scrollIntoView({ block: 'nearest' });
    this.dispatchEvent(new CustomEvent('note-toggle', { detail: isOpen, bubbles: true }));
  }

  protected override render(): unknown {
    const name = this.label?.trim() || this.#locale.messages.note(String(this.#number));
    const button =
      this.#link.view && !this.#around && this.#number > 0
        ? html`<button type="button" part="number" aria-pressed=${String(this.open)} aria-label=${`${this.#number} ${this.#locale.messages.noteShow(name)}`} @click=${this.#onPress}>${this.#number}</button>`
        : nothing;
    return html`${button}<slot></slot>`;
  }

  readonly #onPress = (): void => this.#toggle(!this.open);

  /** In the text of a page: the place in the picture shows which text a person points at. */
  #point(isPointed: boolean): void {
    if (this.#around) return;
    this.#states.set('active', isPointed || this.open);
    this.#layer?.highlight(this.#owner, isPointed || this.open);
  }
}

function tooMany(): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    `<volume-view> got more than ${maxNotes} notes; expected at most ${maxNotes}. The others are not shown.`,
  );
}

/** What the layer of the view may know and do of a note. */
function ownerOf(
  note: VolumeNote,
  parts: Pick<NoteOwner, 'toggle' | 'pointed' | 'numbered'> & {
    readonly [name in 'at' | 'hide' | 'messages' | 'around']: () => NoteOwner[name];
  } & { readonly seen: (transmittance: number | null, sight: NoteSight) => void },
): NoteOwner {
  return {
    ...parts,
    element: note,
    get at() {
      return parts.at();
    },
    get hide() {
      return parts.hide();
    },
    get messages() {
      return parts.messages();
    },
    get around() {
      return parts.around();
    },
    get label() {
      return (note.label ?? '').trim().slice(0, 200);
    },
    get isOpen() {
      return note.open;
    },
    get hasText() {
      return note.children.length > 0 || Boolean(note.textContent?.trim());
    },
  };
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-note': VolumeNote;
  }
}
