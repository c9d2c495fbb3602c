import { VolumeViewError } from '../../core/errors.ts';

// Errors of readers; `what` is for example 'the NRRD header', `problem` says what was got and what was expected.

export function corruptFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `${what} ${problem}`);
}

export function unsupportedFile(what: string, problem: string): VolumeViewError {
  return new VolumeViewError('format/unsupported', `${what} ${problem}`);
}
