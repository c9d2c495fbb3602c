import { decodeFile } from '../../src/formats/decode.ts';
import type { DecodeContext } from '../../src/formats/decode.ts';
import type { DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { VolumeViewError } from '../../src/core/errors.ts';
import type { DeviceLimits } from '../../src/volume/reduce.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** The limits of a device that has room for everything that tests load. */
export const roomyLimits: DeviceLimits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 30 };

/** Fetch the bytes of a file from the test server. */
export async function fetchFile(path: string): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path}: HTTP status ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

export const fetchFixture = (path: string): Promise<Uint8Array<ArrayBuffer>> => fetchFile(`/test/fixtures/${path}`);

/** Decode on this thread, in the same way as the worker. */
export async function decodeBytes(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  settings: DecodeSettings = {},
  limits: DeviceLimits = roomyLimits,
): Promise<Volume> {
  const input = { bytes, url: urlOf(name), contentType: '' };
  return finishVolume(await decodeFile(input, settings, fixtureContext()), limits);
}

/** The URL of a fixture during decoding. */
export const urlOf = (name: string): string => new URL(name, 'https://example.test/').href;

/** The context of decoding: other files come from the fixtures. A missing file gives the same error code as a fetch. */
export function fixtureContext(): DecodeContext {
  const missing = (cause: unknown): never => {
    throw new VolumeViewError('source/not-found', String(cause), { cause });
  };
  const fetchFile: DecodeContext['fetchFile'] = async (url) => ({
    bytes: await fetchFixture(new URL(url).pathname.slice(1)).catch(missing),
    url,
    contentType: '',
  });
  return {
    onProgress: () => undefined,
    fetchFile,
    fetchFiles: (urls) =>
      fetchInOrder(
        urls,
        (url) => fetchFile(url),
        () => undefined,
      ),
  };
}

/** Decode the fixtures of a stack, as one volume. */
export async function decodeStack(names: readonly string[], settings: DecodeSettings = {}): Promise<Volume> {
  const context: DecodeContext = { ...fixtureContext(), files: names.map(urlOf) };
  return finishVolume(await decodeFile(await context.fetchFile(urlOf(names[0])), settings, context), roomyLimits);
}

/** Data values, in double precision; NaN where there is no data. */
export function valuesOf(volume: Volume): number[] {
  return Array.from(volume.samples, (sample) => volume.slope * sample + volume.intercept);
}

/** The error of a rejected promise; throws if it is not a VolumeViewError. */
export async function expectError(promise: Promise<unknown>): Promise<VolumeViewError> {
  try {
    await promise;
  } catch (error) {
    if (error instanceof VolumeViewError) return error;
    throw new Error(`expected a VolumeViewError, got ${String(error)}`, { cause: error });
  }
  throw new Error('expected a VolumeViewError, got none');
}
