import type { NoteMessages } from '../../messages/note-messages.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Pixel } from '../camera/drag-place.ts';
import { margin } from './layout-notes.ts';
import type { NoteRoom } from './layout-notes.ts';
import type { NoteHide } from './note-place.ts';
import type { NoteSight } from './see-places.ts';

/** What a mark shows: a `<volume-note>`. */
export interface NoteOwner {
  readonly element: HTMLElement;
  /** In the world as it is drawn; null while it is not known. */
  readonly at: Vector3 | null;
  /** '' for none. */
  readonly label: string;
  readonly hide: NoteHide;
  readonly isOpen: boolean;
  /** Whether it has contents that open in the picture. */
  readonly hasText: boolean;
  /** The view, where the note is between its tags; null where it is elsewhere in the page. */
  readonly around: HTMLElement | null;
  readonly messages: NoteMessages;
  /** A person opens or closes it. */
  toggle(isOpen: boolean): void;
  /** A person points at its mark, or no longer does. */
  pointed(isPointed: boolean): void;
  /** Its number among the notes of the view, from 1, or how well it is seen has changed. */
  seen(transmittance: number | null, sight: NoteSight): void;
  numbered(number: number): void;
}

/** Where a mark is over the picture. CSS pixels. */
export interface MarkPlace {
  /** null outside of the picture. */
  readonly anchor: Pixel | null;
  /** Whether the text has a place of its own. */
  readonly isPlaced: boolean;
  readonly left: number;
  readonly top: number;
  /** Width of the text. */
  readonly size: number;
  readonly room: NoteRoom;
}

/** Colours that a page may give to single notes: the property, and its name in the styles of the mark. */
const colors = [
  ['--volume-note-color', '--_color'],
  ['--volume-note-line-color', '--_line'],
  ['--volume-note-background', '--_background'],
  ['--volume-note-active-background', '--_active'],
  ['--volume-note-text-color', '--_text'],
  ['--volume-note-text-background', '--_panel'],
] as const;

/** Numbers of slots. */
let slots = 0;

/** One note over a picture: a pin, a text, a line between them, and the contents that open. */
export class NoteMark {
  readonly pin: HTMLElement;
  readonly line: SVGElement;
  readonly text: HTMLButtonElement;
  readonly panel: HTMLElement;
  readonly #number: HTMLElement;
  readonly #label: HTMLElement;
  readonly #slot = `volume-note-${++slots}`;
  /** The child of the view that is shown in the slot; null where the contents are copied. */
  #slotted: Element | null = null;
  /** The author's own `slot`. */
  #ownSlot: string | null = null;
  #sight: NoteSight = 'plain';
  #isOutside = false;
  /** Whether the text has a place over the picture: not before the first picture, and not where there is no room. */
  #hasPlace = false;
  width = 0;

