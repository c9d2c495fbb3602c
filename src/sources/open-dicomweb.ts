// Opens a series on a DICOMweb server. Loaded when it is needed. Source: DICOM PS3.18, 10.4 (WADO-RS)
import { VolumeViewError } from '../core/errors.ts';
import { checkFileCount } from '../formats/base/check-file-count.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { elementOf, listBulk, writeInstance } from '../formats/dicom/write-instance.ts';
import type { JsonPixels, JsonSet } from '../formats/dicom/write-instance.ts';
import type { ReadOptions } from './byte-store.ts';
import type { FetchOptions } from './download.ts';
import { fetchBytes } from './fetch-bytes.ts';
import { FolderReader } from './folder-reader.ts';
import { Queue } from './queue.ts';
import { splitParts } from './multipart.ts';
import type { Part } from './multipart.ts';
import type { OpenedFiles } from './opened-files.ts';
import type { FolderLoad } from './show-part.ts';

/** Bytes of frames that are asked for at once, and the number of frames. */
const [bytesAtOnce, maxFrames] = [2 ** 22, 64];

/** Requests at once, of all instances together. */
const ahead = 6;

const octets = 'application/octet-stream';
const anySyntax = `multipart/related; type="${octets}"; transfer-syntax=*`;
const plainSyntax = `multipart/related; type="${octets}"`;
const littleEndian = '1.2.840.10008.1.2.1';

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

type Reading = Omit<FetchOptions, 'onProgress' | 'isEnough'> & Partial<Pick<FetchOptions, 'onProgress'>>;
type QueuedReading = Reading & { readonly queue: Queue };

/**
 * Reads the list of a series, and its middle instance. The list says all but the pixels: these are fetched when they are
 * asked for, frames as the server has them.
 * @param address - ends in `/studies/…/series/…`, or in an instance of it; what follows a question mark is added to all addresses
 * @param load - reads the files of series in parts; they are read as a whole if undefined
 * @throws {VolumeViewError} `source/…`, `format/…`; messages have no address but this one
 */
export async function openDicomWeb(address: string, given: Reading, load?: FolderLoad): Promise<OpenedFiles> {
  const reading = { ...given, queue: new Queue(ahead) };
  const { origin, pathname, search } = new URL(address);
  const [series] = /^.*\/series\/[\d.]+/.exec(pathname)!;
  const sets = await readMetadata(`${origin}${pathname}/metadata${search}`, reading);
  checkFileCount('the DICOMweb series', sets.length);
  const base = `${origin}${pathname.slice(0, pathname.indexOf('/studies/'))}`;
  const instances = new Map<string, { readonly set: JsonSet; readonly place: number }>();
  for (const [place, set] of middleFirst(sets).entries())
    instances.set(`${origin}${series}/instances/${instanceOf(set)}`, { set, place });
  const files = [...instances.keys()];
  const isSeveral = files.length > 1;
  const read = async (url: string, { range, ...options }: ReadOptions): Promise<DecodeInput> => {
    const instance = instances.get(url);
    if (!instance) throw notNamed();
    const what = isSeveral ? `instance ${instance.place + 1} of ${files.length}` : 'the instance';
    const how = { url, base, search, what, reading: { ...reading, ...options } };
    return range ? readStart(instance.set, how) : readInstance(instance.set, how);
  };
  const [first] = files;
  const whole = await read(first, { onProgress: load?.onProgress });
  const store = { list: async () => files, stat: async () => ({ size: null }), read };
  return {
    first,
    ...(isSeveral && { files }),
    ...(isSeveral &&
      load && { folder: await FolderReader.of(store, files, read, { load, whole: [whole], signal: reading.signal }) }),
    isPrivate: true,
    describe: (volume) => ({ ...volume, source: { kind: 'DICOMweb', count: files.length } }),
    read: async (url, options) => (url === first ? whole : read(url, options)),
  };
}

function notNamed(): VolumeViewError {
  return new VolumeViewError('source/not-found', 'the DICOMweb series names files that it does not hold');
}

async function readMetadata(url: string, reading: QueuedReading): Promise<JsonSet[]> {
  const { bytes } = await fetchFrom(url, {
    accept: 'application/dicom+json',
    what: 'the list of the DICOMweb series',
    reading,
  });
  let sets: unknown;
  try {
    sets = bytes.length > 0 ? JSON.parse(new TextDecoder().decode(bytes)) : [];
  } catch (cause) {
    throw notDicomWeb(cause);
  }
  const isSet = (one: unknown): one is JsonSet => typeof one === 'object' && one !== null && !Array.isArray(one);
  if (!Array.isArray(sets) || !sets.every(isSet)) throw notDicomWeb();
  if (sets.length === 0)
    throw new VolumeViewError(
      'source/not-found',
      'the DICOMweb server has no instance of this series; check the address',
    );
  return sets;
}

