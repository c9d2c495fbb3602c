import type { Vector3 } from '../../volume/matrix.ts';
import type { MeasureType } from '../../volume/measures.ts';
import type { Volume } from '../../volume/volume.ts';
import { placeInPlane } from '../camera/drag-place.ts';
import type { Pixel, SeenPicture } from '../camera/drag-place.ts';
import { Handles } from '../overlays/handles.ts';
import type { Handle, HandledView } from '../overlays/handles.ts';
import { LineOverlay } from '../overlays/line-overlay.ts';
import { linesOf, textPlace } from './measure-lines.ts';
import { fromDrawn, pointCounts, toDrawn } from './measuring.ts';
import { clicksOn } from '../picking/pick-clicks.ts';
import type { PickedView } from '../picking/pick-clicks.ts';
import { ViewLines } from './view-lines.ts';
import type { LineColor } from './view-lines.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import type { VolumePick } from '../model/volume-pick.ts';

/** The view in which a person measures. */
export type MeasuredView = HandledView & PickedView;

/** What is shown of a measure. */
export interface ShownMeasure {
  readonly volume: Volume;
  readonly type: MeasureType;
  /** The points that are placed so far. */
  readonly points: readonly Vector3[];
  readonly color: { readonly css: string; readonly rgb: LineColor };
  /** The text next to the measure. */
  readonly text: string;
  /** For each point: its name, its place in words, and what the keys do. */
  readonly names: readonly Pick<Handle, 'name' | 'place' | 'keys'>[];
}

/** What a person does with the measure. */
export interface StageEvents {
  /** A point was moved. */
  readonly moved: (index: number, to: Vector3) => void;
  /** A click while points are placed; null where the picture shows nothing there. */
  readonly picked: (at: Vector3 | null) => void;
  /** A key was pressed on the picture or on a handle. */
  readonly key: (event: KeyboardEvent) => void;
}

/** The places of points that a person adds without pointing: shares of the picture. */
const middle: Readonly<Record<MeasureType, readonly Pixel[]>> = {
  distance: [
    [0.35, 0.5],
    [0.65, 0.5],
  ],
  angle: [
    [0.65, 0.5],
    [0.4, 0.65],
    [0.5, 0.3],
  ],
  box: [
    [0.4, 0.6],
    [0.6, 0.4],
  ],
  sphere: [
    [0.5, 0.5],
    [0.65, 0.5],
  ],
};

/** One measure in a view: lines in its scene, faint lines over its picture, handles, and the clicks that place points. */
export class MeasureStage implements ViewPart {
  readonly key = 'measure';
  readonly #handles: Handles;
  readonly #overlay: LineOverlay;
  readonly #lines: ViewLines;
  readonly #abort = new AbortController();
  #shown: ShownMeasure | null = null;
  #release: (() => void) | null = null;

  /** @param picture - the part of the view that holds its picture */
  constructor(
    readonly view: MeasuredView,
    picture: Element,
    readonly events: StageEvents,
  ) {
    const { signal } = this.#abort;
    this.#handles = new Handles(view, picture, {
      moved: (index, to) => this.#shown && events.moved(index, fromDrawn(to, this.#shown.volume)),
    });
    this.#overlay = new LineOverlay(picture, { part: 'measure', opacity: 0.75, isDashed: true });
    this.#lines = new ViewLines(socketOf(view));
    void socketOf(view).join(this);
    view.addEventListener('keydown', events.key, { signal });
    view.addEventListener('volume-pick', (event) => this.#take((event as CustomEvent<VolumePick | null>).detail), {
      signal,
    });
  }

  dispose(): void {
    this.placing = false;
    this.#abort.abort();
    void socketOf(this.view).leave(this);
    this.#handles.dispose();
    this.#overlay.remove();
    this.#lines.dispose();
  }

  /** Whether a click places a point. */
  get placing(): boolean {
    return this.#release !== null;
  }

  set placing(on: boolean) {
    if (on === this.placing) return;
    this.#release?.();
    this.#release = on ? clicksOn(this.view).hold() : null;
  }

  /** @param shown - null for nothing */
  show(shown: ShownMeasure | null): void {
    this.#shown = shown;
    const points = shown?.points ?? [];
    this.#handles.set(
      shown
        ? points.map((point, i) => ({ ...shown.names[i], at: toDrawn(point, shown.volume), color: shown.color.css }))
        : [],
    );
    this.#lines.show(this.#worldLines, shown?.color.rgb ?? [1, 1, 1]);
    this.place();
  }

  focus(index: number): void {
    this.#handles.focus(index);
  }

  /** Points in the middle of the picture, as far away as the camera's target; null where there is no picture. */
  placesInTheMiddle(volume: Volume, type: MeasureType): readonly Vector3[] | null {
    const picture = this.#picture;
    if (!picture) return null;
    const { camera, width, height } = picture;
    const places = middle[type].map(([x, y]) => placeInPlane(picture, camera.target, [x * width, y * height]));
    // A box without depth would be empty: move one corner.
    if (type === 'box')
      places[1] = placeInPlane(picture, middleOf(places, camera.eye), [
        middle.box[1][0] * width,
        middle.box[1][1] * height,
      ]);
    return places.slice(0, pointCounts[type]).map((place) => fromDrawn(place, volume));
  }

  get #picture(): SeenPicture | null {
    const { camera, clientWidth: width, clientHeight: height } = this.view;
    return camera && width > 0 && height > 0 ? { camera, width, height } : null;
  }

  get #worldLines(): readonly (readonly Vector3[])[] {
    const shown = this.#shown;
    return shown
      ? linesOf(shown.type, shown.points).map((line) => line.map((point) => toDrawn(point, shown.volume)))
      : [];
  }

  place(): void {
    const shown = this.#shown;
    const isWhole = shown && shown.points.length === pointCounts[shown.type];
    const text = isWhole
      ? {
          at: toDrawn(textPlace(shown.type, shown.points), shown.volume),
          text: shown.text,
          isAbove: shown.type === 'box' || shown.type === 'sphere',
        }
      : null;
    this.#overlay.show(shown && this.#picture, this.#worldLines, shown?.color.css ?? '', text);
  }

  #take(pick: VolumePick | null): void {
    if (this.placing && this.#shown) this.events.picked(pick && fromDrawn(pick.world, this.#shown.volume));
  }
}

/** A place a little nearer to the eye than the first one: by the distance between both places. */
function middleOf([from, to]: readonly Vector3[], eye: Vector3): Vector3 {
  const apart = Math.hypot(...from.map((x, axis) => to[axis] - x));
  const away = Math.hypot(...from.map((x, axis) => eye[axis] - x));
  return from.map((x, axis) => x + ((eye[axis] - x) * Math.min(apart, away / 2)) / away) as unknown as Vector3;
}