  constructor(
    readonly owner: NoteOwner,
    document: Document,
  ) {
    this.pin = document.createElement('span');
    this.pin.className = 'pin';
    this.pin.setAttribute('part', 'note-pin');
    this.line = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    this.line.setAttribute('part', 'note-line');
    this.text = document.createElement('button');
    this.text.type = 'button';
    this.text.className = 'note';
    this.text.setAttribute('part', 'note');
    this.panel = document.createElement('div');
    this.panel.className = 'note-text';
    this.panel.id = this.#slot;
    this.panel.setAttribute('part', 'note-text');
    this.panel.setAttribute('role', 'group');
    this.text.setAttribute('aria-controls', this.panel.id);
    // Until the first picture it is not known where they are.
    for (const one of [this.pin, this.line]) one.classList.add('out');
    this.panel.hidden = true;
    this.#number = document.createElement('span');
    this.#number.className = 'number';
    this.#label = document.createElement('bdi');
    const toggle = (): void => this.owner.toggle(!this.owner.isOpen);
    for (const one of [this.text, this.pin]) {
      one.addEventListener('click', toggle);
      for (const type of ['pointerenter', 'pointerleave'] as const)
        one.addEventListener(type, () => this.#point(type === 'pointerenter'));
    }
    for (const type of ['focus', 'blur'] as const)
      this.text.addEventListener(type, () => this.#point(type === 'focus'));
  }

  remove(): void {
    for (const one of [this.pin, this.line, this.text, this.panel]) one.remove();
    this.#fill(null);
    this.owner.pointed(false);
  }

  /** Whether the text is not shown, unless keys reach it. */
  get isAway(): boolean {
    const { hide, isOpen } = this.owner;
    const from = { never: [], veiled: ['veiled', 'hidden'], hidden: ['hidden'] }[hide] as readonly NoteSight[];
    return !isOpen && from.includes(this.#sight);
  }

  get hasFocusInside(): boolean {
    const { activeElement } = this.text.ownerDocument;
    return this.owner.element.contains(activeElement) || this.panel.matches(':focus-within');
  }

  /**
   * Write what the note says.
   * @param number - among the notes of the view, from 1
   * @param isElsewhere - whether its text is open in a pane
   */
  write(number: number, isElsewhere = false): void {
    const { element, label, isOpen, hasText, messages, around } = this.owner;
    this.#number.textContent = this.pin.dataset.number = String(number);
    this.#label.textContent = label;
    this.text.replaceChildren(this.#number, ...(label ? [this.#label] : []));
    const name = label || messages.note(String(number));
    // Else the name is what the text shows.
    this.text.ariaLabel = label ? null : name;
    this.panel.ariaLabel = name;
    this.text.ariaExpanded = hasText && around ? String(isOpen && !isElsewhere) : null;
    this.text.ariaPressed = around ? null : String(isOpen);
    // A note in the text of the page has its text there.
    this.text.classList.toggle('linked', !around);
    this.panel.hidden = !(isOpen && hasText && around && !isElsewhere);
    this.panel.tabIndex = this.panel.hidden ? -1 : 0;
    if (this.panel.hidden) this.panel.removeAttribute('tabindex');
    const style = getComputedStyle(element);
    for (const [name, own] of colors) {
      const value = style.getPropertyValue(name).trim();
      for (const one of [this.pin, this.line, this.text, this.panel])
        if (value) one.style.setProperty(own, value);
        else one.style.removeProperty(own);
    }
    this.#fill(hasText ? around : null);
    this.owner.numbered(number);
    this.#update();
  }

  /** Show the note's own contents in the panel: its own nodes, if it is a child of the view, else copies of them. */
  #fill(view: HTMLElement | null): void {
    const { element } = this.owner;
    const wanted = view && element.parentElement === view ? element : null;
    if (wanted !== this.#slotted) {
      if (this.#slotted?.getAttribute('slot') === this.#slot) {
        if (this.#ownSlot === null) this.#slotted.removeAttribute('slot');
        else this.#slotted.setAttribute('slot', this.#ownSlot);
      }
      this.#slotted = wanted;
      if (wanted) this.#ownSlot = wanted.getAttribute('slot');
    }
    if (wanted) {
      if (wanted.getAttribute('slot') !== this.#slot) wanted.setAttribute('slot', this.#slot);
      if (!this.panel.querySelector('slot')) {
        const slot = this.panel.ownerDocument.createElement('slot');
        slot.name = this.#slot;
        this.panel.replaceChildren(slot);
      }
    } else this.panel.replaceChildren(...(view ? [...element.childNodes].map((node) => node.cloneNode(true)) : []));
  }

  measure(): void {
    this.width = this.text.offsetWidth;
  }

  setSight(transmittance: number | null, sight: NoteSight): void {
    if (sight !== this.#sight) {
      this.#sight = sight;
      this.#update();
    }
    this.owner.seen(transmittance, sight);
  }

  setActive(isActive: boolean): void {
    for (const one of [this.pin, this.line, this.text]) one.classList.toggle('active', isActive);
  }

  #point(isPointed: boolean): void {
    this.setActive(isPointed || this.owner.isOpen);
    this.owner.pointed(isPointed);
  }

  #update(): void {
    const { messages, isOpen } = this.owner;
    const isAway = this.isAway;
    for (const one of [this.pin, this.line, this.text]) {
      one.dataset.sight = this.#sight;
      one.classList.toggle('away', isAway);
    }
    this.text.classList.toggle('away', isAway || !this.#hasPlace);
    this.text.ariaDescription = this.#isOutside
      ? messages.noteOutside
      : this.#sight === 'hidden'
        ? messages.noteBehind
        : null;
    if (isOpen) this.setActive(true);
    else if (!this.text.matches(':hover, :focus')) this.setActive(false);
  }

  show({ anchor, isPlaced, left, top, size, room }: MarkPlace): void {
    const isOutside = anchor === null;
    if (isOutside !== this.#isOutside) {
      this.#isOutside = isOutside;
      this.#update();
    }
    this.#hasPlace = isPlaced || this.owner.isOpen;
    this.pin.classList.toggle('out', isOutside);
    this.line.classList.toggle('out', isOutside || !isPlaced);
    this.text.classList.toggle('away', this.isAway || !this.#hasPlace);
    this.text.style.transform = `translate(${left.toFixed(2)}px, ${top.toFixed(2)}px)`;
    if (anchor) {
      this.pin.style.left = `${((100 * anchor[0]) / room.width).toFixed(3)}%`;
      this.pin.style.top = `${((100 * anchor[1]) / room.height).toFixed(3)}%`;
      const [x, y] = startOfLine(anchor, { left, top, size, line: room.line });
      this.line.setAttribute('d', `M${x.toFixed(1)} ${y.toFixed(1)}L${anchor[0].toFixed(1)} ${anchor[1].toFixed(1)}`);
    }
    if (!this.panel.hidden) this.#placePanel(left, top, size, room);
  }

  /** Below the text where there is room, else above it. */
  #placePanel(left: number, top: number, size: number, { width, height, line }: NoteRoom): void {
    const { offsetWidth, offsetHeight } = this.panel;
    const x = left + size / 2 > width / 2 ? left + size - offsetWidth : left;
    const below = top + line + 4;
    const y = below + offsetHeight + margin <= height ? below : top - 4 - offsetHeight;
    const clamp = (at: number, length: number, side: number): number =>
      Math.max(margin, Math.min(side - margin - length, at));
    this.panel.style.transform = `translate(${clamp(x, offsetWidth, width).toFixed(1)}px, ${clamp(y, offsetHeight, height).toFixed(1)}px)`;
  }
}

/** Where the line leaves a text: at its side, or at its upper or lower edge where the pin is above or below it. */
function startOfLine(
  [x, y]: Pixel,
  {
    left,
    top,
    size,
    line,
  }: { readonly left: number; readonly top: number; readonly size: number; readonly line: number },
): Pixel {
  const [from, to] = [left + line / 2, left + size - line / 2];
  if (x > from && x < to) return [x, y < top + line / 2 ? top : top + line];
  return [x > left + size / 2 ? left + size : left, top + line / 2];
}
