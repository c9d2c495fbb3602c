import type { ChannelColors } from './channels.ts';
import type { FinerLevel, FinerVoxels } from './finer-voxels.ts';
import type { CartesianGrid } from './grid.ts';
import type { Histogram } from './histogram.ts';
import type { IndexedSamples, Rounded, Unkept } from './index-numbers.ts';
import type { NamedLabel } from './labels.ts';
import type { Macrocells } from './macrocells.ts';
import type { Vector3 } from './matrix.ts';
import type { PolarGrid } from './polar-grid.ts';
import type { Samples } from './samples.ts';

export type { Samples } from './samples.ts';

/** The positions of a volume's samples. */
export type Grid = CartesianGrid | PolarGrid;

/** The values of a volume, and where they are: all that drawing, picking and measuring need. */
export interface VolumeData {
  readonly grid: Grid;
  /**
   * Cartesian: `dimensions[0] * dimensions[1] * dimensions[2]` stored values, i fastest; NaN (float only) means no data.
   * Polar: sweep after sweep, radial after radial, gate after gate; 0 (integers) or NaN (float) means no data.
   */
  readonly samples: Samples;
  /** Data value = slope * sample + intercept, in `unit`; but see `ids`. */
  readonly slope: number;
  readonly intercept: number;
  /** Unit of the data values ('HU', 'dBZ', ...); '' if unknown. */
  readonly unit: string;
  /** Smallest and largest valid data value, in `unit`. */
  readonly range: readonly [number, number];
  /** Counts of valid data values over `range`. */
  readonly histogram: Histogram;
  /** Ranges of stored values in blocks of voxels. */
  readonly macrocells: Macrocells;
  /** Whether any sample has no data. */
  readonly hasNoData: boolean;
  /**
   * Whether values stand for things, as labels do: there are no values between two of them, and a point has the value
   * of one of the eight samples around it.
   */
  readonly isDiscrete?: boolean;
  /**
   * For labels whose samples are indices into this list, with slope 1 and intercept 0: the ids of the file, ascending.
   * The renderer uses the indices as values.
   */
  readonly ids?: readonly number[];
  /** The file's exact whole numbers, if `samples` rounds them; absent if there are too many different ones. */
  readonly indexed?: IndexedSamples;
  /** Set where whole numbers are rounded that are not in `indexed`. */
  readonly rounded?: Rounded;
  /** Set where samples can't keep all numbers of a file of floats. */
  readonly unkept?: Unkept;
  /** Set where `samples` is the brightness of several channels, or of colours: their light, and their own values. Cartesian only. */
  readonly channels?: ChannelColors;
  /** Set where finer voxels lie over some places of it: samples are then those of a coarser level of its pyramid. Cartesian only. */
  readonly finer?: FinerVoxels;
}

/** One of the series, or of the volumes, in the files that a volume comes from. Nothing of it says whose it is. */
export interface SeriesInfo {
  /** From 1: the attribute `series` of this number shows it. */
  readonly number: number;
  /** Whether it is the one that is shown. */
  readonly shown: boolean;
  /** DICOM's code of the kind of device, 'CT' or 'MR' for instance; '' where it is not known. */
  readonly modality: string;
  /** Where the files hold volumes of several formats, or several files of a volume each: the format of its files. */
  readonly format?: string;
  /** Of a volume that was not read, the number of its files, and their bytes as they lie on the disk or are unpacked. */
  readonly files?: number;
  readonly bytes?: number;
  /** The number that the scanner gave it; absent where there is none. */
  readonly seriesNumber?: number;
  /** Voxels of a row, of a column, and slices; absent where it was not read, and for a radar's scan. */
  readonly dimensions?: Vector3;
  /** The plane of the patient that its slices are next to; absent where its files do not say it. */
  readonly plane?: 'axial' | 'coronal' | 'sagittal' | 'oblique';
  /** From voxel to voxel along a row, along a column, and from slice to slice, in mm; absent where its files do not say it. */
  readonly spacing?: Vector3;
  /** Its middle slice, made small: brightness from 0 to 255, row by row from the top; absent where it could not be made. */
  readonly picture?: {
    readonly width: number;
    readonly height: number;
    /** Width of the slice through its height, in the world. */
    readonly aspect: number;
    readonly pixels: Uint8ClampedArray;
  };
}

/** Files, or an archive, that a volume was found in. */
export interface SourceInfo {
  /** `files` of the reader's disk, an `archive`, or a series on a `DICOMweb` server. */
  readonly kind: 'files' | 'archive' | 'DICOMweb';
  /** Number of files, those without a volume included. */
  readonly count: number;
}

/** Sizes of differences. */
export interface LossyError {
  /** Root mean square. */
  readonly rms: number;
  /** 99 % are at most so large. */
  readonly p99: number;
  readonly max: number;
}

