import { add, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { SlicePixels } from './fill-slice.ts';
import { toPlane, toWorld } from './slice-plane.ts';
import type { PlanePlace, SlicePlane } from './slice-plane.ts';

/** CSS pixels. */
export interface PaneSize {
  readonly width: number;
  readonly height: number;
}

/** What of a plane a pane shows. */
export interface PaneFrame {
  /** In its middle. */
  readonly u: number;
  readonly v: number;
  /** World units of a CSS pixel. */
  readonly scale: number;
}

/** The box around some places of the world, along a plane's directions. */
export interface PlaneBox {
  readonly low: PlanePlace;
  readonly high: PlanePlace;
}

export function boxAround(plane: SlicePlane, places: readonly Vector3[]): PlaneBox {
  const all = places.map((place) => toPlane(plane, place));
  const pick = (choose: (...values: number[]) => number): PlanePlace =>
    ({ u: choose(...all.map(({ u }) => u)), v: choose(...all.map(({ v }) => v)), d: choose(...all.map(({ d }) => d)) });
  return { low: pick(Math.min), high: pick(Math.max) };
}

/** All of a box, as large as it fits. */
export function fitFrame({ low, high }: PlaneBox, { width, height }: PaneSize): PaneFrame {
  return { u: (low.u + high.u) / 2, v: (low.v + high.v) / 2, scale: Math.max((high.u - low.u) / width, (high.v - low.v) / height) };
}

/** Larger or smaller by a factor, around a place of the pane that stays where it is: CSS pixels from the left and from above. */
export function zoomFrame(frame: PaneFrame, size: PaneSize, factor: number, [x, y]: readonly [number, number]): PaneFrame {
  const by = frame.scale * (1 - 1 / factor);
  return { u: frame.u + (x - size.width / 2) * by, v: frame.v - (y - size.height / 2) * by, scale: frame.scale / factor };
}

/** Where a place of the pane is on its plane. */
export function placeAt(frame: PaneFrame, { width, height }: PaneSize, [x, y]: readonly [number, number]): { u: number; v: number } {
  return { u: frame.u + (x - width / 2) * frame.scale, v: frame.v - (y - height / 2) * frame.scale };
}

/** Where a place of the plane is in the pane: CSS pixels from the left and from above. */
export function pointAt(frame: PaneFrame, { width, height }: PaneSize, { u, v }: { u: number; v: number }): [number, number] {
  return [width / 2 + (u - frame.u) / frame.scale, height / 2 - (v - frame.v) / frame.scale];
}

/** The pixels of a pane. @param d - of its slice @param columns, rows - how many */
export function pixelsOf(plane: SlicePlane, frame: PaneFrame, size: PaneSize, { d, columns, rows }: { d: number; columns: number; rows: number }): SlicePixels {
  const [wide, tall] = [size.width / columns, size.height / rows];
  const across = scale(plane.right, wide * frame.scale);
  const down = scale(plane.up, -tall * frame.scale);
  const corner = toWorld(plane, { ...placeAt(frame, size, [0, 0]), d });
  return { width: columns, height: rows, first: add(corner, scale(add(across, down), 0.5)), across, down };
}

/** The longest round length, 1, 2 or 5 times a power of ten, that is not longer than another. */
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((times) => times * power).find((length) => length <= most * (1 + 1e-12)) ?? power;
}
