import { transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import type { ShownLabels } from '../volume/labels.ts';
import type { SlicePixels } from './fill-slice.ts';
import { visitPixels } from './visit-pixels.ts';

/** Labels as a pane draws and names them. */
export interface PaneLabels {
  /**
   * Colours some rows of a grey picture, RGBA; transparent pixels stay transparent. @param rows - the first, and the
   * one after the last
   */
  paint(pixels: SlicePixels, picture: Uint8ClampedArray, rows: readonly [number, number]): void;
  /** The name of the label at a point of the world; null if there is none. */
  nameAt(place: Vector3): string | null;
}

/** The position of labels, their names, and how they cover the grey. */
export interface PaneLabelsSetting {
  readonly worldToIndex: Matrix4;
  readonly nameOf: (id: number) => string | null;
  /** Opacity of a label that is not hidden, 0..1. */
  readonly opacity: number;
}

/** Each pixel has the label of the voxel that it is in; in a slab, of the voxel in its middle. */
export function paneLabels(
  { map, styles }: ShownLabels,
  { worldToIndex, nameOf, opacity }: PaneLabelsSetting,
): PaneLabels {
  const {
    dimensions: [nx, ny, nz],
    numbers,
    ids,
  } = map;
  /** 0, which means no label, outside of all voxels. */
  const numberAt = (x: number, y: number, z: number): number => {
    const [i, j, k] = [Math.floor(x + 0.5), Math.floor(y + 0.5), Math.floor(z + 0.5)];
    return i >= 0 && i < nx && j >= 0 && j < ny && k >= 0 && k < nz ? numbers[i + nx * (j + ny * k)] : 0;
  };
  const shares = styles.map(({ opacityFactor }, number) => (number === 0 ? 0 : Math.min(1, opacityFactor) * opacity));
  const colors = styles.map(({ color }) => color.map((channel) => 255 * channel));
  return {
    paint(pixels, picture, rows) {
      visitPixels(pixels, worldToIndex, rows, (at, x, y, z) => {
        const number = numberAt(x, y, z);
        const share = shares[number];
        if (share === 0) return;
        for (let channel = 0; channel < 3; channel++)
          picture[at + channel] += share * (colors[number][channel] - picture[at + channel]);
      });
    },
    nameAt(place) {
      const number = numberAt(...transformPoint(worldToIndex, place));
      return number === 0 ? null : nameOf(ids[number]);
    },
  };
}
