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
import { readSliceAttributes, refuseNoSlices, resolveSliceAppearance } from './slice-appearance.ts';
import type { SharedAppearance, SliceAttributes } from './slice-appearance.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import { ViewJoiner } from './view-joiner.ts';

/** What a pane must show. */
export interface Shown {
  readonly volume: Volume | null;
  /** Panes with the same owner share a crosshair, if they are in no group. */
  readonly owner: object;
  readonly group: string | null;
  /** The appearance of the <volume-view> to which the pane belongs. */
  readonly shared: SharedAppearance | null;
  /** The labels of its volume, with the opacity of the pane; undefined for none. */
  readonly labels?: (opacity: number) => PaneLabels | null;
  /** The transfer function of a volume that is itself labels, if it is not the one from the file. */
  readonly look?: TransferFunction | null;
}

/** What the presenter needs of its pane. */
export interface SlicePresenterHost {
  /** Whether it is in a page. */
  readonly isThere: () => boolean;
  /** The text of an attribute; null where it is absent. */
  readonly text: (name: string) => string | null;
  readonly shown: () => Shown;
  /** What is shown has changed. */
  changed(): void;
  /** The crosshair has moved, or the window has changed. */
  moved(what: 'cursor' | 'window'): void;
  failed(error: VolumeViewError): void;
}

/** Applies volumes and attributes to a pane, and draws it at most once a frame. */
export class SlicePresenter {
  readonly pane = new SlicePane(findCrosshair(null, this), () => this.redraw());
  #error: VolumeViewError | null = null;
  #attributes: SliceAttributes | null = null;
  #input: PaneInput | null = null;
  #ignore: () => void = () => {};
  #picture: HTMLElement | null = null;
  /** The view to which the pane belongs. */
  #shared: HTMLElement | null = null;
  /** The parts of the view that show something over this pane. */
  #parts: readonly ViewPart[] = [];
  readonly #inView = new ViewJoiner({
    color: () => colorOf(this.#picture),
    failed: (error) => this.fail(error),
    mended: () => this.refresh(() => false),
  });
  #frame = 0;
  #run = 0;
  #refreshing: Promise<void> = Promise.resolve();
  /** Settled when the requested frame has been drawn, or given up. */
  #drawing: Promise<void> = Promise.resolve();
  #settleDrawing: () => void = () => {};
  /** The place and the window that were reported last. */
  #reported: readonly [place: Vector3, window: readonly [number, number]] | null = null;

  constructor(readonly host: SlicePresenterHost) {}

  /** The error of the present attributes or of the volume. */
  get error(): VolumeViewError | null {
    return this.#error;
  }

  /** Resolves when the picture is final: nothing is being read, waits for a frame, or is being painted. */
  async drawn(): Promise<void> {
    const stages = (): readonly Promise<unknown>[] => [
      this.#refreshing,
      this.#drawing,
      this.pane.reading,
      this.pane.painter.done,
    ];
    for (let last: readonly Promise<unknown>[] = []; stages().some((stage, i) => stage !== last[i]);) {
      last = stages();
      for (const stage of last) await stage;
    }
  }

  enter(picture: HTMLElement, canvas: HTMLCanvasElement): void {
    if (this.#input) return;
    this.#picture = picture;
    this.pane.painter.canvas = canvas;
    this.#input = new PaneInput(picture, this.pane, {
      drag: () => this.#attributes?.drag ?? 'cursor',
      moved: () => this.redraw(),
    });
    this.refresh(() => false);
  }

  leave(): void {
    this.#input?.dispose();
    this.#input = null;
    this.#ignore();
    this.#inView.leave();
    this.#placeParts([]);
    this.#run++;
    this.pane.leave();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#settleDrawing();
  }

  /** Apply the present attributes and volume. @param changed - whether an attribute has just been written */
  refresh(changed: (name: 'cursor' | 'at') => boolean): void {
    const run = ++this.#run;
    this.#refreshing = this.#read(run, changed).catch((error: unknown) => {
      if (run === this.#run) this.fail(error);
    });
  }

  /** Report an error; the last good picture stays. */
  fail(error: unknown): void {
    this.#error = asVolumeViewError(error, 'volume-slice-view');
    this.host.changed();
    this.host.failed(this.#error);
  }

  /** Draw in the next frame. */
  redraw(): void {
    if (this.#frame !== 0 || !this.host.isThere()) return;
    this.#drawing = new Promise((resolve) => (this.#settleDrawing = resolve));
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.pane.draw();
      this.#placeParts(this.#shared ? socketOf(this.#shared).parts : []);
      this.#settleDrawing();
      this.host.changed();
      this.#notify();
    });
  }

  async #read(run: number, changed: (name: 'cursor' | 'at') => boolean): Promise<void> {
    const { volume, owner, group, shared, labels, look: own } = this.host.shown();
    const attributes = readSliceAttributes(this.host.text);
    if (volume) refuseNoSlices(volume);
    const appearance = volume && (await resolveSliceAppearance(attributes, volume, shared, own));
    if (run !== this.#run) return;
    const { pane } = this;
    this.#attributes = attributes;
    this.#join(owner, group);
    const isOther = volume !== (pane.sliced?.volume ?? null);
    if (isOther)
      pane.setVolume(
        volume && new SlicedVolume(volume, volume.grid as CartesianGrid),
        isSameGrid(volume, pane.sliced?.volume),
      );
    if (appearance) pane.setLook(appearance);
    pane.labels = labels?.(attributes.labelOpacity) ?? null;
    if (volume) this.#place(attributes, (name) => isOther || changed(name));
    this.#inView.join(shared && owner, pane.crosshair);
    this.#shared = shared && (owner as HTMLElement);
    this.#error = null;
    this.redraw();
  }

  /** Put the crosshair where the attributes place it: only once, because a person may move it afterwards. */
  #place({ cursor, at }: SliceAttributes, isNew: (name: 'cursor' | 'at') => boolean): void {
    if (cursor && isNew('cursor')) this.pane.crosshair.moveTo(cursor);
    if (at !== null && isNew('at')) this.pane.goTo(at);
  }

  #join(owner: object, group: string | null): void {
    this.#ignore();
    this.pane.crosshair = findCrosshair(group, owner);
    this.#ignore = this.pane.crosshair.listen(() => this.redraw());
  }

  #placeParts(parts: readonly ViewPart[]): void {
    const picture = this.#picture!;
    for (const part of this.#parts) if (!parts.includes(part)) part.leavePane?.(picture);
    this.#parts = parts.filter((part) => part.placeInPane);
    for (const part of this.#parts) part.placeInPane!(picture, this.pane);
  }

  #notify(): void {
    const { sliced, place, window } = this.pane;
    if (!sliced) return;
    const before = this.#reported;
    this.#reported = [place, window];
    // The first place is reported too.
    if (String(before?.[0]) !== String(place)) this.host.moved('cursor');
    if (before && String(before[1]) !== String(window)) this.host.moved('window');
  }
}

/** The colour of a pane's crosshair; it is the same in the picture of the view. */
function colorOf(picture: Element | null): string {
  return (picture && getComputedStyle(picture).getPropertyValue('--volume-slice-crosshair-color').trim()) || '#ffd24d';
}

/** Whether a place or zoom in one volume is also valid in the other: in the next scan in time, for instance. */
function isSameGrid(one: Volume | null, other: Volume | undefined): boolean {
  return JSON.stringify(one?.grid) === JSON.stringify(other?.grid);
}
