// Author mode of notes: somebody who writes a page shows a place in the picture, and copies the tag of a note there. Loaded where a view has
// `authoring`.
import { html, nothing } from 'lit';
import { english } from '../../src/messages/english-authoring.ts';
import { english as englishNotes } from '../../src/messages/english-notes.ts';
import type { AuthoringMessages } from '../../src/messages/authoring-messages.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import type { NoteMessages } from '../../src/messages/note-messages.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { projectInView } from '../../src/viewer/camera/project-place.ts';
import type { VolumePosition } from '../../src/viewer/model/volume-pick.ts';
import { locateNote } from '../../src/viewer/notes/note-place.ts';
import type { NotePlace } from '../../src/viewer/notes/note-place.ts';
import { PlaceMark } from '../../src/viewer/notes/place-mark.ts';
import { writeNote, writeNotePlace } from '../../src/viewer/notes/write-note.ts';
import { applySheet } from '../../src/viewer/overlays/apply-sheet.ts';
import { Aim } from '../../src/viewer/picking/aim.ts';
import type { AimOwner } from '../../src/viewer/picking/aim.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { ControlledView } from '../internal/controlled-view.ts';
import type { DrawnPart } from '../internal/lazy-part.ts';
import { authoringStyles } from './view-authoring-styles.ts';

/** The longest name of a note. */
const maxName = 200;

/** A place that somebody has shown. */
interface Draft {
  readonly place: NotePlace;
  /** The label there: a note may stand in its middle. */
  readonly label: { readonly id: number; readonly name: string } | null;
}

export class ViewAuthoring implements DrawnPart, AimOwner {
  /** Clicks on the picture are for the author as long as the view has `authoring`. */
  readonly isWaiting = true;
  readonly #locale: LocaleController<AuthoringMessages & NoteMessages>;
  readonly #aim: Aim;
  readonly #mark: PlaceMark;
  readonly #picture: HTMLElement;
  readonly #abort = new AbortController();
  #draft: Draft | null = null;
  #isInMiddle = false;
  #name = '';
  /** Whether the name is the author's: that of a label goes with its place. */
  #isNamed = false;
  /** Whether the panel is at the bottom, as the place is in the upper half of the picture. */
  #isLow = false;
  #isTouched = false;
  #said = '';
  /** Whether only screen readers need what is said: others see it. */
  #isSeen = false;

