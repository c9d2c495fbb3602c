// Shows the crosshair that panes of a view share over the view's picture: loaded with the first pane that belongs to a view.
import { asVolumeViewError } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import type { Crosshair } from '../../panes/crosshair.ts';
import { corners } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { LineOverlay } from '../overlays/line-overlay.ts';
import { parseWord } from '../model/parse-attributes.ts';
import { clicksOn } from '../picking/pick-clicks.ts';
import type { PickedView } from '../picking/pick-clicks.ts';
import { parsePlace } from '../cuts/slice-attributes.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart, ViewSocket } from '../model/view-socket.ts';
import type { VolumePick } from '../model/volume-pick.ts';

/** A view to which panes belong. */
export interface CrosshairView extends PickedView {
  readonly camera: Camera | null;
}

/** A pane that belongs to a view. */
export interface JoiningPane {
  readonly crosshair: Crosshair;
  /** CSS colour of its own crosshair. */
  readonly color: () => string;
  readonly failed: (error: VolumeViewError) => void;
  /** The reported errors are gone. */
  readonly mended: () => void;
}

/** Show a pane's crosshair in its view, and let clicks on the view and its `cursor` move it. @returns a function that ends it */
export function joinView(view: CrosshairView, pane: JoiningPane): () => void {
  const shown = socketOf(view).parts.find((part) => part instanceof CrosshairInView);
  return (shown ?? new CrosshairInView(view)).join(pane);
}

/** Three lines along the axes of the world through a place, from side to side of the box around a grid; none for a place outside it. */
export function crosshairLines(grid: GridFrame, place: Vector3): readonly (readonly Vector3[])[] {
  const all = corners(grid);
  const [low, high] = [Math.min, Math.max].map((min) =>
    place.map((_, axis) => min(...all.map((corner) => corner[axis]))),
  );
  if (place.some((x, axis) => x < low[axis] || x > high[axis])) return [];
  return place.map((_, axis) =>
    [low, high].map((ends) => place.map((x, other) => (other === axis ? ends[axis] : x)) as unknown as Vector3),
  );
}

class CrosshairInView implements ViewPart {
  readonly key = 'crosshair';
  readonly #socket: ViewSocket;
  /** The crosshair of the last pane is shown. */
  readonly #panes: JoiningPane[] = [];
  #abort: AbortController | null = null;
  #overlay: LineOverlay | null = null;
  /** The last texts of `cursor` and `crosshair` that were applied. */
  #cursor: string | null = null;
  #word: string | null = null;
  #isHidden = false;
  /** The attributes that can't be read, with their errors. */
  readonly #wrong = new Map<string, VolumeViewError>();

  constructor(readonly view: CrosshairView) {
    this.#socket = socketOf(view);
  }

  /** The place of the panes' crosshair; the middle of the volume where nobody has moved it. */
  get cursor(): Vector3 | null {
    const volume = this.#socket.view?.viewer?.volume;
    return this.#panes.at(-1)?.crosshair.place ?? (volume ? middleOf(volume.grid) : null);
  }

  join(pane: JoiningPane): () => void {
    this.#panes.push(pane);
    if (!this.#abort) this.#enter();
    const ignore = pane.crosshair.listen(() => this.place());
    this.#read();
    this.place();
    return () => {
      ignore();
      this.#panes.splice(this.#panes.indexOf(pane), 1);
      if (this.#panes.length === 0) this.#leave();
      else this.place();
    };
  }

  #enter(): void {
    const { view } = this;
    const { signal } = (this.#abort = new AbortController());
    const release = clicksOn(view).hold();
    const observer = new MutationObserver(() => {
      this.#read();
      this.place();
    });
    observer.observe(view, { attributeFilter: ['cursor', 'crosshair'] });
    signal.addEventListener('abort', () => {
      release();
      observer.disconnect();
    });
    void this.#socket.join(this);
    view.addEventListener(
      'volume-pick',
      (event) => {
        const { detail } = event as CustomEvent<VolumePick | null>;
        if (detail) this.#panes.at(-1)?.crosshair.moveTo(detail.world);
      },
      { signal },
    );
  }

  #leave(): void {
    void this.#socket.leave(this);
    this.#abort?.abort();
    this.#abort = null;
    this.#overlay?.remove();
    this.#overlay = null;
    this.#cursor = this.#word = null;
    this.#isHidden = false;
    this.#wrong.clear();
  }

  #read(): void {
    const before = this.#wrong.size;
    this.#readCursor();
    this.#readWord();
    if (before > 0 && this.#wrong.size === 0) this.#panes.at(-1)!.mended();
  }

  #attempt(name: string, act: () => void): void {
    this.#wrong.delete(name);
    try {
      act();
    } catch (thrown) {
      const error = asVolumeViewError(thrown, name);
      this.#wrong.set(name, error);
      this.#panes.at(-1)!.failed(error);
    }
  }

  /** Only once for each text, because a person may move the crosshair afterwards. */
  #readCursor(): void {
    const text = this.view.getAttribute('cursor');
    if (text === this.#cursor) return;
    this.#cursor = text;
    this.#attempt('cursor', () => {
      if (text !== null && text.trim() !== '')
        this.#panes.at(-1)!.crosshair.moveTo(parsePlace('cursor of <volume-view>', text));
    });
  }

  /** A text that can't be read changes nothing. */
  #readWord(): void {
    const text = this.view.getAttribute('crosshair');
    if (text === this.#word) return;
    this.#word = text;
    this.#attempt('crosshair', () => {
      this.#isHidden =
        text !== null &&
        text.trim() !== '' &&
        parseWord('crosshair of <volume-view>', text, ['auto', 'none']) === 'none';
    });
  }

  /** Draw the crosshair over the picture. */
  place(): void {
    const { camera, clientWidth: width, clientHeight: height } = this.view;
    const viewer = this.#socket.view?.viewer;
    const pane = this.#panes.at(-1);
    const picture = this.view.shadowRoot?.querySelector('.picture');
    if (!pane || !picture) return;
    this.#overlay ??= new LineOverlay(picture, { part: 'crosshair', opacity: 0.6, isDashed: false });
    const shown = viewer?.volume ? viewer.shown : null;
    const { cursor } = this;
    const isThere = camera && shown && cursor && width > 0 && height > 0 && !this.#isHidden;
    const lines = isThere ? crosshairLines(shown.grid, cursor) : [];
    this.#overlay.show(isThere ? { camera, width, height } : null, lines, pane.color(), null);
  }
}

/** The place of panes whose crosshair nobody has moved. */
function middleOf(grid: GridFrame): Vector3 {
  const all = corners(grid);
  return [0, 1, 2].map((axis) => (all[0][axis] + all[7][axis]) / 2) as unknown as Vector3;
}
