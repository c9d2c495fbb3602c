import { VolumeViewError } from '../../core/errors.ts';

/** Maximum number of files of one volume: more slices than any scanner makes, and few enough to list. */
export const maxFiles = 2 ** 13;

/**
 * @param what - what names the files, for messages
 * @throws {VolumeViewError} `format/too-large`, or `format/corrupt` if there are none
 */
export function checkFileCount(what: string, count: number): void {
  if (!(count >= 1)) throw new VolumeViewError('format/corrupt', `${what} got no files; expected at least one`);
  if (count > maxFiles) {
    throw new VolumeViewError(
      'format/too-large',
      `${what} got ${count.toLocaleString('en')} files for one volume; expected at most ${maxFiles.toLocaleString('en')}`,
    );
  }
}
