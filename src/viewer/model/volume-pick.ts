import type { PickAt } from '../../optics/pick-ray.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** How a script picks. */
export interface PickOptions {
  /**
   * `jump` (by default): where the opacity jumps most on the way into the picture; `surface`: where it passes a half; `max`:
   * where the largest value is that shows.
   */
  readonly at?: PickAt;
}

/** What is at a place of the picture that somebody pointed at. */
export interface VolumePick {
  /** Of the nearest voxel or gate that has data: a value that is in the file. Of a volume of labels that of the place. NaN on a surface, or in a layer, where the volume has none. */
  readonly value: number;
  /** Of the place itself, as the picture has it: interpolated between voxels or gates. Of a label map it is the same as `value`. */
  readonly interpolated: number;
  /** Where the place is on one of the surfaces of `surface-values`: its value. */
  readonly isoValue?: number;
  /** Unit of the values, or ''. */
  readonly unit: string;
  /** Number of that voxel along i, j and k, from 0, as `indexToWorld` of `volume` counts them; null for a radar, and where there is none. */
  readonly voxel: Vector3 | null;
  /** World coordinates of the place: of medical files mm to the patient's right, front and head; of a radar metres east, north and up, with the exaggeration of heights. */
  readonly world: Vector3;
  /** The label's id: of `<volume-labels>`, or of a volume that is labels itself; absent where there is none. */
  readonly label?: string;
  /** What `<volume-labels>` calls that label. */
  readonly labelName?: string;
  /** What `<volume-layer>`, or the `color-moment` of a radar, has at that place; absent where there is none over the volume. */
  readonly layers?: readonly LayerValue[];
  /** How opaque the picture is there, 0..1. */
  readonly opacity: number;
  /** Colour that the transfer function gives this place, '#rrggbb'. */
  readonly color: string;
  /** Where the radar sees it; null for other volumes, and on a surface, which tells it itself. */
  readonly radar: RadarPlace | null;
  /** The surface that is there, in place of what the volume shows; absent where there is none. */
  readonly surface?: PickedSurface;
}

/** A surface that somebody pointed at. */
export interface PickedSurface {
  readonly type: 'surface' | 'terrain';
  /** The `<volume-surface>` or `<volume-terrain>`. */
  readonly element: Element;
  /** Where the radar sees the place; null for other volumes. */
  readonly radar: Omit<RadarPlace, 'gate'> | null;
}

/** A second volume at a place. */
export interface LayerValue {
  /** What it is called; '' where nobody says. */
  readonly name: string;
  /** Interpolated; null where it has no data. */
  readonly value: number | null;
  /** Unit of its values, or ''. */
  readonly unit: string;
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
  /** The gate that `value` is of. */
  readonly gate: RadarGate;
}

/** One gate of a radar, and its middle. */
export interface RadarGate {
  /** Number of the sweep among those of the volume, the lowest being 0. */
  readonly sweep: number;
  /** Number of the radial in it, by ascending azimuth from 0. */
  readonly radial: number;
  /** Number of the gate on it, from 0. */
  readonly gate: number;
  /** Metres. */
  readonly range: number;
  /** Degrees. */
  readonly azimuth: number;
  /** Degrees. */
  readonly elevation: number;
}
