import { asVolumeViewError } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { findCrosshair } from '../../panes/crosshair.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import { PaneInput } from '../../panes/pane-input.ts';
import { SlicedVolume } from '../../panes/slice-field.ts';
import { SlicePane } from '../../panes/slice-pane.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { readSliceAttributes, refuseNoSlices, resolveSliceLook } from './slice-look.ts';
import type { SharedLook, SliceAttributes } from './slice-look.ts';
import { ViewJoiner } from './view-joiner.ts';

/** What a pane is to show. */
export interface Shown {
  readonly volume: Volume | null;
  /** Whose panes have one crosshair, where they are in no group. */
  readonly owner: object;
  readonly group: string | null;
  /** Of the <volume-view> that it belongs to. */
  readonly shared: SharedLook | null;
  /** The labels of its volume, as opaque as a pane has them; undefined for none. */
  readonly labels?: (opacity: number) => PaneLabels | null;
  /** The transfer function of a volume that is labels itself, where it has another than its file's. */
  readonly look?: TransferFunction | null;
}

/** Whose pane it is. */
export interface SlicePresenterHost {
  /** Whether it is in a page. */
  readonly isThere: () => boolean;
  /** The text of an attribute; null where it is absent. */
  readonly text: (name: string) => string | null;
  readonly shown: () => Shown;
  /** Something is to be seen otherwise. */
  changed(): void;
  /** The crosshair is elsewhere, or the window another. */
  moved(what: 'cursor' | 'window'): void;
  failed(error: VolumeViewError): void;
}

/** Brings volumes and attributes into a pane, and draws it once a frame at most. */
export class SlicePresenter {
  readonly pane = new SlicePane(findCrosshair(null, this));
  #error: VolumeViewError | null = null;
  #attributes: SliceAttributes | null = null;
  #input: PaneInput | null = null;
  #ignore: () => void = () => {};
  #picture: Element | null = null;
  readonly #inView = new ViewJoiner({ color: () => colorOf(this.#picture), failed: (error) => this.fail(error), mended: () => this.refresh(() => false) });
  #frame = 0;
  #run = 0;
  #refreshing: Promise<void> = Promise.resolve();
  /** Settled when the frame that is asked for has been drawn, or given up. */
  #drawing: Promise<void> = Promise.resolve();
  #settleDrawing: () => void = () => {};
  /** What was told last: place and window. */
  #told: readonly [place: Vector3, window: readonly [number, number]] | null = null;

  constructor(readonly host: SlicePresenterHost) {}

  /** What is wrong with the present attributes or the volume. */
  get error(): VolumeViewError | null {
    return this.#error;
  }

  /** Resolves when the picture is as fine as it gets: nothing is being read, waits for a frame, or is painted. */
  async drawn(): Promise<void> {
    const stages = (): readonly Promise<void>[] => [this.#refreshing, this.#drawing, this.pane.painter.done];
    for (let last: readonly Promise<void>[] = []; stages().some((stage, i) => stage !== last[i]);) {
      last = stages();
      for (const stage of last) await stage;
    }
  }

  enter(picture: HTMLElement, canvas: HTMLCanvasElement): void {
    if (this.#input) return;
    this.#picture = picture;
    this.pane.painter.canvas = canvas;
    this.#input = new PaneInput(picture, this.pane, { drag: () => this.#attributes?.drag ?? 'cursor', moved: () => this.redraw() });
    this.refresh(() => false);
  }

  leave(): void {
    this.#input?.dispose();
    this.#input = null;
    this.#ignore();
    this.#inView.leave();
    this.#run++;
    this.pane.painter.stop();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#settleDrawing();
  }

  /** Take in attributes and volume as they are now. @param changed - whether an attribute has just been written */
  refresh(changed: (name: 'cursor' | 'at') => boolean): void {
    const run = ++this.#run;
    this.#refreshing = this.#read(run, changed).catch((error: unknown) => {
      if (run === this.#run) this.fail(error);
    });
  }

  /** Something went wrong; the last good picture stays. */
  fail(error: unknown): void {
    this.#error = asVolumeViewError(error, 'volume-slice-view');
    this.host.changed();
    this.host.failed(this.#error);
  }

  /** With the next frame. */
  redraw(): void {
    if (this.#frame !== 0 || !this.host.isThere()) return;
    this.#drawing = new Promise((resolve) => (this.#settleDrawing = resolve));
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.pane.draw();
      this.#settleDrawing();
      this.host.changed();
      this.#tell();
    });
  }

  async #read(run: number, changed: (name: 'cursor' | 'at') => boolean): Promise<void> {
    const { volume, owner, group, shared, labels, look: own } = this.host.shown();
    const attributes = readSliceAttributes(this.host.text);
    if (volume) refuseNoSlices(volume);
    const look = volume && (await resolveSliceLook(attributes, volume, shared, own));
    if (run !== this.#run) return;
    const { pane } = this;
    this.#attributes = attributes;
    this.#join(owner, group);
    const isOther = volume !== (pane.sliced?.volume ?? null);
    if (isOther) pane.setVolume(volume && new SlicedVolume(volume, volume.grid as CartesianGrid), isSameGrid(volume, pane.sliced?.volume));
    if (look) pane.setLook(look);
    pane.labels = labels?.(attributes.labelOpacity) ?? null;
    if (volume) this.#place(attributes, (name) => isOther || changed(name));
    this.#inView.join(shared && owner, pane.crosshair);
    this.#error = null;
    this.redraw();
  }

  /** Put the crosshair where the attributes say it is: once, as a person may move it then. */
  #place({ cursor, at }: SliceAttributes, isNew: (name: 'cursor' | 'at') => boolean): void {
    if (cursor && isNew('cursor')) this.pane.crosshair.moveTo(cursor);
    if (at !== null && isNew('at')) this.pane.goTo(at);
  }

  #join(owner: object, group: string | null): void {
    this.#ignore();
    this.pane.crosshair = findCrosshair(group, owner);
    this.#ignore = this.pane.crosshair.listen(() => this.redraw());
  }

  #tell(): void {
    const { sliced, place, window } = this.pane;
    if (!sliced) return;
    const before = this.#told;
    this.#told = [place, window];
    // The first place is news too.
    if (String(before?.[0]) !== String(place)) this.host.moved('cursor');
    if (before && String(before[1]) !== String(window)) this.host.moved('window');
  }
}

/** Of a pane's crosshair, which is alike in the picture of its view. */
function colorOf(picture: Element | null): string {
  return (picture && getComputedStyle(picture).getPropertyValue('--volume-slice-crosshair-color').trim()) || '#ffd24d';
}

/** Whether what was zoomed to in one volume is there in the other: the next scan in time, say. */
function isSameGrid(one: Volume | null, other: Volume | undefined): boolean {
  return JSON.stringify(one?.grid) === JSON.stringify(other?.grid);
}
