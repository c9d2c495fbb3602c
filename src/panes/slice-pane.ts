import type { ProjectionKind } from '../optics/rays/ray-style.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import { scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Crosshair } from './crosshair.ts';
import type { SlicePixels } from './fill-slice.ts';
import { grayLevels } from './gray-levels.ts';
import type { WindowFunction } from './gray-levels.ts';
import { colorPainter, grayPainter } from './paint-slice.ts';
import { fitFrame, pixelsOf, placeAt, pointAt, zoomFrame } from './pane-frame.ts';
import type { PaneFrame, PaneSize, PlaneBox } from './pane-frame.ts';
import type { PaneLabels } from './pane-labels.ts';
import { PanePainter } from './pane-painter.ts';
import type { SlicedVolume } from './slice-field.ts';
import { planeOf, toPlane, toWorld } from './slice-plane.ts';
import type { SlicePlane, SliceType } from './slice-plane.ts';

/** The appearance of a slice. */
export interface SliceAppearance {
  readonly type: SliceType;
  /** World; only for an oblique slice. */
  readonly normal: Vector3;
  /** World units; 0 for a plane. */
  readonly thickness: number;
  readonly projection: ProjectionKind;
  /** Data values of black and white. */
  readonly window: readonly [number, number];
  readonly windowFunction: WindowFunction;
  /** Whether each pixel has the value of the nearest voxel. */
  readonly isNearest: boolean;
  /** Colours instead of greys; null for greys. */
  readonly colors: TransferFunction | null;
}

/** Maximum pixels along an edge of the canvas. */
const maxPixels = 4096;

/** The range of zoom: from a quarter of the scale that fits, to pixels of a two-hundredth of a voxel. */
const zoomRange = { min: 0.25, voxel: 1 / 200 };

/** A pane with one slice of a volume: the slice in which the crosshair is. It knows no element except its canvas. */
export class SlicePane {
  readonly painter = new PanePainter();
  /** Labels of the volume; null for none. */
  labels: PaneLabels | null = null;
  #sliced: SlicedVolume | null = null;
  #look: SliceAppearance | null = null;
  #plane: SlicePlane = planeOf('axial');
  #size: PaneSize = { width: 0, height: 0 };
  #pixelRatio = 1;
  /** The frame after a person's zoom and movement; null for the whole volume. */
  #frame: PaneFrame | null = null;
  #crosshair: Crosshair;
  #reading: Promise<void> = Promise.resolve();

  /** @param changed - more of the slice has come: it has to be drawn again */
  constructor(
    crosshair: Crosshair,
    readonly changed: () => void,
  ) {
    this.#crosshair = crosshair;
  }

  /** Resolves when all finer voxels of the present slice have come. */
  get reading(): Promise<void> {
    return this.#reading;
  }

  /** Nobody looks at it any more. */
  leave(): void {
    this.painter.stop();
    this.#sliced?.volume.finer?.planes?.close(this);
  }

  get sliced(): SlicedVolume | null {
    return this.#sliced;
  }

  get look(): SliceAppearance | null {
    return this.#look;
  }

  get plane(): SlicePlane {
    return this.#plane;
  }

  get size(): PaneSize {
    return this.#size;
  }

  get crosshair(): Crosshair {
    return this.#crosshair;
  }

  set crosshair(crosshair: Crosshair) {
    this.#crosshair = crosshair;
  }

  /** The crosshair's point; the volume's centre if nobody has set it. */
  get place(): Vector3 {
    return this.#crosshair.place ?? this.#sliced?.center ?? [0, 0, 0];
  }

