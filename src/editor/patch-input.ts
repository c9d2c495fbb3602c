import type { ValueAndGradient } from '../optics/transfer/patches.ts';
import { shareOfChart } from './share-of-chart.ts';
import type { ChartPlace } from './share-of-chart.ts';
import type { Grip } from './patch-edits.ts';

/** What a pointer can drag: patches that come later lie on top. */
export interface Taken {
  readonly index: number;
  readonly grip: Grip;
}

/** Receives what pointers on the chart do. */
export interface PatchInputListener {
  grips(): readonly (Taken & ChartPlace)[];
  /** The topmost patch at a point; -1 for none. */
  patchAt(place: ChartPlace): number;
  choose(taken: Taken): void;
  drag(taken: Taken, to: ChartPlace): void;
  /** Draws a new box from one corner to another. @param isNew - true for the first call of a drag */
  draw(from: ChartPlace, to: ChartPlace, isNew: boolean): void;
  /** A drag has ended. */
  drop(): void;
}

/** Maximum distance at which a pointer still takes a grip, CSS pixels. */
const reach = { mouse: 12, touch: 24 };

/** A shorter drag does not draw a box. */
const minDrawing = 6;

/**
 * Mouse, finger and pen on the chart of values and gradients: a press takes a grip, or a patch; elsewhere it draws a
 * box.
 */
export class PatchInput {
  #taken: Taken | null = null;
  #from: ChartPlace | null = null;
  #offset = { share: 0, height: 0 };
  #moved = false;

  constructor(readonly listener: PatchInputListener) {}

  readonly down = (event: PointerEvent): void => {
    if (event.button !== 0 || !event.isPrimary) return;
    const chart = event.currentTarget as HTMLElement;
    const place = shareOfChart(chart, event);
    const taken = this.#find(chart, event, place);
    this.#moved = false;
    this.#taken = taken;
    this.#from = taken ? null : place;
    chart.setPointerCapture(event.pointerId);
    if (!taken) return;
    const grip = this.listener.grips().find(({ index, grip: name }) => index === taken.index && name === taken.grip)!;
    this.#offset = { share: grip.share - place.share, height: grip.height - place.height };
    this.listener.choose(taken);
  };

  readonly move = (event: PointerEvent): void => {
    if (!event.isPrimary) return;
    const chart = event.currentTarget as HTMLElement;
    const place = shareOfChart(chart, event);
    if (this.#taken) {
      this.#moved = true;
      this.listener.drag(this.#taken, {
        share: place.share + this.#offset.share,
        height: place.height + this.#offset.height,
      });
    } else if (this.#from) {
      const [across, up] = [
        (place.share - this.#from.share) * chart.clientWidth,
        (place.height - this.#from.height) * chart.clientHeight,
      ];
      if (!this.#moved && Math.hypot(across, up) < minDrawing) return;
      this.listener.draw(this.#from, place, !this.#moved);
      this.#moved = true;
    }
  };

  readonly up = (event: PointerEvent): void => {
    if (!event.isPrimary) return;
    const wasMoved = this.#moved && (this.#taken !== null || this.#from !== null);
    this.#taken = null;
    this.#from = null;
    if (wasMoved) this.listener.drop();
  };

  /** Prevents a browser's default action after a press: it would move the focus, and select text. */
  readonly keepFocus = (event: MouseEvent): void => event.preventDefault();

  #find(chart: HTMLElement, { pointerType }: PointerEvent, place: ChartPlace): Taken | null {
    let nearest = pointerType === 'mouse' ? reach.mouse : reach.touch;
    let found: Taken | null = null;
    for (const grip of this.listener.grips()) {
      const distance = Math.hypot(
        (grip.share - place.share) * chart.clientWidth,
        (grip.height - place.height) * chart.clientHeight,
      );
      if (distance <= nearest) [nearest, found] = [distance, grip];
    }
    const index = found ? -1 : this.listener.patchAt(place);
    return found ?? (index >= 0 ? { index, grip: 'middle' } : null);
  }
}

/** The share of the chart by which an arrow key moves a grip. */
const keyStep = 0.01;

/** How far a key moves a grip, as shares 0..1 of the chart; with Shift ten times as far. @returns null for any other key */
export function moveByKey({ key, shiftKey }: KeyboardEvent): ValueAndGradient | null {
  const step = keyStep * (shiftKey ? 10 : 1);
  switch (key) {
    case 'ArrowLeft':
      return [-step, 0];
    case 'ArrowRight':
      return [step, 0];
    case 'ArrowUp':
      return [0, step];
    case 'ArrowDown':
      return [0, -step];
    default:
      return null;
  }
}
