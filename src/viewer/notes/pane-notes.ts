// The notes of a view in one pane of a slice: a button at each place in the slice, a faint pin near it, and the text that opens.
import type { SlicePane } from '../../panes/slice-pane.ts';
import { margin } from './layout-notes.ts';
import type { NoteOwner } from './note-mark.ts';
import { paneNoteStyles } from './pane-note-styles.ts';
import { placeInPane, placeNames } from './place-in-pane.ts';

/** Height of a name, and width and height of a pin, CSS pixels: as in the styles. */
const [line, pinSize] = [20, 10];

/** A note in a pane. */
interface PaneMark {
  readonly pin: HTMLButtonElement;
  readonly name: HTMLElement;
  width: number;
}

/** What a pane's notes need of the layer. */
export interface PaneNotesHost {
  /** The notes in the order of the page. */
  readonly owners: readonly NoteOwner[];
  /** A person opens or closes a note in this pane. */
  toggle(owner: NoteOwner): void;
  /** A person points at a note in this pane, or no longer does. */
  point(owner: NoteOwner, isPointed: boolean): void;
}

export class PaneNotes {
  readonly #element: HTMLElement;
  readonly #panel: HTMLElement;
  readonly #sheet: CSSStyleSheet;
  readonly #marks = new Map<NoteOwner, PaneMark>();
  /** The note whose text is open here. */
  #opened: NoteOwner | null = null;

