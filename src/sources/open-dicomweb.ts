// Opens a series on a DICOMweb server. Loaded when it is needed. Source: DICOM PS3.18, 10.4 (WADO-RS)
import { VolumeViewError } from '../core/errors.ts';
import { checkFileCount } from '../formats/base/check-file-count.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { keptBytes } from '../formats/base/format.ts';
import { parseJson } from '../formats/base/parse-json.ts';
import type { WebPixels } from '../formats/base/scan-data.ts';
import { elementOf, listBulk, writeInstance } from '../formats/dicom/write-instance.ts';
import type { JsonPixels, JsonSet } from '../formats/dicom/write-instance.ts';
import { segmentations } from '../formats/dicom/tags.ts';
import type { ReadOptions } from './byte-store.ts';
import { ahead, asFile, fetchFrom, joinPixels, littleEndian, readBulk, readPixels } from './dicomweb-parts.ts';
import type { PartReading, QueuedReading, Reading } from './dicomweb-parts.ts';
import { FolderReader } from './folder-reader.ts';
import type { OpenedFiles } from './opened-files.ts';
import { Queue } from '../formats/base/queue.ts';
import type { FolderLoad } from './show-part.ts';

export { fetchPixels } from './dicomweb-parts.ts';

/** Bytes of frames that are asked for at once, and the number of frames. */
const [bytesAtOnce, maxFrames] = [2 ** 22, 64];

/**
 * Reads the list of a series. The list says all but the pixels: these are fetched when they are asked for, frames as the server
 * has them.
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
  const find = (url: string) => {
    const instance = instances.get(url);
    if (!instance) throw notNamed();
    return { ...instance, what: isSeveral ? `instance ${instance.place + 1} of ${files.length}` : 'the instance' };
  };
  const read = async (url: string, { range, ...options }: ReadOptions): Promise<DecodeInput> => {
    const { set, what } = find(url);
    const how = { url, base, search, what, reading: { ...reading, ...options } };
    return range ? readStart(set, how) : readInstance(set, how);
  };
  const addressOf = (url: string, frames: readonly number[]): WebPixels => {
    const { set, what } = find(url);
    return locate(set, frames, { url, base, search, what });
  };
  const [first] = files;
  const store = { list: async () => files, stat: async () => ({ size: null }), read };
  const options = {
    signal: reading.signal,
    frames: {
      addressOf,
      read: async (url: string, frames: readonly number[], count: (bytes: number) => void) => {
        const what = nameFrames(frames, find(url).what);
        return asFile(await readPixels(addressOf(url, frames), { what, reading, count }), url);
      },
    },
  };
  const folder =
    load && (isSeveral || hasFramesAlone(find(first).set, find(first).what))
      ? await FolderReader.of(store, files, read, { load, ...options })
      : undefined;
  return {
    first,
    ...(isSeveral && { files }),
    ...(folder && { folder }),
    isPrivate: true,
    describe: (volume) => ({ ...volume, source: { kind: 'DICOMweb', count: files.length } }),
    // The start of the first one says its format. Its reader reads all of them by itself.
    read: async (url, how) => (folder ? { ...(await folder.readStart(url, keptBytes)), missing: 0 } : read(url, how)),
  };
}

function notNamed(): VolumeViewError {
  return new VolumeViewError('source/not-found', 'the DICOMweb series names files that it does not hold');
}

/** Bytes of a list, of which a page makes many objects: that of 10,000 instances has as many. */
const maxListBytes = 2 ** 26;