  /** Data values of black and white, from a person or the page. */
  get window(): readonly [number, number] {
    return (this.#sliced && this.#crosshair.windowOf(this.#sliced.volume)) ?? this.#look?.window ?? [0, 1];
  }

  get box(): PlaneBox | null {
    return this.#sliced?.boxAlong(this.#plane) ?? null;
  }

  get frame(): PaneFrame | null {
    const { box } = this;
    return this.#frame ?? (box && fitFrame(box, this.#size));
  }

  /** Shows another volume, or none. @param keep - whether to keep the zoomed frame */
  setVolume(sliced: SlicedVolume | null, keep = false): void {
    if (sliced?.volume !== this.#sliced?.volume) this.#sliced?.volume.finer?.planes?.close(this);
    this.#sliced = sliced;
    if (!keep) this.#frame = null;
  }

  setLook(appearance: SliceAppearance): void {
    const isTurned = appearance.type !== this.#look?.type || String(appearance.normal) !== String(this.#look.normal);
    this.#look = appearance;
    if (!isTurned) return;
    this.#plane = planeOf(appearance.type, appearance.normal);
    this.#frame = null;
  }

  setSize(size: PaneSize, pixelRatio: number): void {
    this.#size = size;
    this.#pixelRatio = pixelRatio;
  }

  /** Draws the present state. */
  draw(): void {
    const { frame } = this;
    const [sliced, appearance, plane, size] = [this.#sliced, this.#look, this.#plane, this.#size];
    if (!sliced || !appearance || !frame || size.width < 1 || size.height < 1) return this.painter.stop();
    const ratio = Math.min(this.#pixelRatio, maxPixels / Math.max(size.width, size.height));
    const { d } = toPlane(plane, this.place);
    const { projection } = appearance;
    const thickness = sliced.thicknessAt(d, { ...appearance, normal: plane.normal });
    const { volume } = sliced;
    const [columns, rows] = [size.width, size.height].map((pixels) => Math.max(1, Math.round(pixels * ratio)));
    const pixelsIn = (across: number, down: number): SlicePixels =>
      pixelsOf(plane, frame, size, { d, columns: across, rows: down });
    const slab = { normal: plane.normal, thickness, projection };
    const { isNearest } = appearance;
    const finer =
      volume.finer?.planes?.open(
        this,
        { ...pixelsIn(columns, rows), way: scale(plane.normal, thickness), isNearest },
        this.changed,
      ) ?? null;
    this.#reading = finer?.done ?? Promise.resolve();
    this.painter.paint({
      columns,
      rows,
      pixelsOf: pixelsIn,
      field: finer ?? sliced.field(isNearest),
      slab: finer ? { ...slab, planes: finer.planes } : slab,
      samples: finer?.planes ?? sliced.planesIn(plane.normal, thickness),
      labels: this.labels,
      painter: appearance.colors
        ? colorPainter(appearance.colors, volume, volume.isDiscrete === true)
        : grayPainter(grayLevels(this.window, appearance.windowFunction, volume), volume),
    });
  }

  /** The crosshair's position in the pane, CSS pixels. */
  get point(): [number, number] | null {
    const { frame } = this;
    return frame && pointAt(frame, this.#size, toPlane(this.#plane, this.place));
  }

  /** Sets the crosshair to a pointer's position in the present slice. @param point - CSS pixels */
  pointTo(point: readonly [number, number]): void {
    const { frame, box } = this;
    if (!frame || !box) return;
    const { u, v } = placeAt(frame, this.#size, point);
    const { d } = toPlane(this.#plane, this.place);
    this.#crosshair.moveTo(
      toWorld(this.#plane, { u: clamp(u, box.low.u, box.high.u), v: clamp(v, box.low.v, box.high.v), d }),
    );
  }

  /** Moves the crosshair by voxels: to the right, up, and along the normal. It stays in the volume's box. */
  stepBy(right: number, up: number, slices: number): void {
    const [sliced, { box }, plane] = [this.#sliced, this, this.#plane];
    if (!sliced || !box) return;
    const { u, v, d } = toPlane(plane, this.place);
    this.#crosshair.moveTo(
      toWorld(plane, {
        u: clamp(u + right * sliced.stepAlong(plane.right), box.low.u, box.high.u),
        v: clamp(v + up * sliced.stepAlong(plane.up), box.low.v, box.high.v),
        d: this.#keepInside(d + slices * sliced.stepAlong(plane.normal)),
      }),
    );
  }

  /** Goes to the slice at a position along the normal, world units. */
  goTo(d: number): void {
    const { u, v } = toPlane(this.#plane, this.place);
    this.#crosshair.moveTo(toWorld(this.#plane, { u, v, d: this.#keepInside(d) }));
  }

  /** The first and the last slice: half a voxel inside the box. World units along the normal. */
  get ends(): readonly [number, number] {
    const [sliced, { box }] = [this.#sliced, this];
    if (!sliced || !box) return [0, 0];
    const half = Math.min(sliced.stepAlong(this.#plane.normal), box.high.d - box.low.d) / 2;
    return [box.low.d + half, box.high.d - half];
  }

  /** Whether there are more slices in a direction: 1 along the normal, -1 against it. */
  hasSlices(direction: number): boolean {
    const [low, high] = this.ends;
    const { d } = toPlane(this.#plane, this.place);
    const tolerance = 1e-6 * (high - low);
    return direction > 0 ? d < high - tolerance : direction < 0 && d > low + tolerance;
  }

  /** @param point - CSS pixels, which stays where it is */
  zoom(factor: number, point: readonly [number, number]): void {
    const [sliced, { box, frame }] = [this.#sliced, this];
    if (!sliced || !box || !frame) return;
    const fit = fitFrame(box, this.#size).scale;
    const finest = Math.min(...sliced.finest.spacing) * zoomRange.voxel;
    const wanted = clamp(frame.scale / factor, Math.min(finest, fit), fit / zoomRange.min);
    this.#frame = zoomFrame(frame, this.#size, frame.scale / wanted, point);
  }

  /** @param by - CSS pixels */
  pan([x, y]: readonly [number, number]): void {
    const { frame, box } = this;
    if (!frame || !box) return;
    const { u, v } = { u: frame.u - x * frame.scale, v: frame.v + y * frame.scale };
    this.#frame = { ...frame, u: clamp(u, box.low.u, box.high.u), v: clamp(v, box.low.v, box.high.v) };
  }

  /** Resets to the whole volume and the page's window. */
  reset(): void {
    this.#frame = null;
    if (this.#sliced) this.#crosshair.setWindow(this.#sliced.volume, null);
  }

  /**
   * Changes the window by a drag: to the right it gets wider, downwards higher, so darker. @param from - the window
   * when the drag began
   */
  windowBy(from: readonly [number, number], [x, y]: readonly [number, number]): void {
    if (!this.#sliced) return;
    const [center, width] = [(from[0] + from[1]) / 2, from[1] - from[0]];
    const wide = clamp(width * Math.exp(x / 150), 1e-30, 1e30);
    const middle = center + (y * width) / 250;
    if (Number.isFinite(middle)) this.#crosshair.setWindow(this.#sliced.volume, [middle - wide / 2, middle + wide / 2]);
  }

  /** Shows values from black to white in all panes of the volume. */
  showWindow(window: readonly [number, number]): void {
    if (this.#sliced) this.#crosshair.setWindow(this.#sliced.volume, window);
  }

  #keepInside(d: number): number {
    const [low, high] = this.ends;
    return clamp(d, low, high);
  }
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, value));
}
