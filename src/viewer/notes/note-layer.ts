// The notes over the picture of one view: pins at their places, texts at the sides, and lines from one to the other.
import type { VolumeViewError } from '../../core/errors.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { projectInView } from '../camera/project-place.ts';
import type { SlicePane } from '../../panes/slice-pane.ts';
import type { Pixel } from '../camera/drag-place.ts';
import type { View } from '../model/scene.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import { prefersLessMotion } from '../scenes/page-watcher.ts';
import type { Viewer } from '../view/viewer.ts';
import { arrangeNotes, columnsOf, margin, placeNotes, updateOrder } from './layout-notes.ts';
import type { NoteOrder, NoteRoom, PlacedNote } from './layout-notes.ts';
import { NoteMark } from './note-mark.ts';
import type { NoteOwner } from './note-mark.ts';
import { PaneNotes } from './pane-notes.ts';
import { noteStyles } from './note-styles.ts';
import { SightWatch } from './sight-watch.ts';

/** Maximum number of notes of a view. */
export const maxNotes = 1000;

/** Height of a text: larger where fingers touch it. CSS pixels. */
const [line, coarseLine] = [24, 28];

/** Height of the bar of controls, with its distance from the edge. */
const barHeight = 48;

/** A press that moves farther is a drag, CSS pixels. */
const slop = 6;

/** How long texts take to their places when the camera has come to rest, ms. */
const glideMs = 180;