function notDicomWeb(cause?: unknown): VolumeViewError {
  return new VolumeViewError(
    'format/unknown',
    'the server does not answer as DICOMweb does: the metadata of the series are no JSON of DICOM; check the address, and that the server has WADO-RS there',
    { cause },
  );
}

function instanceOf(set: JsonSet): string {
  const [uid] = elementOf(set, 0x00080018)?.Value ?? [];
  if (typeof uid === 'string' && /^[\d.]{1,64}$/.test(uid)) return uid;
  throw new VolumeViewError(
    'format/corrupt',
    'the DICOMweb server lists an instance without its number (SOPInstanceUID); expected one for each',
  );
}

const numbersOf = (set: JsonSet, id: number): number[] => (elementOf(set, id)?.Value ?? []).map(Number);

/** The instance in the middle, by their places along the normal, else by their numbers; then the others as they are listed. */
function middleFirst(sets: readonly JsonSet[]): JsonSet[] {
  const [x, y, z, u, v, w] = numbersOf(sets[0], 0x00200037);
  const normal = [y * w - z * v, z * u - x * w, x * v - y * u];
  const placeOf = (set: JsonSet): number => {
    const position = numbersOf(set, 0x00200032);
    const along = normal.reduce((sum, n, i) => sum + n * position[i], 0);
    return Number.isFinite(along) ? along : (numbersOf(set, 0x00200013)[0] ?? 0);
  };
  const sorted = sets.map((set) => ({ set, place: placeOf(set) }));
  sorted.sort((a, b) => a.place - b.place);
  const { set: middle } = sorted[sorted.length >> 1];
  return [middle, ...sets.filter((set) => set !== middle)];
}

interface InstanceReading {
  readonly url: string;
  /** The address of the server's root. */
  readonly base: string;
  readonly search: string;
  /** For messages. */
  readonly what: string;
  readonly reading: QueuedReading;
}

async function readInstance(set: JsonSet, how: InstanceReading): Promise<DecodeInput> {
  const { url, reading } = how;
  let loaded = 0;
  const count = (bytes: number): void => reading.onProgress?.((loaded += bytes), 0);
  const bulk = await readAllBulk(set, how, count);
  const pixels = await readPixels(set, how, count);
  return { bytes: writeInstance(set, bulk, pixels), url, contentType: 'application/dicom' };
}

/** What the list says of an instance: a file without its pixels. Those of several frames are read as a whole. */
async function readStart(set: JsonSet, how: InstanceReading): Promise<DecodeInput> {
  const input = { url: how.url, contentType: 'application/dicom' };
  const pixels = describePixels(set, how.what);
  if (!pixels) return { ...input, bytes: writeInstance(set, await readAllBulk(set, how, () => undefined), null) };
  const { id, frames, frameBytes } = pixels;
  const announced = Math.ceil(frames * frameBytes);
  const unread: JsonPixels = { id, syntax: littleEndian, isPacked: false, pieces: [], announced };
  return {
    ...input,
    bytes: writeInstance(set, await readAllBulk(set, how, () => undefined), unread),
    missing: announced,
  };
}

async function readAllBulk(
  set: JsonSet,
  how: InstanceReading,
  count: (bytes: number) => void,
): Promise<ReadonlyMap<string, Uint8Array<ArrayBuffer>>> {
  const bulk = new Map<string, Uint8Array<ArrayBuffer>>();
  for (const address of new Set(listBulk(set))) bulk.set(address, await readBulk(address, how, count));
  return bulk;
}

