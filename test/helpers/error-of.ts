import { VolumeViewError } from '../../src/core/errors.ts';

/** The error that a call ends with. Throws where there is none, and what is no VolumeViewError. */
export function errorOf(run: () => unknown): VolumeViewError {
  try {
    run();
  } catch (error) {
    if (error instanceof VolumeViewError) return error;
    throw error;
  }
  throw new Error('expected an error, got none');
}
