import { parseCssColor } from '../optics/transfer/css-color.ts';
import type { Stop, TransferFunction } from '../optics/transfer/transfer-function.ts';
import type { Histogram } from '../volume/histogram.ts';
import { moveByKey, StopInput } from './stop-input.ts';
import { chooseDomain, toHeight, toOpacity, toShare, toValue } from './transfer-function-axes.ts';
import { stopsFromBands } from './transfer-function-bands.ts';
import type { Band } from './transfer-function-bands.ts';
import { addStop, addStopBeside, changeStop, removeStop } from './transfer-function-edits.ts';
import { EditSession } from './transfer-function-session.ts';
import type { EditedView } from './transfer-function-session.ts';

/** A <volume-view> with the data of its volume that the chart shows. */
export interface ChartedView extends EditedView {
  readonly volume: { readonly histogram: Histogram } | null;
  readonly optics: (EditedView['optics'] & { readonly window: readonly [number, number] }) | null;
}

/** Receives the results of edits. */
export interface EditorListener {
  /** Something has changed that has to be drawn. */
  changed(): void;
  /** The volume has received an edit that continues (`input`) or is finished (`change`). */
  wrote(type: 'input' | 'change'): void;
  /** A stop should get the focus. A stop that was just added exists only after the next update. */
  choose(index: number, when: 'now' | 'updated'): void;
}

/** Edits a volume's transfer function, by fields, keys, mouse and finger. */
export class TransferFunctionEditor {
  /**
   * The values that the chart spans. They do not change while a stop is dragged, because the chart would move under the
   * pointer.
   */
  domain: [number, number] = [0, 1];
  readonly session: EditSession;
  readonly input: StopInput;
  #view: ChartedView | null = null;

  constructor(readonly listener: EditorListener) {
    this.session = new EditSession((type) => {
      if (type === 'change') this.#readDomain();
      listener.wrote(type);
    });
    this.input = new StopInput({
      handles: () =>
        this.stops.map(({ value, opacity }) => ({ share: toShare(value, this.domain), height: toHeight(opacity) })),
      choose: (index) => listener.choose(index, 'now'),
      drag: (index, share, height) =>
        this.changeStop(index, { value: toValue(share, this.domain), opacity: toOpacity(height) }),
      drop: () => this.session.commit(),
      add: (share, height) => this.#put(addStop(this.stops, toValue(share, this.domain), toOpacity(height))),
    });
  }

  get stops(): TransferFunction {
    return this.session.look?.stops ?? [];
  }

  /** Reads the present state of a volume; null if there is none. */
  follow(view: ChartedView | null): void {
    this.#view = view;
    this.session.follow(view);
    this.#readDomain();
    this.listener.changed();
  }

  /** Changes a stop, without a step of the history; the colour is a CSS colour. */
  changeStop(index: number, { color, ...change }: { value?: number; opacity?: number; color?: string }): void {
    this.#setStops(changeStop(this.stops, index, { ...change, ...readColor(color) }));
  }

  /**
   * Changes one of the bands that represent the stops, without a step of the history; a height is 0..1 of a slider, as
   * in the chart.
   */
  changeBand(bands: readonly Band[], index: number, { color, height }: { color?: string; height?: number }): void {
    const change = { ...readColor(color), ...(height === undefined ? {} : { opacity: toOpacity(height) }) };
    this.#setStops(stopsFromBands(bands.map((band, i) => (i === index ? { ...band, ...change } : band))));
  }

  setFactor(name: 'opacityFactor' | 'lightFactor', factor: number): void {
    this.session.setFactor(name, factor);
    this.listener.changed();
  }

  addAttached(index: number): void {
    this.#put(addStopBeside(this.stops, index, this.domain));
  }

  remove(index: number): void {
    const stops = removeStop(this.stops, index);
    this.#put({ stops, index: Math.min(index, stops.length - 1) });
  }

  /**
   * Handles a key.
   * @param index - of the stop that has the focus; null if something else has it
   * @returns whether the key does anything
   */
  press(event: KeyboardEvent, index: number | null): boolean {
    if (event.ctrlKey || event.metaKey) return this.#undoByKey(event);
    if (event.altKey || index === null) return false;
    const move = moveByKey(event, this.stops[index], this.domain);
    if (move) this.changeStop(index, move);
    else if (event.key === 'Delete' || event.key === 'Backspace') this.remove(index);
    else if (event.key === 'Insert' || event.key === '+') this.addAttached(index);
    else return false;
    return true;
  }

  #undoByKey({ key, shiftKey }: KeyboardEvent): boolean {
    const letter = key.toLowerCase();
    if (letter === 'y' || (letter === 'z' && shiftKey)) this.session.redo();
    else if (letter === 'z') this.session.undo();
    else return false;
    return true;
  }

  #put({ stops, index }: { stops: TransferFunction; index: number }): void {
    this.#setStops(stops);
    this.session.commit();
    this.listener.choose(index, 'updated');
  }

  #setStops(stops: TransferFunction): void {
    this.session.setStops(stops);
    this.listener.changed();
  }

  #readDomain(): void {
    const { look: appearance } = this.session;
    const { volume, optics } = this.#view ?? {};
    if (volume && optics && appearance)
      this.domain = chooseDomain(volume.histogram, { ...optics, transferFunction: appearance.stops });
  }
}

function readColor(color: string | undefined): Partial<Pick<Stop, 'color'>> {
  return color === undefined ? {} : { color: parseCssColor(color)!.color };
}
