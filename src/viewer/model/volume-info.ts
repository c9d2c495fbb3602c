import type { ProjectionKind, RayStyle, Shading, SurfaceStyle } from '../../optics/rays/ray-style.ts';
import type { Patch } from '../../optics/transfer/patches.ts';
import type { StyleChain } from '../../optics/transfer/volume-styles.ts';
import type { Stop } from '../../optics/transfer/transfer-function.ts';
import type { ChannelInfo } from '../../volume/channels.ts';
import type { Histogram } from '../../volume/histogram.ts';
import type { Lossy, SeriesInfo, SourceInfo, ValueWindow, Volume } from '../../volume/volume.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

export type { ChannelInfo } from '../../volume/channels.ts';

/** What a page can get of a loaded volume: everything except its samples. */
export interface VolumeInfo {
  /** Voxels along i, j and k. */
  readonly dimensions: Vector3;
  /** World units per voxel along i, j and k. */
  readonly spacing: Vector3;
  /** Unit of the data values, or ''. */
  readonly unit: string;
  /** Smallest and largest data value. */
  readonly range: readonly [number, number];
  /** How often each value occurs. */
  readonly histogram: Histogram;
  /** The format of the file, 'NIfTI-1' for instance. */
  readonly format: string;
  /** Row-major 4 x 4: voxel index, whole numbers at voxel centres, to world. */
  readonly indexToWorld: Matrix4;
  /** The series of its files, where they hold several; the attribute `series` chooses one. */
  readonly series?: readonly SeriesInfo[];
  /** Where it comes from, if from the reader's files or from an archive: their kind and number, and no name. */
  readonly source?: SourceInfo;
  /**
   * The windows of its file, where a DICOM file has some: what each is for, and its values of black and white. The attribute `value-window`
   * takes the name or the number, from 1, of one of them.
   */
  readonly windows?: readonly ValueWindow[];
  /** Where it is the colours of several channels: each one that is shown. Its `range` is then that of their brightness. */
  readonly channels?: readonly ChannelInfo[];
  /** The title of the volume, if its manifest has one. */
  readonly title?: string;
  /** Whether the world's axes are those of a patient, as its file says: x to the right, y to the front, z to the head. */
  readonly anatomical?: boolean;
  /** To whom the data belong, if its manifest says so. */
  readonly credit?: string;
  /** For a radar scan: the quantity that is shown, as its file names it. */
  readonly moment?: string;
  /** For a radar scan: all quantities of its file. */
  readonly moments?: readonly string[];
  /** For a radar scan: where the radar is, in degrees north and east, and metres of its antenna above sea level. */
  readonly site?: {
    readonly name?: string;
    readonly latitude?: number;
    readonly longitude?: number;
    readonly height?: number;
  };
  /** For a radar scan: when it began, ISO 8601 in UTC. */
  readonly time?: string;
  /** Set where only the first part of a damaged radar file could be read: what is missing. */
  readonly partial?: string;
  /** For a radar scan: the sweeps that are shown, by ascending elevation: degrees, how many radials and gates, and metres to the first gate and from gate to gate. */
  readonly sweeps?: readonly {
    readonly elevation: number;
    readonly radials: number;
    readonly gates: number;
    readonly firstGate: number;
    readonly gateLength: number;
  }[];
  /**
   * What of the file is not shown, or is shown changed, in words: other sweeps of a radar scan, and why; further volumes; what its
   * header says of values and the viewer does not apply; whole numbers that had to be rounded.
   */
  readonly left?: readonly string[];
  /** The entries of `left` that change what people see: the picture shows a sign for them. */
  readonly notices?: readonly string[];
  /** Set where its manifest says what a lossy form, such as a video, changed: in data values, and in 1/255 of a picture. */
  readonly lossy?: Lossy;
  /** Set where the volume was made smaller to fit the device. */
  readonly reduced?: { readonly from: Vector3; readonly to: Vector3 };
}

/** The appearance of a loaded volume as numbers, from attributes, file and histogram together. */
export interface VolumeOptics {
  /** Colour and opacity by data value, ascending; a preset is given by its stops. */
  readonly transferFunction: readonly Stop[];
  /** Data values that presets and percentages span. */
  readonly window: readonly [number, number];
  /** World length to which the opacity of a stop refers. */
  readonly referenceLength: number;
  /** Multiplies the extinction. */
  readonly opacityFactor: number;
  /** Multiplies the light. */
  readonly lightFactor: number;
  /** Which value of each ray is shown instead of emission and absorption; null for none. */
  readonly projection: ProjectionKind | null;
  /**
   * Only for a projection: it shows the first local maximum from this value on, or the first local minimum up to it. Absent: it
   * shows the maximum or minimum of the whole ray.
   */
  readonly intensityThreshold?: number;
  /** Whether all that emits and absorbs is lit, where there is no projection. */
  readonly shading: Shading;
  /** Surfaces of some values, where there is no projection; null for none. */
  readonly surfaces: SurfaceStyle | null;
  /** X3D's rendering styles, where there are some. */
  readonly styles?: readonly StyleChain[];
  /** Colour and opacity by value and gradient, where there are some; `transferFunction` then is what they show by value alone. */
  readonly patches?: readonly Patch[];
}

/** How rays are drawn, if not by emission and absorption alone; null for that. */
export function styleOf({
  projection,
  intensityThreshold,
  shading,
  surfaces,
  styles,
  patches,
}: VolumeOptics): RayStyle | null {
  if (projection) return { projection, intensityThreshold };
  const lit = shading === 'lit' || (shading !== 'unlit' && shading) || undefined;
  return lit || surfaces || styles || patches ? { lit, styles, patches, ...surfaces } : null;
}

export function describeVolume(volume: Volume): VolumeInfo {
  const { dimensions, spacing, indexToWorld } = volume.grid;
  const { left: notices = volume.left, details = [], ...radar } = volume.radar ?? {};
  const left = notices && [...notices, ...details];
  return {
    dimensions,
    spacing,
    unit: volume.unit,
    range: volume.range,
    histogram: volume.histogram,
    format: volume.format,
    indexToWorld,
    series: volume.series,
    source: volume.source,
    windows: volume.windows,
    channels: volume.channels?.infos,
    title: volume.title,
    anatomical: volume.anatomical,
    credit: volume.credit,
    ...radar,
    left,
    notices,
    lossy: volume.lossy,
    reduced: volume.reduced,
  };
}