/** How far a volume is from the one before a lossy form, such as a video, was made of it: in data values. */
export interface Lossy extends LossyError {
  /** The same in a picture, 1/255. */
  readonly picture?: LossyError;
}

/** Where a volume comes from: what its file says about it, and what was changed on its way. */
export interface Provenance {
  /** The format of the file: 'NIfTI-1', 'PNG mosaic', ... */
  readonly format: string;
  /** Whether the file says that the world's axes are a patient's: x to the right, y to the front, z to the head. */
  readonly anatomical?: boolean;
  /** Set for volumes from radar files: what the file says about the scan. */
  readonly radar?: RadarInfo;
  /** Set where its files hold several series or volumes. */
  readonly series?: readonly SeriesInfo[];
  /** Set where it comes from the reader's files, or from an archive. */
  readonly source?: SourceInfo;
  readonly title?: string;
  readonly credit?: string;
  /** What the file itself says about its labels. */
  readonly named?: readonly NamedLabel[];
  /** What of the file is not in it, or not as it is there, and changes what is seen, in words; absent where all is. */
  readonly left?: readonly string[];
  /** Set where its manifest says what a lossy form changed. */
  readonly lossy?: Lossy;
  /** Set when the volume was made smaller to fit the device. */
  readonly reduced?: { readonly from: Vector3; readonly to: Vector3 };
  /** Set where it is a coarse level of a pyramid of which finer levels, the finest first, can be read in bricks as a view needs them. */
  readonly levels?: readonly FinerLevel[];
  /** Set for a small stand-in of a large volume; range, histogram and `hasNoData` are those of the large one. */
  readonly coarse?: true;
}

/** A window that a file has for its values, as DICOM files of CT and MRI do. */
export interface ValueWindow {
  /** What it is for, in lower case, where that is one of a few well-known words: 'lung', 'bone', 'brain'; else 'Window 2'. */
  readonly name: string;
  /** The value that is black, with all below it. */
  readonly from: number;
  /** The value that is white, with all above it. */
  readonly to: number;
  /** Its width, as the file says it: of whole numbers it may be larger by 1 than `to` less `from`. */
  readonly width: number;
  /** Its middle, as the file says it. */
  readonly level: number;
}

/** How a volume is shown: from its file or manifest, else suggested by its values. Attributes override these. */
export interface OwnAppearance {
  readonly window?: readonly [number, number];
  /** The windows of its file, the first of which is `window`, if that is not from elsewhere. */
  readonly windows?: readonly ValueWindow[];
  readonly transferFunction?: string;
  readonly referenceLength?: number;
}

/**
 * A scalar volume: its data, where they come from, and how they want to be shown. It is plain data, because workers send
 * it to their page. What needs a part of it takes that part's type.
 */
export interface Volume extends VolumeData, Provenance, OwnAppearance {}

/** A volume on a radar's grid. */
export type PolarVolume = Volume & { readonly grid: PolarGrid };

/** The data of such a volume. */
export type PolarData = VolumeData & { readonly grid: PolarGrid };

export function isPolar<V extends { readonly grid: Grid }>(volume: V): volume is V & { readonly grid: PolarGrid } {
  return volume.grid.kind === 'polar';
}

/** Whether a volume is one slice, as a radiograph is, or one time of a film. */
export function isSingleSlice({ kind, dimensions }: Pick<Grid, 'kind' | 'dimensions'>): boolean {
  return kind !== 'polar' && dimensions.filter((n) => n === 1).length === 1;
}

/** One sweep of a radar scan, in numbers. */
export interface SweepInfo {
  /** Degrees above the horizon. */
  readonly elevation: number;
  /** Radials in the file. */
  readonly radials: number;
  /** Along each radial. */
  readonly gates: number;
  /** Metres along the beam, from the antenna to the middle of the first gate. */
  readonly firstGate: number;
  /** Metres from gate to gate. */
  readonly gateLength: number;
}

/** What a radar file says about its scan. */
export interface RadarInfo {
  /** The moment that the volume holds, by the file's name. */
  readonly moment: string;
  /** All moments of the file. */
  readonly moments: readonly string[];
  /** Degrees north, degrees east, metres above sea level of the antenna; what the file does not say is absent. */
  readonly site: {
    readonly name?: string;
    readonly latitude?: number;
    readonly longitude?: number;
    readonly height?: number;
  };
  /** When the scan began, ISO 8601 in UTC. */
  readonly time?: string;
  /** The sweeps that are shown, by ascending elevation. */
  readonly sweeps: readonly SweepInfo[];
  /** What of the file is not shown, and why, and what had to be assumed, where that changes what is seen. */
  readonly left: readonly string[];
  /** The same where it changes nothing that is seen, such as a sweep at an elevation that another one has. */
  readonly details: readonly string[];
  /** Set where only the first part of a damaged file could be read: what is missing. */
  readonly partial?: string;
}
