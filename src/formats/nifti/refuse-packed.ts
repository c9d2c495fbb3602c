import { VolumeViewError } from '../../core/errors.ts';
import { findForeign } from '../base/foreign-formats.ts';
import { isGzip } from '../codecs/gunzip.ts';

/** The error for an unpacked gzip file that no format claims. */
export function refusePacked(bytes: Uint8Array): VolumeViewError {
  if (isGzip(bytes))
    return new VolumeViewError(
      'format/unsupported',
      'what is packed is a gzip file again, of which volume-view reads one layer; unpack it once: gzip -d file.gz',
    );
  const foreign = findForeign({
    bytes,
    unpacked: null,
    text: new TextDecoder().decode(bytes.subarray(0, 512)).trimStart(),
  });
  return foreign
    ? new VolumeViewError(
        'format/unsupported',
        `what is packed is ${foreign.name}, which volume-view does not read; convert it ${foreign.advice}`,
      )
    : new VolumeViewError('format/unknown', 'the data do not begin with a NIfTI header');
}