async function readMetadata(url: string, reading: QueuedReading): Promise<JsonSet[]> {
  const { bytes } = await fetchFrom(url, {
    accept: 'application/dicom+json',
    what: 'the list of the DICOMweb series',
    reading: { ...reading, maxBytes: Math.min(maxListBytes, reading.maxBytes ?? maxListBytes) },
  });
  let sets: unknown;
  try {
    sets = bytes.length > 0 ? parseJson(new TextDecoder().decode(bytes)) : [];
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
  const [uid] = valuesOf(set, 0x00080018);
  if (typeof uid === 'string' && /^[\d.]{1,64}$/.test(uid)) return uid;
  throw new VolumeViewError(
    'format/corrupt',
    'the DICOMweb server lists an instance without its number (SOPInstanceUID); expected one for each',
  );
}

function valuesOf(set: JsonSet, id: number): readonly unknown[] {
  const values = elementOf(set, id)?.Value;
  return Array.isArray(values) ? values : [];
}

const numbersOf = (set: JsonSet, id: number): number[] => valuesOf(set, id).map(Number);

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

interface InstancePlace {
  readonly url: string;
  /** The address of the server's root. */
  readonly base: string;
  readonly search: string;
  /** For messages. */
  readonly what: string;
}

type InstanceReading = InstancePlace & Pick<PartReading, 'reading'>;

async function readInstance(set: JsonSet, how: InstanceReading): Promise<DecodeInput> {
  const { url, reading } = how;
  let loaded = 0;
  const count = (bytes: number): void => reading.onProgress?.((loaded += bytes), 0);
  const bulk = await readAllBulk(set, how, count);
  const pixels = await readAllPixels(set, how, count);
  return { bytes: writeInstance(set, bulk, pixels), url, contentType: 'application/dicom' };
}

/** What the list says of an instance: a file without its pixels. Nothing is missing where it has none, or its frames can't be had alone. */
async function readStart(set: JsonSet, how: InstanceReading): Promise<DecodeInput> {
  const input = { url: how.url, contentType: 'application/dicom' };
  const bulk = await readAllBulk(set, how, () => undefined);
  const pixels = describePixels(set, how.what);
  if (!pixels || (pixels.frames > 1 && !hasFramesAlone(set, how.what)))
    return { ...input, bytes: writeInstance(set, bulk, null) };
  const { id, frames, frameBytes } = pixels;
  const syntax = guessSyntax(set);
  const isPacked = syntax !== littleEndian;
  const missing = Math.ceil(frames * frameBytes);
  const announced = isPacked ? untilMark : Math.min(missing, untilMark - 1);
  const unread: JsonPixels = { id, syntax, isPacked, pieces: [], announced };
  return { ...input, bytes: writeInstance(set, bulk, unread), missing };
}

/** The length of an element that ends with a mark of its own. */
const untilMark = 0xffffffff;

/** How pixels are packed, of which only the colours say it: others are taken as not packed, until they come. */
function guessSyntax(set: JsonSet): string {
  const [colors] = valuesOf(set, 0x00280004);
  if (/^YBR_(RCT|ICT)$/.test(String(colors))) return '1.2.840.10008.1.2.4.90';
  return colors === 'YBR_FULL_420' ? '1.2.840.10008.1.2.4.50' : littleEndian;
}

/** Where some frames of an instance are, or all its pixels, if its numbers are such as frames do not have on all servers. */
function locate(set: JsonSet, frames: readonly number[], { url, base, search, what }: InstancePlace): WebPixels {
  const { id, bits } = describePixels(set, what) ?? { id: 0x7fe00010, bits: 8 };
  const address = id !== 0x7fe00010 || bits === 1 ? elementOf(set, id)?.BulkDataURI : undefined;
  if (typeof address === 'string') return { url: atServer(address, base, search), id, frames: null };
  const list = frames.map((frame) => frame + 1).join(',');
  return { url: `${url}/frames/${list}${search}`, id, frames: frames.length };
}

/** Whether an instance has several frames, and some of them can be had. Those of a segmentation are read together. */
function hasFramesAlone(set: JsonSet, what: string): boolean {
  const pixels = describePixels(set, what);
  const [kind] = valuesOf(set, 0x00080016);
  return (
    pixels !== null &&
    pixels.frames > 1 &&
    pixels.id === 0x7fe00010 &&
    pixels.bits > 1 &&
    !segmentations.has(String(kind))
  );
}

/** Servers behind others name hosts that nobody else reaches, and a stranger's list must not choose a server. */
function atServer(address: string, base: string, search: string): string {
  const at = address.indexOf('/studies/');
  if (at < 0) throw notNamed();
  return `${base}${address.slice(at)}${search}`;
}

function nameFrames(frames: readonly number[], what: string): string {
  const [first, last] = [frames[0], frames[frames.length - 1]];
  if (frames.length === 1) return `frame ${first + 1} of ${what}`;
  return last - first === frames.length - 1
    ? `frames ${first + 1} to ${last + 1} of ${what}`
    : `${frames.length} frames of ${what}`;
}

async function readAllBulk(
  set: JsonSet,
  { base, search, what, reading }: InstanceReading,
  count: (bytes: number) => void,
): Promise<ReadonlyMap<string, Uint8Array<ArrayBuffer>>> {
  const bulk = new Map<string, Uint8Array<ArrayBuffer>>();
  for (const address of new Set(listBulk(set)))
    bulk.set(address, await readBulk(atServer(address, base, search), { what: `a table of ${what}`, reading, count }));
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
  if (!(bits >= 0 && samples >= 0 && rows <= 0xffff && columns <= 0xffff && bits <= 64 && samples <= 0xffff))
    throw new VolumeViewError(
      'format/corrupt',
      `${what} got ${columns} x ${rows} pixels of ${samples} numbers of ${bits} bits; expected what DICOM has, such as 512 x 512 pixels of 1 number of 16 bits`,
    );
  const id = [0x7fe00008, 0x7fe00009].find((one) => elementOf(set, one)) ?? 0x7fe00010;
  return { id, bits, frames, frameBytes: (rows * columns * samples * bits) / 8 };
}

/** All pixels of an instance. */
async function readAllPixels(
  set: JsonSet,
  how: InstanceReading,
  count: (bytes: number) => void,
): Promise<JsonPixels | null> {
  const { what, reading } = how;
  const described = describePixels(set, what);
  if (!described) return null;
  const { frames, frameBytes } = described;
  const together = locate(set, [0], how);
  if (together.frames === null) return readPixels(together, { what, reading, count });
  const step = Math.max(1, Math.min(maxFrames, Math.floor(bytesAtOnce / frameBytes)));
  const starts = Array.from({ length: Math.ceil(frames / step) }, (_, i) => i * step);
  const parts: JsonPixels[] = [];
  const readOne = async (i: number): Promise<void> => {
    const some = Array.from({ length: Math.min(step, frames - starts[i]) }, (_, k) => starts[i] + k);
    const name = nameFrames(some, what);
    parts[i] = await readPixels(locate(set, some, how), { what: name, reading, count });
  };
  let next = 0;
  const work = async (): Promise<void> => {
    while (next < starts.length) await readOne(next++);
  };
  await Promise.all(Array.from({ length: ahead }, work));
  return joinPixels(parts, what);
}
