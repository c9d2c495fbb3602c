import { VolumeViewError } from '../../core/errors.ts';
import { checkFileCount } from '../base/check-file-count.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import type { Format } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';

/**
 * Checks whether files can be one volume, by their number and by the format of the first one.
 * @param files - all of the stack
 * @throws {VolumeViewError} `format/too-large`, `format/corrupt`, `format/unsupported`
 */
export function checkStack(format: Format, first: DecodeInput, files: readonly string[]): void {
  checkFileCount('the stack', files.length);
  if ('loadImage' in format || format.takesFiles || files.length === 1) return;
  const further = files.length - 1;
  throw new VolumeViewError(
    'format/unsupported',
    `the stack got ${nameOf(first.url)}, which is a volume by itself (${format.name}), and ${further} more file${further > 1 ? 's' : ''}; ` +
      'expected images, a slice each, or a header and its data; leave out stack where the files are scans in time',
  );
}
