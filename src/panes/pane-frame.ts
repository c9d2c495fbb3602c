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

/** The part of a plane that a pane shows. */
export interface PaneFrame {
  /** Coordinates of its centre. */
  readonly u: number;
  readonly v: number;
  /** World units per CSS pixel. */
  readonly scale: number;
}

/** The box around some points of the world, along a plane's directions. */
export interface PlaneBox {
  readonly low: PlanePlace;
  readonly high: PlanePlace;
}

export function boxAround(plane: SlicePlane, places: readonly Vector3[]): PlaneBox {
  const all = places.map((place) => toPlane(plane, place));
  const pick = (choose: (...values: number[]) => number): PlanePlace => ({
    u: choose(...all.map(({ u }) => u)),
    v: choose(...all.map(({ v }) => v)),
    d: choose(...all.map(({ d }) => d)),
  });
  return { low: pick(Math.min), high: pick(Math.max) };
}

/** The frame in which a box just fits. */
export function fitFrame({ low, high }: PlaneBox, { width, height }: PaneSize): PaneFrame {
  return {
    u: (low.u + high.u) / 2,
    v: (low.v + high.v) / 2,
    scale: Math.max((high.u - low.u) / width, (high.v - low.v) / height),
  };
}

/**
 * Scales a frame by a factor, around a point of the pane that stays where it is: CSS pixels from the left and from
 * above.
 */
export function zoomFrame(
  frame: PaneFrame,
  size: PaneSize,
  factor: number,
  [x, y]: readonly [number, number],
): PaneFrame {
  const by = frame.scale * (1 - 1 / factor);
  return {
    u: frame.u + (x - size.width / 2) * by,
    v: frame.v - (y - size.height / 2) * by,
    scale: frame.scale / factor,
  };
}

/** The point of the plane at a point of the pane. */
export function placeAt(
  frame: PaneFrame,
  { width, height }: PaneSize,
  [x, y]: readonly [number, number],
): { u: number; v: number } {
  return { u: frame.u + (x - width / 2) * frame.scale, v: frame.v - (y - height / 2) * frame.scale };
}

/** The point of the pane at a point of the plane: CSS pixels from the left and from above. */
export function pointAt(
  frame: PaneFrame,
  { width, height }: PaneSize,
  { u, v }: { u: number; v: number },
): [number, number] {
  return [width / 2 + (u - frame.u) / frame.scale, height / 2 - (v - frame.v) / frame.scale];
}

/**
 * The pixels of a pane. @param d - position of its slice
 * @param columns, rows - number of pixels
 */
export function pixelsOf(
  plane: SlicePlane,
  frame: PaneFrame,
  size: PaneSize,
  { d, columns, rows }: { d: number; columns: number; rows: number },
): SlicePixels {
  const [wide, tall] = [size.width / columns, size.height / rows];
  const across = scale(plane.right, wide * frame.scale);
  const down = scale(plane.up, -tall * frame.scale);
  const corner = toWorld(plane, { ...placeAt(frame, size, [0, 0]), d });
  return { width: columns, height: rows, first: add(corner, scale(add(across, down), 0.5)), across, down };
}

/** The longest round length, 1, 2 or 5 times a power of ten, that is at most a given one. */
export function roundLength(max: number): number {
  const power = 10 ** Math.floor(Math.log10(max));
  return [5, 2, 1].map((times) => times * power).find((length) => length <= max * (1 + 1e-12)) ?? power;
}
