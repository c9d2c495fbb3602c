// Fetches pixels and tables from a DICOMweb server. Source: DICOM PS3.18, 10.4 (WADO-RS)
import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { WebPixels } from '../formats/base/scan-data.ts';
import { writeInstance } from '../formats/dicom/write-instance.ts';
import type { JsonPixels } from '../formats/dicom/write-instance.ts';
import type { FetchOptions } from './download.ts';
import { fetchBytes } from './fetch-bytes.ts';
import { splitParts } from './multipart.ts';
import type { Part } from './multipart.ts';
import { Queue } from '../formats/base/queue.ts';

/** Requests at once, of all instances together. */
export const ahead = 6;

export type Reading = Omit<FetchOptions, 'onProgress' | 'isEnough'> & Partial<Pick<FetchOptions, 'onProgress'>>;
export type QueuedReading = Reading & { readonly queue: Queue };

/** How something is read. */
export interface PartReading {
  /** For messages. */
  readonly what: string;
  readonly reading: QueuedReading;
  /** Gets the number of bytes that came since the last call. */
  readonly count: (bytes: number) => void;
}

const octets = 'application/octet-stream';
const anySyntax = `multipart/related; type="${octets}"; transfer-syntax=*`;
const plainSyntax = `multipart/related; type="${octets}"`;
export const littleEndian = '1.2.840.10008.1.2.1';

/** How frames are packed where a server says only their type. Source: PS3.18, table 8.7.3-2 */
const usual: Readonly<Record<string, string>> = {
  'image/jpeg': '1.2.840.10008.1.2.4.70',
  'image/jls': '1.2.840.10008.1.2.4.80',
  'image/jp2': '1.2.840.10008.1.2.4.90',
  'image/jphc': '1.2.840.10008.1.2.4.202',
  'image/dicom-rle': '1.2.840.10008.1.2.5',
  'image/x-dicom-rle': '1.2.840.10008.1.2.5',
};

/** Ways of writing numbers that are not packed: servers send them with the lowest byte first. */
const plain: ReadonlySet<string> = new Set([
  '1.2.840.10008.1.2',
  littleEndian,
  '1.2.840.10008.1.2.2',
  '1.2.840.10008.1.2.1.99',
]);

/**
 * Pixels of some frames, or all of an instance, as a file without any other element.
 * @throws {VolumeViewError} `source/…`, `format/…`; messages have no address
 */
export async function fetchPixels(pixels: WebPixels, given: Reading): Promise<DecodeInput> {
  const how = {
    what: 'frames of the DICOMweb series',
    reading: { ...given, queue: new Queue(ahead) },
    count: () => undefined,
  };
  return asFile(await readPixels(pixels, how), pixels.url);
}

/** Pixels as a file without any other element. */
export const asFile = (pixels: JsonPixels, url: string): DecodeInput => ({
  bytes: writeInstance({}, new Map(), pixels),
  url,
  contentType: 'application/dicom',
});

/** @throws {VolumeViewError} as fetchPixels says */
export async function readPixels({ url, id, frames }: WebPixels, how: PartReading): Promise<JsonPixels> {
  const parts = await readParts(url, how);
  if (frames === null) return { id, syntax: littleEndian, isPacked: false, pieces: parts.slice(0, 1).map(bytesOf) };
  if (parts.length === frames)
    return joinPixels(
      parts.map((part) => toPixels(part, id)),
      how.what,
    );
  throw new VolumeViewError('source/unavailable', `${how.what}: the server sent ${parts.length} of ${frames} frames`);
}

const bytesOf = ({ bytes }: Part): Uint8Array<ArrayBuffer> => bytes;

/** A table that stands at an address of its own. */
export async function readBulk(url: string, how: PartReading): Promise<Uint8Array<ArrayBuffer>> {
  const [part] = await readParts(url, how);
  return part?.bytes ?? new Uint8Array();
}

/** @throws {VolumeViewError} `format/unsupported` where they are packed in several ways */
export function joinPixels(parts: readonly JsonPixels[], what: string): JsonPixels {
  const ways = new Set(parts.map(({ syntax }) => syntax)).size;
  if (ways > 1)
    throw new VolumeViewError('format/unsupported', `${what} has frames that are packed in ${ways} ways; expected one`);
  return { ...parts[0], pieces: parts.flatMap(({ pieces }) => pieces) };
}

function toPixels({ contentType, bytes }: Part, id: number): JsonPixels {
  const syntax = syntaxOf(contentType);
  if (plain.has(syntax)) return { id, syntax: littleEndian, isPacked: false, pieces: [bytes] };
  return { id: 0x7fe00010, syntax, isPacked: true, pieces: [bytes] };
}

function syntaxOf(contentType: string): string {
  const [, stated] = /;\s*transfer-syntax="?([\d.]+)/i.exec(contentType) ?? [];
  const [type] = contentType.split(';');
  return stated ?? usual[type.trim().toLowerCase()] ?? littleEndian;
}

/** Answers of servers that do not send what they have as they have it: then the numbers are asked for, as they are without packing. */
const refusals: ReadonlySet<unknown> = new Set([400, 406, 415, 500, 501]);

/** An answer that is cut short is asked for once more. */
async function readParts(url: string, { what, reading, count }: PartReading): Promise<Part[]> {
  let accept = anySyntax;
  for (let isLast = false; ; isLast = true) {
    try {
      const { bytes, contentType } = await fetchFrom(url, { accept, what, reading, count });
      return splitParts(bytes, contentType, what);
    } catch (cause) {
      const { status = 200 } = cause as { readonly status?: number };
      if (isLast || !(status === 200 || refusals.has(status))) throw cause;
      if (refusals.has(status)) accept = plainSyntax;
    }
  }
}

/** @throws {VolumeViewError} `source/…`, `format/too-large`: without the address, which has numbers of a patient's study */
export async function fetchFrom(
  url: string,
  {
    accept,
    what,
    reading,
    count,
  }: Pick<PartReading, 'what' | 'reading'> & Partial<Pick<PartReading, 'count'>> & { readonly accept: string },
): Promise<DecodeInput> {
  const ask = reading.fetch ?? fetch;
  let [before, status] = [0, 0];
  try {
    return await reading.queue.run(() =>
      fetchBytes(url, {
        ...reading,
        fetch: async (address, options) => {
          const response = await ask(address, {
            ...options,
            headers: { ...Object.fromEntries(new Headers(options?.headers)), accept },
          });
          status = response.status;
          return response;
        },
        onProgress: (loaded, total) => {
          if (!count) return reading.onProgress?.(loaded, total);
          count(loaded - before);
          before = loaded;
        },
      }),
    );
  } catch (cause) {
    reading.signal?.throwIfAborted();
    if (!(cause instanceof VolumeViewError)) throw cause;
    const shown = url.length > 300 ? `${url.slice(0, 100)}…` : url;
    const message = [shown, url.slice(0, 300), url].reduce((text, one) => text.replaceAll(one, what), cause.message);
    throw Object.assign(new VolumeViewError(cause.code, message), { status });
  }
}
