import { VolumeViewError } from '../../core/errors.ts';

// Errors of readers of a header with samples after it or in other files; `what` is for example 'the NRRD header'.

export function corruptFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `${what} ${problem}`);
}

export function unsupportedFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `${what} ${problem}`);
}
