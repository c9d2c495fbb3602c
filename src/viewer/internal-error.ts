import { VolumeViewError } from '../errors.ts';

/**
 * Whatever was thrown, as an error that a page can be told of. What has no words of its own is a mistake of this package.
 * @param subject - the attributes or the file that were being worked on
 */
export function asVolumeViewError(error: unknown, subject: string): VolumeViewError {
  if (error instanceof VolumeViewError) return error;
  return new VolumeViewError('internal', `volume-view failed at ${subject}, and the page is not to blame (${String(error)}). Please report it.`, { cause: error });
}
