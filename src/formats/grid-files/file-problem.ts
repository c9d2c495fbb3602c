import { VolumeViewError } from '../../core/errors.ts';

// What readers of a header with samples beside it or after it say; `what` is such as 'the NRRD header'.

export function corruptFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `${what} ${problem}`);
}

export function unsupportedFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `${what} ${problem}`);
}
