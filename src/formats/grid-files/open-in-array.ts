import type { Vector3 } from '../../volume/matrix.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { placeVolume } from '../base/place-volume.ts';
import { countKept } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { noTimes } from '../series/open-volumes.ts';
import type { VolumesOfFile } from '../series/open-volumes.ts';
import { pickVolume } from './pick-volume.ts';

/** An array that holds volumes, whose samples may lie among each other. */
export interface VolumesInArray {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly dimensions: Vector3;
  /** Samples from one voxel to the next along i, j and k. */
  readonly strides: Vector3;
  /** Where each volume begins, samples. */
  readonly starts: readonly number[];
}

/** Whether all volumes of an array may be kept, unpacked. @param bytes - of all */
export function mayKeepAll(count: number, bytes: number, { budget }: ReadContext): boolean {
  return countKept({ bytes: bytes / count, count }, budget) === count;
}

/** The same as `openVolumes`, for volumes of an array that is in memory. @throws {VolumeViewError} `format/too-large` */
export async function openInArray(
  { bytes: all, dimensions, strides, starts }: VolumesInArray,
  { info, type, left = [], ...rest }: VolumesOfFile,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const { bytesPerSample } = type;
  const span = 1 + dimensions.reduce((sum, n, axis) => sum + (n - 1) * strides[axis], 0);
  const volumes = starts.map((start) => {
    const own = all.subarray(start * bytesPerSample, (start + span) * bytesPerSample);
    return new Blob([pickVolume(own, bytesPerSample, dimensions, strides)]);
  });
  const series = { ...noTimes, ...rest, info: { ...info, ...listLeft(1, ...left) }, volumes, count: volumes.length };
  return placeVolume(await openSeries({ ...series, type: type.name }, settings, context), settings);
}
