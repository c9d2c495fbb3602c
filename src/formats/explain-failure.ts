import { asVolumeViewError, VolumeViewError } from '../core/errors.ts';
import { nameOf } from './base/name-of.ts';

/**
 * How browsers say that there is no memory for a buffer or an array. Other RangeErrors come from reading beyond some
 * bytes.
 */
const lacksMemory = /memory|allocat|array length|too large/i;

/** Explains an unexpected error during the reading of a file to the author of a page. @param url - of the file */
export function explainFailure(cause: unknown, url: string): VolumeViewError {
  const name = nameOf(url);
  if (!(cause instanceof RangeError)) return asVolumeViewError(cause, `the file ${name}`);
  if (lacksMemory.test(cause.message)) {
    return new VolumeViewError(
      'format/too-large',
      `${name} needs more memory than the browser gives; use a smaller file`,
      { cause },
    );
  }
  return new VolumeViewError(
    'format/corrupt',
    `${name} can not be decoded (${cause.message}); the file may be damaged`,
    { cause },
  );
}