  /** @param picture - of the pane, in its shadow root */
  constructor(
    readonly picture: HTMLElement,
    readonly pane: SlicePane,
    readonly host: PaneNotesHost,
  ) {
    const { ownerDocument: document } = picture;
    this.#element = document.createElement('div');
    this.#element.className = 'notes';
    this.#element.setAttribute('role', 'group');
    this.#panel = document.createElement('div');
    this.#panel.className = 'note-text';
    this.#panel.setAttribute('part', 'note-text');
    this.#panel.setAttribute('role', 'group');
    this.#panel.tabIndex = 0;
    this.#panel.hidden = true;
    this.#element.append(this.#panel);
    const { CSSStyleSheet: Sheet } = document.defaultView as typeof globalThis & Window;
    this.#sheet = new Sheet();
    this.#sheet.replaceSync(paneNoteStyles);
    const root = picture.getRootNode() as ShadowRoot;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    picture.after(this.#element);
    this.#element.addEventListener('keydown', (event) => this.#onKey(event));
  }

  remove(): void {
    if (this.#opened?.isOpen) this.host.toggle(this.#opened);
    const root = this.picture.getRootNode() as ShadowRoot;
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((one) => one !== this.#sheet);
    this.#element.remove();
  }

  /** Whether a click was on a note of this pane, or on its text. */
  has(path: readonly unknown[], owner: NoteOwner): boolean {
    const pin = this.#marks.get(owner)?.pin;
    return path.includes(pin) || (this.#opened === owner && path.includes(this.#panel));
  }

  /** Show the text of a note here; null for none. */
  open(owner: NoteOwner | null): void {
    if (owner === this.#opened) return;
    this.#opened = owner;
    const isShown = owner !== null && owner.hasText && owner.around !== null;
    this.#panel.hidden = !isShown;
    this.#panel.replaceChildren(...(isShown ? [...owner.element.childNodes].map((node) => node.cloneNode(true)) : []));
    if (isShown) {
      this.#panel.ariaLabel = this.#nameOf(owner);
      this.#panel.dir = getComputedStyle(owner.element).direction;
    }
    this.place();
  }

  #nameOf(owner: NoteOwner): string {
    return owner.label || owner.messages.note(String(this.host.owners.indexOf(owner) + 1));
  }

  /** Move everything to its place in the picture that the pane has drawn. */
  place(): void {
    const { owners } = this.host;
    const { size } = this.pane;
    for (const [owner, { pin }] of this.#marks)
      if (!owners.includes(owner)) {
        pin.remove();
        this.#marks.delete(owner);
      }
    const shown = owners.flatMap((owner) => {
      const place = owner.at && !owner.element.hidden ? placeInPane(this.pane, owner.at) : null;
      if (!place && this.#marks.has(owner)) this.#hide(this.#marks.get(owner)!);
      return place ? [{ owner, ...place }] : [];
    });
    this.#element.hidden = shown.length === 0;
    if (shown.length === 0) return;
    this.#element.ariaLabel = shown[0].owner.messages.notes;
    const marks = shown.map(({ owner }) => this.#markOf(owner));
    // All writes that change a width come before the first read of one.
    shown.forEach(({ owner }, i) => this.#write(owner, marks[i]));
    for (const mark of marks) if (mark.width < 0) mark.width = mark.name.offsetWidth;
    const lefts = placeNames(
      shown.map(({ point, isOn }, i) => ({ point, width: isOn ? marks[i].width : 0 })),
      size,
      line,
    );
    shown.forEach(({ point: [x, y], isOn }, i) => {
      const { pin, name, width } = marks[i];
      pin.hidden = false;
      pin.classList.toggle('near', !isOn);
      pin.classList.toggle('crowded', lefts[i] === null);
      pin.tabIndex = isOn ? 0 : -1;
      pin.ariaHidden = isOn ? null : 'true';
      pin.style.transform = `translate(${x.toFixed(2)}px, ${y.toFixed(2)}px)`;
      const left = lefts[i] ?? (x + 10 + width > size.width ? x - 10 - width : x + 10);
      // From the left edge of the button, half of which is left of the place.
      name.style.left = `${(Math.max(0, left) - x + pinSize / 2).toFixed(1)}px`;
    });
    const open = shown.find(({ owner }) => owner === this.#opened);
    this.#element.append(this.#panel);
    if (open && !this.#panel.hidden) this.#placePanel(open.point);
  }

  /** A note that leaves the slice with the focus gives it to the picture. */
  #hide({ pin }: PaneMark): void {
    if (pin.matches(':focus')) this.picture.focus({ preventScroll: true });
    pin.hidden = true;
  }

  #markOf(owner: NoteOwner): PaneMark {
    const known = this.#marks.get(owner);
    if (known) return known;
    const { ownerDocument: document } = this.picture;
    const pin = document.createElement('button');
    pin.type = 'button';
    pin.className = 'pin';
    pin.setAttribute('part', 'note-pin');
    const name = document.createElement('bdi');
    name.setAttribute('part', 'note');
    pin.append(name);
    pin.addEventListener('click', () => this.host.toggle(owner));
    for (const [type, isPointed] of [
      ['pointerenter', true],
      ['focus', true],
      ['pointerleave', false],
      ['blur', false],
    ] as const)
      pin.addEventListener(type, () => this.host.point(owner, isPointed));
    this.#element.append(pin);
    const mark = { pin, name, width: -1 };
    this.#marks.set(owner, mark);
    return mark;
  }

  #write(owner: NoteOwner, mark: PaneMark): void {
    const { pin, name } = mark;
    const text = owner.label || String(this.host.owners.indexOf(owner) + 1);
    if (name.textContent !== text) {
      name.textContent = text;
      pin.ariaLabel = this.#nameOf(owner);
      mark.width = -1;
    }
    const isOpen = this.#opened === owner;
    pin.classList.toggle('active', owner.isOpen);
    pin.ariaExpanded = owner.hasText && owner.around ? String(isOpen) : null;
    pin.ariaPressed = owner.around ? null : String(owner.isOpen);
    const color = getComputedStyle(owner.element).getPropertyValue('--volume-note-color').trim();
    if (color) pin.style.setProperty('--_color', color);
    else pin.style.removeProperty('--_color');
  }

  /** Below the pin where there is room, else above it. */
  #placePanel([x, y]: readonly [number, number]): void {
    const { width, height } = this.pane.size;
    const { offsetWidth, offsetHeight } = this.#panel;
    const below = y + 16;
    const top = below + offsetHeight + margin <= height ? below : y - 16 - offsetHeight;
    const clamp = (at: number, length: number, side: number): number =>
      Math.max(margin, Math.min(side - margin - length, at));
    this.#panel.style.transform = `translate(${clamp(x - offsetWidth / 2, offsetWidth, width).toFixed(1)}px, ${clamp(top, offsetHeight, height).toFixed(1)}px)`;
  }

  #onKey(event: KeyboardEvent): void {
    const owner = this.#opened;
    if (event.key !== 'Escape' || event.defaultPrevented || !owner) return;
    event.preventDefault();
    event.stopPropagation();
    const pin = this.#marks.get(owner)?.pin;
    if (pin && !pin.hidden) pin.focus({ preventScroll: true });
    this.host.toggle(owner);
  }
}
