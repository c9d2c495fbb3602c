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

/** What a label looks like. */
export interface LabelStyle {
  /** Red, green, blue from 0 to 1, by which the volume's own colours are multiplied. */
  readonly color: readonly [number, number, number];
  /** The volume's own extinction is multiplied by it: 0 hides, 1 changes nothing. */
  readonly opacityFactor: number;
}

/** Labels as they are to be seen. */
export interface ShownLabels {
  readonly map: LabelMap;
  /** One for each of the map's ids. */
  readonly styles: readonly LabelStyle[];
}
