import { decodeFile } from '../../src/formats/decode.ts';
import type { DecodeContext } from '../../src/formats/decode.ts';
import type { DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { VolumeViewError } from '../../src/core/errors.ts';
import type { DeviceLimits } from '../../src/volume/reduce.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A device that holds everything that tests load. */
export const roomyLimits: DeviceLimits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 30 };

/** Bytes of a file that the test server shows. */
export async function fetchFile(path: string): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path}: HTTP status ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

export const fetchFixture = (path: string): Promise<Uint8Array<ArrayBuffer>> => fetchFile(`/test/fixtures/${path}`);

/** Decode on this thread, as the worker does it. */
export async function decodeBytes(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  settings: DecodeSettings = {},
  limits: DeviceLimits = roomyLimits,
): Promise<Volume> {
  const input = { bytes, url: urlOf(name), contentType: '' };
  return finishVolume(await decodeFile(input, settings, fixtureContext()), limits);
}

/** Where the names of fixtures lead to while they are decoded. */
export const urlOf = (name: string): string => new URL(name, 'https://example.test/').href;

/** What decoding needs: other files come from the fixtures. One that is not there has the code that fetching gives it. */
export function fixtureContext(): DecodeContext {
  const missing = (cause: unknown): never => {
    throw new VolumeViewError('source/not-found', String(cause), { cause });
  };
  const fetchFile: DecodeContext['fetchFile'] = async (url) => ({ bytes: await fetchFixture(new URL(url).pathname.slice(1)).catch(missing), url, contentType: '' });
  return { onProgress: () => undefined, fetchFile, fetchFiles: (urls) => fetchInOrder(urls, fetchFile, () => undefined) };
}

/** Decode the fixtures of a stack, as one volume. */
export async function decodeStack(names: readonly string[], settings: DecodeSettings = {}): Promise<Volume> {
  const context: DecodeContext = { ...fixtureContext(), files: names.map(urlOf) };
  return finishVolume(await decodeFile(await context.fetchFile(urlOf(names[0])), settings, context), roomyLimits);
}

/** Data values, in double precision, NaN where there is none. */
export function valuesOf(volume: Volume): number[] {
  return Array.from(volume.samples, (sample) => volume.slope * sample + volume.intercept);
}

/** The error that a promise is rejected with; fails where it is none of ours. */
export async function expectError(promise: Promise<unknown>): Promise<VolumeViewError> {
  try {
    await promise;
  } catch (error) {
    if (error instanceof VolumeViewError) return error;
    throw new Error(`expected a VolumeViewError, got ${String(error)}`, { cause: error });
  }
  throw new Error('expected a VolumeViewError, got none');
}
