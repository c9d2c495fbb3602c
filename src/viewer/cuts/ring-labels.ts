import { projectInView } from '../camera/project-place.ts';
import type { View } from '../model/scene.ts';
import type { ViewPart } from '../model/view-socket.ts';
import type { RingLabel } from '../../radar/range-rings.ts';

/** Labels are hidden if they are nearer to the eye than this share of the distance of the farthest label. */
const nearest = 1e-3;

/** From a text to the edge of the picture, CSS pixels. */
const margin = 3;

/** Facts about a radar's scan that people need to read its picture. */
export interface ScanFacts {
  /** Name of the radar; '' where its file gives none. */
  readonly name: string;
  /** The factor by which heights are exaggerated. */
  readonly stretch: number;
}

/** Writes the radius of a ring, metres; null: the north; or the facts about the scan. */
export type RingWriter = (what: number | null | ScanFacts) => string;

/** Maximum length of a name from a file, in characters: the file may come from a stranger. */
const maxName = 60;

/** Small texts over a picture, each at the place of the world that it describes. */
export class RingLabels implements ViewPart {
  readonly key = 'rings';
  #labels: readonly RingLabel[] = [];
  #spans: HTMLElement[] = [];
  #facts: ScanFacts | null = null;
  readonly #caption = document.createElement('div');

  /**
   * @param container - covers the picture
   */
  constructor(
    readonly container: Element,
    readonly write: RingWriter,
  ) {
    Object.assign(this.#caption.style, {
      position: 'absolute',
      insetBlockStart: '8px',
      insetInlineStart: '10px',
      textShadow: '0 0 3px #000, 0 0 2px #000, 0 1px 1px #000',
    });
    Object.assign(this.#caption.style, {
      color: 'var(--volume-view-label-color, #fff)',
      fontSize: '12px',
      maxInlineSize: 'calc(100% - 20px)',
    });
  }

  /** Put labels over the picture, in a container right after it. */
  static after(picture: Element, write: RingWriter): RingLabels {
    const container = document.createElement('div');
    container.className = 'labels';
    container.ariaHidden = 'true';
    picture.after(container);
    return new RingLabels(container, write);
  }

  /** Replace the labels; `place` shows them. @param facts - written in the corner */
  set(labels: readonly RingLabel[], facts: ScanFacts | null): void {
    this.#labels = labels;
    this.#facts = facts && { ...facts, name: facts.name.slice(0, maxName) };
    this.#spans = labels.map(() => {
      const span = document.createElement('span');
      span.hidden = true;
      return span;
    });
    this.writeTexts();
    this.container.replaceChildren(this.#caption, ...this.#spans);
  }

  /** Write the texts again: the language may have changed. */
  writeTexts(): void {
    this.#spans.forEach((span, i) => (span.textContent = this.write(this.#labels[i].radius)));
    this.#caption.textContent = this.#facts ? this.write(this.#facts) : '';
  }

  /** Move the labels to where a view shows their places. */
  place(view: View): void {
    const seen = this.#labels.map(({ at }) => projectInView(view, at));
    const farthest = Math.max(0, ...seen.map(({ depth }) => depth));
    seen.forEach(({ x, y, depth }, i) => {
      const span = this.#spans[i];
      span.hidden = depth <= farthest * nearest || Math.abs(x) > 1 || Math.abs(y) > 1;
      span.style.left = `${(50 * (x + 1)).toFixed(3)}%`;
      span.style.top = `${(50 * (1 - y)).toFixed(3)}%`;
    });
    this.#keepInside(seen);
  }

  /** Move a text at the edge of the picture so far that all of it is visible. */
  #keepInside(seen: readonly { readonly x: number; readonly y: number }[]): void {
    const { clientWidth, clientHeight } = this.container;
    const sizes = this.#spans.map(({ offsetWidth, offsetHeight }) => [offsetWidth, offsetHeight]);
    const read: { place: readonly [number, number]; size: readonly number[] }[] = [];
    seen.forEach(({ x, y }, i) => {
      const [width, height] = sizes[i];
      const [across, along] = [
        pushInside((clientWidth * (x + 1)) / 2, width, clientWidth),
        pushInside((clientHeight * (1 - y)) / 2, height, clientHeight),
      ];
      const place = [(clientWidth * (x + 1)) / 2 + across, (clientHeight * (1 - y)) / 2 + along] as const;
      // Hide a text that would cover another one.
      this.#spans[i].hidden ||= read.some((one) =>
        place.every((at, axis) => Math.abs(at - one.place[axis]) < (sizes[i][axis] + one.size[axis]) / 2),
      );
      if (!this.#spans[i].hidden) read.push({ place, size: sizes[i] });
      this.#spans[i].style.translate = `calc(${across.toFixed(2)}px - 50%) calc(${along.toFixed(2)}px - 50%)`;
    });
  }
}

/** How far a text must move to be inside a side. It has the given length, and its middle is at the given place. */
function pushInside(middle: number, length: number, side: number): number {
  const min = length / 2 + margin;
  return Math.min(Math.max(middle, min), Math.max(side - min, min)) - middle;
}
