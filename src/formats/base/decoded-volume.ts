import type { CartesianGrid } from '../../volume/grid.ts';
import type { Macrocells } from '../../volume/macrocells.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ChannelUse } from './channels.ts';
import type { ScanTarget } from './choose-scan.ts';
import type { MosaicValues, RadarSettings } from './radar-settings.ts';

/** What a format reads out of a file: a volume, but for what follows from its samples. */
export type DecodedVolume = DecodedCartesianVolume | DecodedPolarVolume;

type Decoded = Omit<Volume, 'grid' | 'range' | 'histogram' | 'macrocells' | 'hasNoData' | 'reduced' | 'coarse' | 'isDiscrete' | 'referenceLength'>;

export type DecodedCartesianVolume = Decoded & {
  readonly grid: CartesianGrid;
  /** Whether the file says that its values are labels: whole numbers that stand for things. */
  readonly isLabels?: boolean;
  /** NIfTI's code for what the values are. */
  readonly intent?: number;
};

/** Only what reads radar files knows how to make its macrocells, which takes long. */
export type DecodedPolarVolume = Decoded & { readonly grid: PolarGrid; readonly makeMacrocells: () => Macrocells };

/** What attributes or a manifest say of a file's data. */
export interface DecodeSettings extends RadarSettings {
  readonly mosaic?: { readonly columns: number; readonly rows: number };
  readonly slices?: number;
  /** Of a manifest with scans: which one; the first where undefined. */
  readonly scan?: ScanTarget;
  /** How an image's channels make one number; gray where undefined. */
  readonly channels?: ChannelUse;
  /** Of a radar's mosaic: what its pixels stand for, from a manifest. */
  readonly values?: MosaicValues;
  /** World units per voxel of the file; of a mosaic, per pixel of its image along i and j. */
  readonly spacing?: Vector3;
  /** Row-major; wins over spacing and over the file's own. */
  readonly indexToWorld?: Matrix4;
}

/** Bytes to decode, and where they came from. */
export interface DecodeInput {
  /** Taken over: the caller must not use them again. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Absolute. */
  readonly url: string;
  /** MIME type that the server or the data: URL gave, '' where none. */
  readonly contentType: string;
}

export type ProgressListener = (loaded: number, total: number) => void;

/** Whether an image is a radar's mosaic. */
export function isRadar({ spherical, elevations }: DecodeSettings): boolean {
  return spherical ?? elevations !== undefined;
}
