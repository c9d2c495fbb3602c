import type { PickAt } from '../../optics/pick-ray.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** Options of a pick by a script. */
export interface PickOptions {
  /**
   * `jump` (by default): where the opacity increases most on the way into the picture; `surface`: where it exceeds one half;
   * `max`: where the largest visible value is; `half`: where half of the final opacity is reached.
   */
  readonly at?: PickAt;
  /**
   * Of a volume in bricks: whether the finest voxel of the place is read first, which may take a request. Else the value is that of the finest voxel that
   * is there.
   * @default true
   */
  readonly finest?: boolean;
}

/** What is at the place of the picture that somebody pointed at. */
export interface VolumePick {
  /**
   * Value of the nearest voxel or gate that has data: a value from the file. In a volume of labels, the value at the place. NaN on
   * a surface, or in a layer, where the volume has no value.
   */
  readonly value: number;
  /** Value at the place itself, interpolated between voxels or gates as in the picture. In a label map it is the same as `value`. */
  readonly interpolated: number;
  /** If the place is on one of the surfaces of `surface-values`: the value of that surface. */
  readonly isoValue?: number;
  /** Unit of the values, or ''. */
  readonly unit: string;
  /**
   * Indices of that voxel along i, j and k, from 0, as `indexToWorld` of `volume` counts them; null for a radar, and where there
   * is no such voxel.
   */
  readonly voxel: Vector3 | null;
  /**
   * World coordinates of the place: for medical files mm to the patient's right, front and head; for a radar metres east, north
   * and up, with the exaggeration of heights.
   */
  readonly world: Vector3;
  /** The label's id: from `<volume-labels>`, or from a volume that is itself labels; absent where there is no label. */
  readonly label?: string;
  /** Name of that label in `<volume-labels>`. */
  readonly labelName?: string;
  /** Values of the channels of a volume of several, of `<volume-layer>`, or of the `color-moment` of a radar, at that place; absent where no such layer is over the volume. */
  readonly layers?: readonly LayerValue[];
  /** Opacity of the picture at the place, 0..1. */
  readonly opacity: number;
  /** Colour of the place by the transfer function, '#rrggbb'. */
  readonly color: string;
  /** The place as the radar sees it; null for other volumes, and on a surface: see `radar` of `surface`. */
  readonly radar: RadarPlace | null;
  /** The surface at the place, if it hides the volume there; absent where there is none. */
  readonly surface?: PickedSurface;
}

/** A place in the volume that is seen at a point of the picture: where half of the final opacity of the ray through this point is reached. */
export interface VolumePosition {
  /**
   * The place, as `position` of a `<volume-note>` has it: for medical files mm to the patient's right, front and head; for a radar metres
   * east, north and above the antenna, before the exaggeration of heights.
   */
  readonly position: Vector3;
  /** Value of the nearest voxel or gate that has data; NaN on a surface, or in a layer, where the volume has no value. */
  readonly value: number;
  /** Unit of the value, or ''. */
  readonly unit: string;
  /** The share of the light from this place that reaches the eye, 0..1; 1 in a projection. */
  readonly transmittance: number;
  /** The label's id; absent where there is no label. */
  readonly label?: string;
  /** Name of that label. */
  readonly labelName?: string;
  /** The place on Earth; null for volumes other than a radar's, and where the file does not say where the radar is. */
  readonly earth: EarthPlace | null;
}

/** A place on Earth, as the attributes of a `<volume-note>` have it. */
export interface EarthPlace {
  /** Degrees north. */
  readonly latitude: number;
  /** Degrees east. */
  readonly longitude: number;
  /** Metres above sea level where the file gives the altitude of the radar, else above its antenna. */
  readonly height: number;
}

/** A surface that a person pointed at. */
export interface PickedSurface {
  readonly type: 'surface' | 'terrain';
  /** The `<volume-surface>` or `<volume-terrain>`. */
  readonly element: Element;
  /** Where the radar sees the place; null for other volumes. */
  readonly radar: Omit<RadarPlace, 'gate'> | null;
}

/** The value of a second volume, or of a channel, at a place. */
export interface LayerValue {
  /** The name of the volume; '' where it has none. */
  readonly name: string;
  /** Of a channel the value of the nearest voxel that has data, of another volume interpolated; null where it has no data. */
  readonly value: number | null;
  /** Unit of its values, or ''. */
  readonly unit: string;
  /** The number of the channel, from 1; absent for another volume. */
  readonly channel?: number;
}

/** A place as a radar sees it, with the 4/3 Earth of the standard atmosphere. */
export interface RadarPlace {
  /** Metres along the beam from the antenna. */
  readonly range: number;
  /** Degrees clockwise from north. */
  readonly azimuth: number;
  /** Degrees above the horizon. */
  readonly elevation: number;
  /** Metres. */
  readonly heightAboveAntenna: number;
  /** Metres; null where the file does not say how high the antenna is. */
  readonly heightAboveSea: number | null;
  /** Degrees north of the point below; null where the file does not say where the radar is. */
  readonly latitude: number | null;
  /** Degrees east. */
  readonly longitude: number | null;
  /** The gate that has `value`. */
  readonly gate: RadarGate;
}

/** One gate of a radar, and its middle. */
export interface RadarGate {
  /** Number of the sweep in the volume; the lowest sweep is 0. */
  readonly sweep: number;
  /** Number of the radial in its sweep, by ascending azimuth from 0. */
  readonly radial: number;
  /** Number of the gate on its radial, from 0. */
  readonly gate: number;
  /** Metres. */
  readonly range: number;
  /** Degrees. */
  readonly azimuth: number;
  /** Degrees. */
  readonly elevation: number;
}