  constructor(readonly element: ControlledView) {
    this.#locale = new LocaleController(element, { ...english, ...englishNotes });
    this.#picture = element.renderRoot.querySelector<HTMLElement>('.picture')!;
    this.#mark = new PlaceMark(
      element,
      () => this.#locale.messages,
      () => this.#focusOn('input'),
    );
    this.#aim = Aim.of(element, this.#picture);
    this.#aim.add(this);
    element.addController(this);
    const { signal } = this.#abort;
    element.addEventListener('pointerdown', ({ pointerType }) => (this.#isTouched = pointerType === 'touch'), {
      signal,
    });
    // Panes of slices come and go, and have another place.
    document.addEventListener('cursor-change', () => element.requestUpdate(), { signal, capture: true });
  }

  dispose(): void {
    this.#abort.abort();
    this.#aim.drop(this);
    this.#mark.show(null, null, null);
    this.element.removeController(this);
    this.element.removeController(this.#locale);
  }

  get crosshair(): string {
    return this.#locale.messages.authoringCrosshair;
  }

  get crosshairKeys(): string {
    return this.#locale.messages.authoringKeys;
  }

  describe(found: VolumePosition | null): string {
    const { messages } = this.#locale;
    if (!found) return messages.authoringNothing;
    const value = Number.isFinite(found.value)
      ? this.#locale.number(found.value, { maximumSignificantDigits: 4 })
      : (found.labelName ?? '');
    return messages.authoringUnder(this.#words(placeOf(found)), `${value} ${found.unit}`.trim());
  }

  take(found: VolumePosition | null): void {
    if (found) this.#place(placeOf(found), labelOf(found));
    else this.#say(this.#locale.messages.authoringNothing);
  }

  ended(byKey: boolean): void {
    if (byKey) this.#focusOn('.aiming');
  }

  /** Show a place. */
  #place(place: NotePlace, label: Draft['label']): void {
    this.#draft = { place, label };
    this.#isInMiddle = false;
    if (!this.#isNamed) this.#name = label?.name ?? '';
    const at = this.#locate();
    const view = socketOf(this.element).view?.viewer?.scene?.getView();
    this.#isLow = at !== null && view !== undefined && projectInView(view, at).y > 0;
    this.#say(this.#locale.messages.authoringPlaced(this.#words(place)), true);
    // On a touch screen a keyboard would cover the picture.
    if (!this.#isTouched) this.#focusOn('input');
  }

  #say(text: string, isSeen = false): void {
    [this.#said, this.#isSeen] = [text, isSeen];
    this.element.requestUpdate();
  }

  /** As the note will have it. */
  get #written(): NotePlace | null {
    const { place = null, label = null } = this.#draft ?? {};
    return label && this.#isInMiddle ? { kind: 'label', id: label.id } : place;
  }

  get #spacing(): number {
    const { volume } = socketOf(this.element);
    return volume ? finestSpacing(volume.grid) : 1;
  }

  #words(place: NotePlace): string {
    return writeNotePlace(place, this.#spacing)
      .map(([, text]) => text)
      .join(' ');
  }

  /** In the world as it is drawn; null where the present volume does not have the place. */
  #locate(): Vector3 | null {
    const socket = socketOf(this.element);
    const [place, volume] = [this.#written, socket.volume];
    if (!place || !volume) return null;
    try {
      return locateNote(place, { volume, labels: socket.last('labels')?.shown ?? null, labelsMayCome: true });
    } catch {
      return null;
    }
  }

  hostUpdated(): void {
    const at = this.#locate();
    this.#mark.show(this.element, this.#picture, at && { at, label: this.#name.trim() });
  }

  #focusOn(selector: string): void {
    void this.element.updateComplete.then(() =>
      this.element.renderRoot.querySelector<HTMLElement>(`.authoring ${selector}`)?.focus({ preventScroll: true }),
    );
  }

  render(): unknown {
    applySheet(this.element.renderRoot as ShadowRoot, authoringStyles);
    const { messages } = this.#locale;
    const cursor = socketOf(this.element).last('cursor');
    const place = this.#written;
    const aim = html`<button type="button" class="aiming" aria-label=${messages.authoringCrosshair} title=${messages.authoringCrosshair} @click=${this.#begin}>
      <svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="6"></circle><path d="M12 3v6M12 15v6M3 12h6M15 12h6"></path></svg>
    </button>`;
    const slices = cursor
      ? html`<button type="button" class="wide" @click=${() => this.#place({ kind: 'world', at: cursor }, null)}>${messages.authoringSlices}</button>`
      : nothing;
    const contents = place
      ? this.#renderDraft(place, aim)
      : html`<div class="line"><p>${messages.authoringClick}</p>${aim}</div>`;
    return html`<div class=${`authoring ${this.#isLow && place ? 'low' : ''}`} part="authoring" role="group" aria-label=${messages.authoring} @keydown=${this.#onKey}>
      ${contents}${slices}
      <p class=${this.#isSeen || !this.#said ? 'status' : 'said'} role="status">${this.#said}</p>
    </div>`;
  }

  #renderDraft(place: NotePlace, aim: unknown): unknown {
    const { messages } = this.#locale;
    const { label } = this.#draft!;
    return html`<div class="line">
        <input type="text" aria-label=${messages.authoringName} placeholder=${messages.authoringName} maxlength=${maxName} autocomplete="off" .value=${this.#name} @focus=${selectAll} @input=${this.#onName} />
        <button type="button" class="copy" @click=${this.#copy}>${messages.authoringCopy}</button>
        ${aim}
        <button type="button" aria-label=${messages.authoringRemove} title=${messages.authoringRemove} @click=${this.#remove}>
          <svg viewBox="0 0 24 24" aria-hidden="true"><path d="M6 6l12 12M18 6L6 18"></path></svg>
        </button>
      </div>
      ${
        label
          ? html`<label class="middle"><input type="checkbox" .checked=${this.#isInMiddle} @change=${this.#onMiddle} />
            <span>${messages.authoringMiddle([label.id, label.name].filter((text) => text !== '').join(', '))}</span></label>`
          : nothing
      }
      <textarea readonly rows="2" spellcheck="false" dir="ltr" aria-label=${messages.authoringTag} .value=${writeNote(place, this.#name, this.#spacing)} @focus=${selectAll}></textarea>`;
  }

  readonly #begin = (): void => this.#aim.begin(this);

  readonly #onName = ({ target }: Event): void => {
    this.#name = (target as HTMLInputElement).value;
    this.#isNamed = this.#name.trim() !== '';
    this.#say('');
  };

  readonly #onMiddle = ({ target }: Event): void => {
    this.#isInMiddle = (target as HTMLInputElement).checked;
    this.#say('');
  };

  readonly #copy = (): void => void this.#copyTag();

  async #copyTag(): Promise<void> {
    const field = this.element.renderRoot.querySelector<HTMLTextAreaElement>('.authoring textarea')!;
    const isCopied = await Promise.resolve()
      .then(() => navigator.clipboard.writeText(field.value))
      .then(
        () => true,
        () => false,
      );
    const { authoringCopied, authoringByHand } = this.#locale.messages;
    // The next note has another name.
    this.#isNamed &&= !isCopied;
    if (!isCopied) field.focus({ preventScroll: true });
    this.#say(isCopied ? authoringCopied : authoringByHand);
  }

  readonly #remove = (): void => {
    this.#draft = null;
    this.#isNamed = false;
    this.#say('');
    this.element.focus({ preventScroll: true });
  };

  readonly #onKey = (event: KeyboardEvent): void => {
    const { key, target } = event;
    if (key === 'Escape' && this.#draft) this.#remove();
    else if (key === 'Enter' && (target as Element).matches('input[type=text]') && !event.isComposing) this.#copy();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
}

/** A radar's place is on Earth, where its file says where it is. */
function placeOf({ earth, position }: VolumePosition): NotePlace {
  return earth ? { kind: 'earth', ...earth } : { kind: 'world', at: position };
}

function labelOf({ label, labelName }: VolumePosition): Draft['label'] {
  return label !== undefined && /^[+-]?\d{1,15}$/.test(label) ? { id: Number(label), name: labelName ?? '' } : null;
}

function selectAll({ target }: Event): void {
  (target as HTMLInputElement | HTMLTextAreaElement).select();
}
