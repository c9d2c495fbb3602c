import { VolumeViewError } from './errors.ts';

/**
 * Wait for a part of the package that is loaded on demand.
 * @param what - the part does, as in "that shows several scans"
 * @throws {VolumeViewError} `format/unsupported`
 */
export function loadPart<T>(loading: Promise<T>, what: string): Promise<T> {
  return loading.catch((cause: unknown) => {
    throw new VolumeViewError(
      'format/unsupported',
      `the part of volume-view that ${what} could not be loaded; check that all files of the package are on the server`,
      { cause },
    );
  });
}
