import { VolumeViewError } from '../../src/core/errors.ts';

/** The VolumeViewError that a call throws. Throws if the call throws no error; passes on errors of other classes. */
export function errorOf(run: () => unknown): VolumeViewError {
  try {
    run();
  } catch (error) {
    if (error instanceof VolumeViewError) return error;
    throw error;
  }
  throw new Error('expected an error, got none');
}
