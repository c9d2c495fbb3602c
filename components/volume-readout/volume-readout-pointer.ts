import { placeInElement } from '../../src/page/pointer-place.ts';
import { clicksOn, isOnPicture } from '../../src/viewer/picking/pick-clicks.ts';
import { projectPlace } from '../../src/viewer/camera/project-place.ts';
import type { ScansOfView } from '../../src/viewer/model/scans-of-view.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { VolumePick } from '../../src/viewer/model/volume-pick.ts';
import type { Viewer } from '../../src/viewer/view/viewer.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { Marker } from './volume-readout-marker.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';

type Place = readonly [x: number, y: number];

/** The place that was clicked last. */
interface KeptPlace {
  readonly world: Vector3;
  /** The pick at that place now. */
  readonly pick: VolumePick | null;
  /** What was found there first, and in which scans: of the others, it is the same place. */
  readonly first: VolumePick;
  readonly scans: ScansOfView | null;
}

/** After these events the same place may have another value. */
const changes = ['load', 'optics-change', 'time-change'];

/**
 * The place that a person points at in a view: with the mouse over it, by a click or a tap, which keeps the place, and by a crosshair that
 * keys move.
 */
export class ReadoutPointer {
  readonly #abort = new AbortController();
  readonly #marker: Marker;
  readonly #release: () => void;
  #mouse: Place | null = null;
  #crosshair: Place | null = null;
  #kept: KeptPlace | null = null;
  /** Number of picks at the kept place: only the result of the last one is used. */
  #asked = 0;
  #frame = 0;
  /** The camera and the size of the picture at the last check. */
  #seen = '';

  /** @param listener - called with the pick, and with whether anybody points at something */
  constructor(
    readonly view: VolumeView,
    picture: Element,
    readonly listener: (pick: VolumePick | null, points: boolean) => void,
  ) {
    const { signal } = this.#abort;
    this.#marker = new Marker(picture);
    const clicks = clicksOn(view);
    this.#release = clicks.hold();
    view.addEventListener('pointermove', (event) => this.#move(event), { signal });
    view.addEventListener('pointerdown', () => this.#leave(), { signal });
    view.addEventListener('pointerleave', () => this.#leave(), { signal });
    view.addEventListener('volume-pick', ({ detail }) => this.#keep(detail), { signal });
    for (const type of changes) view.addEventListener(type, () => this.#lookAgain(), { signal });
    view.addEventListener('render', () => this.#follow(), { signal });
  }

  /** Show the name of the part in the picture too, as the readout may be out of sight. */
  show(pick: VolumePick | null, points: boolean): void {
    this.#marker.setName(pick?.labelName ?? null);
    this.listener(pick, points);
  }

  dispose(): void {
    this.#abort.abort();
    this.#release();
    this.#marker.remove();
    cancelAnimationFrame(this.#frame);
  }

  /** What was found at the place that was clicked last; null where there is none, or it belongs to scans that are gone. */
  get kept(): VolumePick | null {
    return this.#kept && this.#kept.scans === this.#scans ? this.#kept.first : null;
  }

  get hasCrosshair(): boolean {
    return this.#crosshair !== null;
  }

  /** Put a crosshair at the place that was clicked last, else in the middle; or remove it. */
  setCrosshair(on: boolean): void {
    const { clientWidth: width, clientHeight: height } = this.view;
    this.#crosshair = on ? (this.#keptPlace() ?? [width / 2, height / 2]) : null;
    this.#request();
  }

  /** @param by - CSS pixels to the right and down */
  moveCrosshair(by: Place): void {
    if (!this.#crosshair) return;
    this.#mouse = null;
    const max = [this.view.clientWidth, this.view.clientHeight];
    const [x, y] = this.#crosshair.map((at, axis) => Math.min(max[axis], Math.max(0, at + by[axis])));
    this.#crosshair = [x, y];
    this.#request();
  }

  /** Fire the event for the place of the crosshair, as a click would. */
  clickCrosshair(): void {
    if (this.#crosshair) void clicksOn(this.view).fire(this.#crosshair);
  }

  #move(event: PointerEvent): void {
    if (event.pointerType === 'touch' || event.buttons !== 0 || !isOnPicture(event)) return this.#leave();
    this.#mouse = placeInElement(this.view, event);
    this.#request();
  }

  #leave(): void {
    if (!this.#mouse) return;
    this.#mouse = null;
    this.#request();
  }

  #keep(pick: VolumePick | null): void {
    this.#asked++; // A pick that is still running belongs to an older place.
    this.#kept = pick && { world: pick.world, pick, first: pick, scans: this.#scans };
    this.#request();
  }

  get #hasBricks(): boolean {
    return socketOf(this.view).view?.viewer?.volume?.finer !== undefined;
  }

  get #scans(): ScansOfView | null {
    return socketOf(this.view).view?.user.loader?.scans ?? null;
  }

  #lookAgain(): void {
    const kept = this.#kept;
    const place = this.#keptPlace();
    // From one scan to the next it is the place in the volume that is kept, whatever is seen before it.
    if (kept?.scans && kept.scans === this.#scans) void this.#pickAgain(() => this.#pickInScan(kept.world), kept);
    else if (place) void this.#pickAgain(() => this.view.pick(...place), null);
    this.#request();
  }

  async #pickInScan(world: Vector3): Promise<VolumePick | null> {
    const { pickPlace } = await import('../../src/viewer/picking/pick.ts');
    return pickPlace((socketOf(this.view).view?.viewer as Viewer | null | undefined) ?? null, world);
  }

  /** @param same - the place, where the answer is about no other */
  async #pickAgain(look: () => Promise<VolumePick | null>, same: KeptPlace | null): Promise<void> {
    const asked = ++this.#asked;
    const pick = await look().catch(() => null);
    const kept = same ?? this.#kept;
    if (asked !== this.#asked || !kept || this.#abort.signal.aborted) return;
    this.#kept = same
      ? { ...same, pick }
      : { world: pick?.world ?? kept.world, pick, first: pick ?? kept.first, scans: this.#scans };
    this.#request();
  }

  /** The camera or the size of the picture may have changed. */
  #follow(): void {
    const { camera, clientWidth, clientHeight } = this.view;
    const seen = JSON.stringify([camera, clientWidth, clientHeight]);
    if (seen === this.#seen) return;
    this.#seen = seen;
    this.#request();
  }

  #keptPlace(): Place | null {
    const {
      view: { camera, clientWidth: width, clientHeight: height },
    } = this;
    const place = this.#kept && camera && projectPlace(camera, this.#kept.world, { width, height });
    return place && place[0] >= 0 && place[1] >= 0 && place[0] <= width && place[1] <= height ? place : null;
  }

  /** Pick once per frame, however often this is called. */
  #request(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => void this.#look());
  }

  async #look(): Promise<void> {
    const place = this.#mouse ?? this.#crosshair;
    if (!place) {
      this.#marker.show(this.#keptPlace());
      return this.show(this.#kept?.pick ?? null, this.#kept !== null);
    }
    this.#marker.show(place);
    const isSame = (): boolean => place === (this.#mouse ?? this.#crosshair) && !this.#abort.signal.aborted;
    // Of a volume in bricks, first the finest voxel that has come, then the finest of all, which may have to be read.
    for (const finest of this.#hasBricks ? [false, true] : [true]) {
      const pick = await this.view.pick(...place, { finest }).catch(() => null);
      if (!isSame()) return;
      this.show(pick, true);
    }
  }
}
