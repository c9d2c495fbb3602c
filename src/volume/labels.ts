import type { Vector3 } from './matrix.ts';

/** Which thing each voxel of a volume is of: an atlas, a segmentation. On the volume's own grid. */
export interface LabelMap {
  /** Voxels along i, j and k: the volume's own. */
  readonly dimensions: Vector3;
  /** Of each voxel, in the order of the volume's samples: where its label stands in `ids`. At most 65,536 labels. */
  readonly numbers: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /** The file's ids, whole numbers that rise, negative ones among them. The first is of what has no label, 0 as a rule. */
  readonly ids: readonly number[];
}

/** What a file says of one of its labels. */
export interface NamedLabel {
  readonly id: number;
  /** '' where it says none. */
  readonly name: string;
  /** sRGB, 0..1; null where it says none. */
  readonly color: readonly [number, number, number] | null;
}

/** What a file calls one of its labels; null where it says nothing. */
export function nameInFile({ named }: { readonly named?: readonly NamedLabel[] }, id: number | null): string | null {
  return named?.find((label) => label.id === id)?.name || null;
}

/** What a label looks like. */
export interface LabelStyle {
  /** Red, green, blue from 0 to 1, by which the volume's own colours are multiplied. */
  readonly color: readonly [number, number, number];
  /** The volume's own extinction is multiplied by it: 0 hides, 1 changes nothing. */
  readonly opacityFactor: number;
  /** Which of the labels' transfer functions it has, from 1; 0, or absent: the volume's own. */
  readonly group?: number;
}

/** A stop of a transfer function: value in data units, straight colour and opacity 0..1. */
export interface LabelStop {
  readonly value: number;
  readonly color: readonly [number, number, number];
  readonly opacity: number;
}

/** Transfer functions of labels, beside the volume's own. */
export const mostGroups = 4;

/** Labels as they are to be seen. */
export interface ShownLabels {
  readonly map: LabelMap;
  /** One for each of the map's ids. */
  readonly styles: readonly LabelStyle[];
  /** Transfer functions of groups of labels, at most `mostGroups`. Kept while they are the same. */
  readonly functions?: readonly (readonly LabelStop[])[];
}