/** Over one view's picture. It exists while the view has notes. */
export class NoteLayer implements ViewPart {
  readonly key = 'notes';
  readonly #element: HTMLElement;
  readonly #pins: HTMLElement;
  readonly #drawing: SVGElement;
  readonly #sheet: CSSStyleSheet;
  readonly #aspect: CSSStyleSheet;
  readonly #abort = new AbortController();
  readonly #owners = new Set<NoteOwner>();
  /** What is wrong with notes. The view shows the first one. */
  readonly #problems = new Map<NoteOwner, VolumeViewError>();
  #reported: VolumeViewError | null = null;
  #marks: readonly NoteMark[] = [];
  /** The notes in panes of slices, by the picture of the pane. */
  readonly #panes = new Map<HTMLElement, PaneNotes>();
  /** The note that a person has opened in a pane, and the picture of the pane: its text is there, not over this picture. */
  #openIn: readonly [NoteOwner, HTMLElement] | null = null;
  #order: NoteOrder | null = null;
  #tops = new Map<number, number>();
  #anchors: readonly (Pixel | null)[] = [];
  #room: NoteRoom = { width: 0, height: 0, line };
  #view: View | null = null;
  #isBuilding = false;
  /** Where the pointer was pressed last. */
  #press: Pixel = [0, 0];
  #frame = 0;
  readonly #sights = new SightWatch({
    marks: () => this.#marks,
    viewer: () => (socketOf(this.view).view?.viewer as Viewer | null | undefined) ?? null,
    changed: () => this.#reorder(),
    rested: () => this.#settle(),
  });

  private constructor(
    readonly view: HTMLElement,
    picture: Element,
  ) {
    const { ownerDocument: document, shadowRoot: root } = view;
    this.#element = document.createElement('div');
    this.#element.className = 'notes';
    this.#element.setAttribute('role', 'group');
    this.#pins = document.createElement('div');
    this.#pins.className = 'pins';
    this.#pins.ariaHidden = 'true';
    this.#drawing = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.#pins.append(this.#drawing);
    this.#element.append(this.#pins);
    ([...picture.parentNode!.querySelectorAll('.handles')].at(-1) ?? picture).after(this.#element);
    const { CSSStyleSheet: Sheet } = document.defaultView as typeof globalThis & Window;
    [this.#sheet, this.#aspect] = [new Sheet(), new Sheet()];
    this.#sheet.replaceSync(noteStyles);
    root!.adoptedStyleSheets = [...root!.adoptedStyleSheets, this.#sheet, this.#aspect];
    const { signal } = this.#abort;
    document.addEventListener('pointerdown', ({ clientX, clientY }) => (this.#press = [clientX, clientY]), {
      signal,
      capture: true,
    });
    document.addEventListener('click', (event) => this.#closeOutside(event), { signal, capture: true });
    view.addEventListener('keydown', (event) => this.#onKey(event), { signal });
    void socketOf(view).join(this);
  }

  /** The layer of a view. @param picture - the part of the view that holds its picture */
  static of(view: HTMLElement, picture: Element): NoteLayer {
    const there = socketOf(view).parts.find((part) => part instanceof NoteLayer);
    return there ?? new NoteLayer(view, picture);
  }

  /** @returns whether there is room: a view has at most `maxNotes` */
  add(owner: NoteOwner): boolean {
    if (!this.#owners.has(owner) && this.#owners.size >= maxNotes) return false;
    this.#owners.add(owner);
    this.changed();
    return true;
  }

  drop(owner: NoteOwner): void {
    this.blame(owner, null);
    this.#owners.delete(owner);
    if (this.#owners.size === 0) this.#dispose();
    else this.changed();
  }

  /** Show in the view what is wrong with a note; null for nothing. */
  blame(owner: NoteOwner, problem: VolumeViewError | null): void {
    if (problem) this.#problems.set(owner, problem);
    else this.#problems.delete(owner);
    const [first = null] = this.#problems.values();
    if (first === this.#reported) return;
    this.#reported = first;
    const errors = socketOf(this.view).view?.errors;
    if (first) errors?.report('notes', first);
    else errors?.clear('notes');
  }

  /** Something about a note has changed. */
  changed(): void {
    if (this.#isBuilding || this.#abort.signal.aborted) return;
    this.#isBuilding = true;
    queueMicrotask(() => {
      this.#isBuilding = false;
      if (!this.#abort.signal.aborted) this.#build();
    });
  }

  /** Draw attention to a note, or no longer. */
  highlight(owner: NoteOwner, isActive: boolean): void {
    this.#marks.find((mark) => mark.owner === owner)?.setActive(isActive);
  }

  #dispose(): void {
    this.#abort.abort();
    this.#sights.dispose();
    cancelAnimationFrame(this.#frame);
    void socketOf(this.view).leave(this);
    this.#element.remove();
    for (const mark of this.#marks) mark.remove();
    for (const picture of [...this.#panes.keys()]) this.leavePane(picture);
    const root = this.view.shadowRoot!;
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((one) => one !== this.#sheet && one !== this.#aspect);
  }

  /** Bring the marks in line with the notes, in the order of the page. */
  #build(): void {
    const owners = [...this.#owners];
    owners.sort((a, b) => (isBefore(a.element, b.element) ? -1 : 1));
    const before = this.#marks;
    const known = new Map(before.map((mark) => [mark.owner, mark]));
    this.#marks = owners.map((owner) => known.get(owner) ?? new NoteMark(owner, this.view.ownerDocument));
    for (const [owner, mark] of known) if (!this.#owners.has(owner)) mark.remove();
    let after: Element = this.#pins;
    if (!this.#openIn?.[0].isOpen) this.#openIn = null;
    this.#marks.forEach((mark, i) => {
      mark.write(i + 1, this.#openIn?.[0] === mark.owner);
      if (after.nextElementSibling !== mark.text) after.after(mark.text, mark.panel);
      after = mark.panel;
      if (mark.line.parentNode !== this.#drawing) this.#drawing.append(mark.line);
      if (mark.pin.parentNode !== this.#pins) this.#pins.append(mark.pin);
    });
    const [name] = owners.map(({ messages }) => messages.notes);
    this.#element.ariaLabel = name;
    if (owners.some((owner, i) => owner !== before[i]?.owner) || owners.length !== before.length) {
      this.#order = null;
      this.#tops.clear();
      this.#sights.stop();
    }
    if (this.#view) this.place(this.#view);
    for (const [picture, pane] of this.#panes) {
      pane.open(this.#openIn?.[1] === picture ? this.#openIn[0] : null);
      pane.place();
    }
    if (before.length === 0)
      for (const { element } of socketOf(this.view).parts) if (element) socketOf(element).last('redraw')?.();
  }

  placeInPane(picture: HTMLElement, pane: SlicePane): void {
    if (this.#marks.length === 0) return;
    if (!this.#panes.has(picture)) this.#panes.set(picture, this.#joinPane(picture, pane));
    this.#panes.get(picture)!.place();
  }

  leavePane(picture: HTMLElement): void {
    const notes = this.#panes.get(picture);
    this.#panes.delete(picture);
    notes?.remove();
  }

  #joinPane(picture: HTMLElement, pane: SlicePane): PaneNotes {
    const owners = (): readonly NoteOwner[] => this.#marks.map(({ owner }) => owner);
    return new PaneNotes(picture, pane, {
      get owners() {
        return owners();
      },
      toggle: (owner) => {
        const isHere = this.#openIn?.[0] === owner && this.#openIn[1] === picture && owner.isOpen;
        this.#openIn = isHere ? null : [owner, picture];
        // Other panes show the place too.
        if (!isHere && owner.at) pane.crosshair.moveTo(owner.at);
        owner.toggle(owner.around ? !isHere : !owner.isOpen);
        this.changed();
      },
      point: (owner, isPointed) => {
        this.highlight(owner, isPointed || owner.isOpen);
        owner.pointed(isPointed);
      },
    });
  }

  place(view: View): void {
    this.#view = view;
    cancelAnimationFrame(this.#frame);
    if (this.#marks.length === 0) return;
    const { clientWidth: width, clientHeight: height } = this.view;
    // On paper the element is higher, as the texts follow the picture; pins keep their places in it.
    if (width === 0 || height === 0 || matchMedia('print').matches) return;
    if (width !== this.#room.width || height !== this.#room.height) this.#resize(width, height);
    const anchors = this.#marks.map(({ owner: { at } }) => at && this.#project(view, at));
    const notes = this.#notes(anchors);
    if (!this.#order) this.#arrange(anchors);
    this.#tops = placeNotes(this.#order!, notes, this.#room, { tops: this.#tops, anchors: this.#anchors });
    const moves = anchors.some((anchor, i) => String(anchor) !== String(this.#anchors[i]));
    this.#anchors = anchors;
    this.#show(this.#lefts(), this.#tops);
    this.#sights.follow(moves);
  }

  #resize(width: number, height: number): void {
    const isCoarse = matchMedia('(any-pointer: coarse)').matches;
    this.#room = { width, height, line: isCoarse ? coarseLine : line };
    const { maxWidth } = columnsOf(this.#room);
    this.#element.style.setProperty('--_line-height', `${this.#room.line}px`);
    this.#element.style.setProperty('--_max-width', `${Math.max(this.#room.line, maxWidth).toFixed(1)}px`);
    this.#aspect.replaceSync(`:host { --_noted-aspect: ${width} / ${height}; }`);
    this.#order = null;
    this.#tops.clear();
  }

  /** The pixel of a place, possibly outside of the picture; null behind the eye. */
  #project(view: View, at: Vector3): Pixel | null {
    const { x, y, depth } = projectInView(view, at);
    const isParallel = view.projection[14] === 0;
    const { width, height } = this.#room;
    const pixel: Pixel = [(width * (x + 1)) / 2, (height * (1 - y)) / 2];
    return (isParallel || depth > 0) && pixel.every(Number.isFinite) ? pixel : null;
  }

  #isInside(anchor: Pixel | null): anchor is Pixel {
    const { width, height } = this.#room;
    return anchor !== null && anchor[0] >= 0 && anchor[1] >= 0 && anchor[0] <= width && anchor[1] <= height;
  }

  #notes(anchors: readonly (Pixel | null)[]): PlacedNote[] {
    return this.#marks.map(({ width, isAway }, i) => ({
      anchor: anchors[i],
      width,
      hasNoPin: isAway || !this.#isInside(anchors[i]),
    }));
  }

  /** Choose the order of the texts that are shown. */
  #arrange(anchors: readonly (Pixel | null)[]): void {
    this.#element.classList.remove('short');
    for (const mark of this.#marks) mark.measure();
    const bottom = this.view.shadowRoot!.querySelector('.controls') ? barHeight : 0;
    this.#room = { ...this.#room, bottom };
    const shown = anchors.map((anchor, i) => (this.#isInside(anchor) && !this.#marks[i].isAway ? anchor : null));
    this.#order = arrangeNotes(this.#notes(shown), this.#room, this.#order);
    this.#element.classList.toggle('short', this.#order.isShort);
    if (this.#order.isShort) for (const mark of this.#marks) mark.measure();
  }

  #lefts(): Map<number, number> {
    const lefts = new Map<number, number>();
    for (const { notes, left, width, isRight } of this.#order!.columns)
      for (const i of notes) lefts.set(i, isRight ? left + width - this.#widthOf(i) : left);
    return lefts;
  }

  #widthOf(i: number): number {
    return this.#order!.isShort ? this.#room.line : this.#marks[i].width;
  }

  #show(lefts: ReadonlyMap<number, number>, tops: ReadonlyMap<number, number>): void {
    const { width, height, line: own } = this.#room;
    this.#marks.forEach((mark, i) => {
      const anchor = this.#anchors[i];
      const size = this.#widthOf(i);
      const isInside = this.#isInside(anchor);
      const [left, top] = [lefts.get(i), tops.get(i)];
      const isPlaced = left !== undefined && top !== undefined;
      // A text without a place in a column stands at its pin where keys reach it.
      const clamp = (at: number, length: number, side: number): number => Math.max(0, Math.min(side - length, at));
      const [x, y] = isPlaced
        ? [left, top]
        : anchor
          ? [clamp(anchor[0] + margin, size, width), clamp(anchor[1] - own / 2, own, height)]
          : [0, 0];
      mark.show({
        anchor: isInside ? anchor : null,
        isPlaced: isPlaced && isInside,
        left: x,
        top: y,
        size,
        room: this.#room,
      });
    });
  }

  /** The texts of marks that are seen otherwise now come or go; the others stay. */
  #reorder(): void {
    if (!this.#order) return;
    const isShown = (i: number): boolean => this.#isInside(this.#anchors[i]) && !this.#marks[i].isAway;
    this.#order = updateOrder(this.#order, this.#notes(this.#anchors), this.#room, isShown);
    for (const i of this.#tops.keys()) if (!isShown(i)) this.#tops.delete(i);
  }

  /** The camera rests: put the texts in order. */
  #settle(): void {
    const [lefts, tops] = [this.#lefts(), this.#tops];
    this.#arrange(this.#anchors);
    this.#tops = placeNotes(this.#order!, this.#notes(this.#anchors), this.#room);
    this.#glide({ lefts, tops }, { lefts: this.#lefts(), tops: this.#tops });
  }

  #glide(
    from: { readonly lefts: ReadonlyMap<number, number>; readonly tops: ReadonlyMap<number, number> },
    to: typeof from,
  ): void {
    cancelAnimationFrame(this.#frame);
    const moves = [...to.tops].some(
      ([i, top]) =>
        from.tops.has(i) && (Math.abs(from.tops.get(i)! - top) > 0.5 || from.lefts.get(i) !== to.lefts.get(i)),
    );
    if (!moves || prefersLessMotion()) return this.#show(to.lefts, to.tops);
    const began = performance.now();
    const mix = (name: 'lefts' | 'tops', share: number): Map<number, number> =>
      new Map([...to[name]].map(([i, end]) => [i, end - (1 - share) * (end - (from[name].get(i) ?? end))]));
    const step = (): void => {
      const share = Math.min(1, (performance.now() - began) / glideMs);
      const eased = 1 - (1 - share) ** 2;
      this.#show(mix('lefts', eased), mix('tops', eased));
      if (share < 1) this.#frame = requestAnimationFrame(step);
    };
    step();
  }

  /** A click or a tap closes what is open elsewhere; a drag, which turns the picture, does not. */
  #closeOutside(event: MouseEvent): void {
    const path = event.composedPath();
    const isKey = event.detail === 0;
    const moved = Math.hypot(event.clientX - this.#press[0], event.clientY - this.#press[1]);
    if (!isKey && moved > slop) return;
    for (const mark of this.#marks) {
      const own: unknown[] = [mark.text, mark.panel, mark.pin, mark.owner.element];
      const isInPane = [...this.#panes.values()].some((pane) => pane.has(path, mark.owner));
      if (mark.owner.isOpen && !isInPane && !path.some((part) => own.includes(part))) mark.owner.toggle(false);
    }
  }

  #onKey(event: KeyboardEvent): void {
    const open = this.#marks.filter(({ owner }) => owner.isOpen);
    if (event.key !== 'Escape' || event.defaultPrevented || open.length === 0) return;
    event.preventDefault();
    event.stopPropagation();
    for (const mark of open) {
      if (mark.hasFocusInside) mark.text.focus({ preventScroll: true });
      mark.owner.toggle(false);
    }
  }
}

/** The order of the page; a mark of the view itself comes after the notes between its tags. */
function isBefore(a: Element, b: Element): boolean {
  return !a.contains(b) && (b.contains(a) || (a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING) > 0);
}