/** What the list says of the pixels of an instance; null where it has none. @throws {VolumeViewError} `format/corrupt` */
function describePixels(
  set: JsonSet,
  what: string,
): { readonly id: number; readonly bits: number; readonly frames: number; readonly frameBytes: number } | null {
  const [rows, columns] = [0x00280010, 0x00280011].map((id) => numbersOf(set, id)[0]);
  if (!(rows > 0 && columns > 0)) return null;
  const [bits = 8] = numbersOf(set, 0x00280100);
  const [samples = 1] = numbersOf(set, 0x00280002);
  const [frames = 1] = numbersOf(set, 0x00280008);
  if (!(Number.isInteger(frames) && frames >= 1 && frames <= 2 ** 16))
    throw new VolumeViewError('format/corrupt', `${what} got ${String(frames)} frames; expected 1 to 65,536`);
  const id = [0x7fe00008, 0x7fe00009].find((one) => elementOf(set, one)) ?? 0x7fe00010;
  return { id, bits, frames, frameBytes: (rows * columns * samples * bits) / 8 };
}

/** The pixels of an instance: frame by frame, except for numbers that frames do not have on all servers. */
async function readPixels(
  set: JsonSet,
  how: InstanceReading,
  count: (bytes: number) => void,
): Promise<JsonPixels | null> {
  const described = describePixels(set, how.what);
  if (!described) return null;
  const { id, bits, frames, frameBytes: size } = described;
  const address = id !== 0x7fe00010 || bits === 1 ? elementOf(set, id)?.BulkDataURI : undefined;
  if (typeof address === 'string')
    return { id, syntax: littleEndian, isPacked: false, pieces: [await readBulk(address, how, count)] };
  const step = Math.max(1, Math.min(maxFrames, Math.floor(bytesAtOnce / size)));
  const starts = Array.from({ length: Math.ceil(frames / step) }, (_, i) => 1 + i * step);
  const parts: Part[][] = [];
  let next = 0;
  const work = async (): Promise<void> => {
    while (next < starts.length) {
      const i = next++;
      const last = Math.min(frames, starts[i] + step - 1);
      parts[i] = await readFrames([starts[i], last], how, count);
    }
  };
  await Promise.all(Array.from({ length: ahead }, work));
  return joinFrames(parts.flat(), how.what);
}

function joinFrames(parts: readonly Part[], what: string): JsonPixels {
  const syntaxes = new Set(parts.map(({ contentType }) => syntaxOf(contentType)));
  if (syntaxes.size > 1)
    throw new VolumeViewError(
      'format/unsupported',
      `${what} has frames that are packed in ${syntaxes.size} ways; expected one`,
    );
  const [syntax] = syntaxes;
  const isPacked = !plain.has(syntax);
  return {
    id: 0x7fe00010,
    syntax: isPacked ? syntax : littleEndian,
    isPacked,
    pieces: parts.map(({ bytes }) => bytes),
  };
}

function syntaxOf(contentType: string): string {
  const [, stated] = /;\s*transfer-syntax="?([\d.]+)/i.exec(contentType) ?? [];
  const [type] = contentType.split(';');
  return stated ?? usual[type.trim().toLowerCase()] ?? littleEndian;
}

/** @param range - the first frame and the last one, from 1 */
async function readFrames(
  [first, last]: readonly [number, number],
  { url, search, what, reading }: InstanceReading,
  count: (bytes: number) => void,
): Promise<Part[]> {
  const wanted = last - first + 1;
  const list = Array.from({ length: wanted }, (_, i) => first + i).join(',');
  const name = `${wanted > 1 ? `frames ${first} to ${last}` : `frame ${first}`} of ${what}`;
  const parts = await readParts(`${url}/frames/${list}${search}`, name, reading, count);
  if (parts.length === wanted) return parts;
  throw new VolumeViewError('source/unavailable', `${name}: the server sent ${parts.length} of ${wanted} frames`);
}

async function readBulk(
  address: string,
  { base, search, what, reading }: InstanceReading,
  count: (bytes: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  // Servers behind others name hosts that nobody else reaches, and a stranger's list must not choose a server.
  const at = address.indexOf('/studies/');
  if (at < 0) throw notNamed();
  const url = `${base}${address.slice(at)}${search}`;
  const [part] = await readParts(url, `a table of ${what}`, reading, count);
  return part?.bytes ?? new Uint8Array();
}

/** Answers of servers that do not send what they have as they have it: then the numbers are asked for, as they are without packing. */
const refusals: ReadonlySet<unknown> = new Set([400, 406, 415, 500, 501]);

/** An answer that is cut short is asked for once more. */
async function readParts(
  url: string,
  what: string,
  reading: QueuedReading,
  count: (bytes: number) => void,
): Promise<Part[]> {
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
async function fetchFrom(
  url: string,
  {
    accept,
    what,
    reading,
    count,
  }: { accept: string; what: string; reading: QueuedReading; count?: (bytes: number) => void },
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
