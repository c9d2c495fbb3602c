// Where notes stand in a pane of a slice, and on which side of its pin each name has room. CSS pixels from the pane's left and top edge.
import { pointAt } from '../../panes/pane-frame.ts';
import type { PaneSize } from '../../panes/pane-frame.ts';
import type { SlicePane } from '../../panes/slice-pane.ts';
import { toPlane } from '../../panes/slice-plane.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Pixel } from '../camera/drag-place.ts';

/** A note in a pane. */
export interface PanePlace {
  readonly point: Pixel;
  /** Whether its place is in the slice; else it is near it. */
  readonly isOn: boolean;
}

/** A place is near a slice up to this distance, in thicknesses of the slice. */
const nearby = 3;

/** Half the width of a pin, the distance from its middle to its name, and from a name to the edge of the pane. */
const [pinRadius, nameOffset, edge] = [7, 10, 4];

/**
 * The place of a note in the picture of a pane. It is in the slice up to half of the slice's thickness from its middle; a slice without
 * thickness has that of a voxel.
 * @returns null where the pane does not show it
 */
export function placeInPane(pane: SlicePane, at: Vector3): PanePlace | null {
  const { sliced, frame, plane, size, look } = pane;
  if (!sliced || !frame || !look) return null;
  const middle = toPlane(plane, pane.place).d;
  const { d, ...uv } = toPlane(plane, at);
  const thickness = Math.max(
    sliced.thicknessAt(middle, { ...look, normal: plane.normal }),
    sliced.stepAlong(plane.normal),
  );
  const distance = Math.abs(d - middle) / thickness;
  const point = pointAt(frame, size, uv);
  const isInside = point[0] >= 0 && point[1] >= 0 && point[0] <= size.width && point[1] <= size.height;
  // The middle of a voxel is computed with rounding.
  return isInside && distance <= nearby ? { point, isOn: distance <= 0.5 + 1e-6 } : null;
}

/** A pin with a name. */
export interface NamedPin {
  readonly point: Pixel;
  /** Width of the name; 0 for none. */
  readonly width: number;
}

/**
 * The left edge of each name, next to its pin: right of it, or left where there is no room.
 * @param line - height of a name
 * @returns null for a name that would cover a pin or another name, or leave the pane
 */
export function placeNames(
  pins: readonly NamedPin[],
  { width: wide, height }: PaneSize,
  line: number,
): (number | null)[] {
  const names: { readonly left: number; readonly right: number; readonly y: number }[] = [];
  return pins.map(({ point: [x, y], width }) => {
    if (width <= 0 || y < line / 2 || y > height - line / 2) return null;
    for (const left of [x + nameOffset, x - nameOffset - width]) {
      const right = left + width;
      if (left < edge || right > wide - edge) continue;
      const coversPin = pins.some(
        ({ point: [px, py] }) =>
          px > left - pinRadius && px < right + pinRadius && Math.abs(py - y) < line / 2 + pinRadius,
      );
      const coversName = names.some((one) => one.left < right && left < one.right && Math.abs(one.y - y) < line);
      if (coversPin || coversName) continue;
      names.push({ left, right, y });
      return left;
    }
    return null;
  });
}
