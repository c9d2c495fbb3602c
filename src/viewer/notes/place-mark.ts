// A place that is marked in the picture, by a question or for an author: a pin with a name, as a note has.
import type { NoteMessages } from '../../messages/note-messages.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { NoteLayer } from './note-layer.ts';
import type { NoteOwner } from './note-mark.ts';

/** What a mark shows. */
export interface MarkedPlace {
  /** In the world as it is drawn. */
  readonly at: Vector3;
  readonly label: string;
}

/** The mark is there while `show` was called last with a place. */
export class PlaceMark implements NoteOwner {
  readonly hide = 'never';
  readonly isOpen = false;
  readonly hasText = false;
  readonly around = null;
  at: Vector3 | null = null;
  label = '';
  #layer: NoteLayer | null = null;

  /** @param pressed - a person presses the mark */
  constructor(
    readonly element: HTMLElement,
    readonly readMessages: () => NoteMessages,
    readonly pressed: () => void,
  ) {}

  get messages(): NoteMessages {
    return this.readMessages();
  }

  /** @param picture - the part of the view that holds its picture @param place - null for no mark */
  show(view: HTMLElement | null, picture: Element | null, place: MarkedPlace | null): void {
    if (this.#layer && (this.#layer.view !== view || !place)) {
      this.#layer.drop(this);
      this.#layer = null;
    }
    if (!view || !picture || !place) return;
    const isSame = this.#layer !== null && place.label === this.label && String(place.at) === String(this.at);
    [this.at, this.label] = [place.at, place.label];
    this.#layer ??= NoteLayer.of(view, picture);
    if (!isSame && this.#layer.add(this)) this.#layer.changed();
  }

  toggle(): void {
    this.pressed();
  }

  pointed(): void {
    // What it belongs to stays as it is.
  }

  seen(): void {
    // It is never hidden.
  }

  numbered(): void {
    // Nothing else shows its number.
  }
}
