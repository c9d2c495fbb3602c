import type { CartesianGrid } from '../../volume/grid.ts';
import type { Macrocells } from '../../volume/macrocells.ts';
import type { Matrix4 } from '../../volume/matrix.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ChannelUse } from './channels.ts';
import type { ScanTarget } from './choose-scan.ts';
import type { MosaicValues } from './radar-settings.ts';
import type { SourceSettings } from './source-settings.ts';

/** What a format's reader returns: a volume, except for what is computed from its samples. */
export type DecodedVolume = DecodedCartesianVolume | DecodedPolarVolume;

type Decoded = Omit<
  Volume,
  'grid' | 'range' | 'histogram' | 'macrocells' | 'hasNoData' | 'coarse' | 'isDiscrete' | 'referenceLength'
>;

/** The colours of a file. */
export interface FileColors {
  /** Red, green and blue of each voxel, 0..255. */
  readonly rgb: Uint8Array<ArrayBuffer>;
  /** The data values of black and of white. */
  readonly range: readonly [black: number, white: number];
}

export type DecodedCartesianVolume = Decoded & {
  readonly grid: CartesianGrid;
  /** Whether the file says that its values are labels: whole numbers that stand for things. */
  readonly isLabels?: boolean;
  /** Whether the file says that its values are the uptake of a tracer, as PET shows it. */
  readonly isUptake?: boolean;
  /** Of a volume in colours, whose values are their brightness. */
  readonly colors?: FileColors;
  /** How often each sample occurs, for whole numbers: where the reader has counted them, nothing else does. */
  readonly counts?: Uint32Array<ArrayBuffer>;
  /** NIfTI's intent code: what the values are. */
  readonly intent?: number;
};

export type DecodedPolarVolume = Decoded & {
  readonly grid: PolarGrid;
  /** Making a sweep's macrocells takes long, and only the radar code knows how. */
  readonly makeMacrocells: () => Macrocells;
  /** Where values are kinds of echo: the smallest and the largest that can occur. */
  readonly kinds?: readonly [number, number];
};

/** What attributes or a manifest say about a file's data. */
export interface DecodeSettings extends SourceSettings {
  /** Which scan of a manifest, or of a file of several volumes, to load; the first if undefined. */
  readonly scan?: ScanTarget;
  /** See `LoadRequest`. */
  readonly finer?: boolean;
  /** How an image's channels make one number; gray if undefined. */
  readonly channels?: ChannelUse;
  /** What the pixels of a radar's mosaic stand for, from a manifest. */
  readonly values?: MosaicValues;
  /** Row-major; overrides spacing and the file's own. */
  readonly indexToWorld?: Matrix4;
}

/** Bytes to decode, and their origin. */
export interface DecodeInput {
  /** The reader takes the buffer over: the caller must not use it again. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Absolute. */
  readonly url: string;
  /** MIME type from the server or the data: URL, '' if there is none. */
  readonly contentType: string;
  /** Bytes that the file takes where it lies, if it was unpacked on its way here: what a load may hold depends on them. */
  readonly packedBytes?: number;
  /** Where it is above 0, so many bytes of the file are missing after `bytes`, and its server can send parts of it. */
  readonly missing?: number;
}

export type ProgressListener = (loaded: number, total: number) => void;

/** Whether these settings say that an image is a radar's mosaic. */
export function isRadar({ spherical, elevations }: DecodeSettings): boolean {
  return spherical ?? elevations !== undefined;
}
