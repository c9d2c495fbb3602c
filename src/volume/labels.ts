import type { Vector3 } from './matrix.ts';

/** The label of each voxel of a volume, from an atlas or a segmentation. On the volume's own grid. */
export interface LabelMap {
  /** Voxels along i, j and k: the volume's own. */
  readonly dimensions: Vector3;
  /** For each voxel, in the order of the volume's samples: the index of its label in `ids`. At most 65,536 labels. */
  readonly numbers: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /**
   * The file's ids: whole numbers, ascending, possibly negative. The first one is for voxels without a label, normally
   * 0.
   */
  readonly ids: readonly number[];
}

/** What a file says about one of its labels. */
export interface NamedLabel {
  readonly id: number;
  /** '' if the file gives none. */
  readonly name: string;
  /** sRGB, 0..1; null if the file gives none. */
  readonly color: readonly [number, number, number] | null;
}

/** The file's name of one of its labels; null if it gives none. */
export function nameInFile({ named }: { readonly named?: readonly NamedLabel[] }, id: number | null): string | null {
  return named?.find((label) => label.id === id)?.name || null;
}

/** The appearance of a label. */
export interface LabelStyle {
  /** Red, green, blue from 0 to 1. The volume's own colours are multiplied by it. */
  readonly color: readonly [number, number, number];
  /** The volume's own extinction is multiplied by it: 0 hides, 1 changes nothing. */
  readonly opacityFactor: number;
  /** The number of one of the labels' transfer functions, from 1; 0, or absent: the volume's own. */
  readonly group?: number;
}

/** A stop of a transfer function: value in data units, straight colour and opacity 0..1. */
export interface LabelStop {
  readonly value: number;
  readonly color: readonly [number, number, number];
  readonly opacity: number;
}

/** Maximum number of transfer functions of labels, in addition to the volume's own. */
export const maxGroups = 4;

/** Labels with the appearance in which they are drawn. */
export interface ShownLabels {
  readonly map: LabelMap;
  /** One for each of the map's ids. */
  readonly styles: readonly LabelStyle[];
  /** Transfer functions of groups of labels, at most `maxGroups`. The same array while they do not change. */
  readonly functions?: readonly (readonly LabelStop[])[];
}
