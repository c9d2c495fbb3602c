import { VolumeViewError } from '../errors.ts';
import { nameOf } from './name-of.ts';

/** What something that a reader did not expect means for the author of a page. @param url - of the file */
export function explainDamage(cause: unknown, url: string): VolumeViewError {
  const name = nameOf(url);
  if (cause instanceof RangeError) {
    return new VolumeViewError('format/too-large', `${name} needs more memory than the browser gives; use a smaller file`, { cause });
  }
  const why = cause instanceof Error ? cause.message : String(cause);
  return new VolumeViewError('format/corrupt', `${name} can not be decoded (${why}); the file may be damaged`, { cause });
}
