import { VolumeViewError } from '../../core/errors.ts';
import type { NumberType } from './number-types.ts';

/** Maximum number of bytes of samples: what browsers allow for one buffer. */
export const maxFileSamplesBytes = 2 ** 31 - 1;

/**
 * Bytes of a grid's samples. Call this before anything is allocated.
 * @param what - what needs them, for messages
 * @param lengths - samples along each axis
 * @throws {VolumeViewError} `format/too-large`
 */
export function countSampleBytes(
  what: string,
  lengths: readonly number[],
  type: Pick<NumberType, 'name' | 'bytesPerSample'>,
): number {
  const voxels = lengths.reduce((product, n) => product * n, 1);
  const bytes = voxels * type.bytesPerSample;
  if (bytes <= maxFileSamplesBytes) return bytes;
  throw new VolumeViewError(
    'format/too-large',
    `${what} asks for ${lengths.join(' x ')} = ${voxels.toLocaleString('en')} voxels of ${type.name}, ` +
      `${gigabytes(bytes)}; expected at most ${gigabytes(maxFileSamplesBytes)}; resample the file to fewer voxels`,
  );
}

function gigabytes(bytes: number): string {
  return `${(bytes / 2 ** 30).toLocaleString('en', { maximumFractionDigits: 1 })} GiB`;
}
