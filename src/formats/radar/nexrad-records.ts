import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import { bunzip2, isBzip2 } from '../codecs/bunzip2.ts';
import { Bunzip2Room } from '../codecs/bunzip2-room.ts';

/** Bytes of the file's header, and of the length before each compressed record. */
const headerLength = 24;
const controlLength = 4;

/** Maximum bytes of an unpacked record: more than any radar's, and few enough for memory. */
const maxRecordBytes = 2 ** 26;
const maxBytes = 2 ** 30;

/** Maximum number of volumes of one file that are examined. */
const maxVolumes = 64;

/** 'A' of 'AR2V' and 'ARCHIVE2'. */
const firstOfHeader = 0x41;

/** Memory for a record in addition to its bytes. */
const bytesPerRecord = 256;

/** An Archive II volume, unpacked. */
export interface NexradRecords {
  /** The radar's station code, four letters; '' in files before 2003. */
  readonly station: string;
  /** Each is a sequence of whole messages. */
  readonly records: readonly Uint8Array<ArrayBuffer>[];
  /** What is missing at the end, in words. */
  readonly cut?: string;
}

/** Whether a file says that it is NEXRAD Level II: 'AR2V0006.736' or, before 2003, 'ARCHIVE2.001'. */
export function isNexrad(bytes: Uint8Array): boolean {
  return /^(AR2V\d{4}|ARCHIVE2)\./.test(latin1(bytes.subarray(0, 9)));
}

/**
 * Splits an Archive II file into a header and records. The records are packed with bzip2 one by one, or are messages
 * without packing. For a file that was cut short, it returns the complete part. A radar that restarted wrote another
 * header, with a volume of its own.
 * @returns at least one volume
 * @param budget - the unpacked records are taken from it
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/too-large`
 * Source: Interface Control Document for the Archive II/User, 2620010 (NOAA/NWS Radar Operations Center), 7
 */
export function splitRecords(bytes: Uint8Array<ArrayBuffer>, budget: Budget): NexradRecords[] {
  if (!isNexrad(bytes)) {
    throw new VolumeViewError(
      'format/unknown',
      'the file does not begin with "AR2V" or "ARCHIVE2"; expected NEXRAD Level II',
    );
  }
  const volumes: NexradRecords[] = [];
  for (let begin = 0; begin < bytes.length && volumes.length < maxVolumes;) {
    const rest = bytes.subarray(begin);
    const station = /^[A-Z0-9]{4}$/.exec(latin1(rest.subarray(20, headerLength)))?.[0] ?? '';
    if (isBzip2(rest.subarray(headerLength + controlLength))) {
      const { next, ...unpacked } = unpackRecords(rest, budget);
      volumes.push({ station, ...unpacked });
      begin += next;
    } else {
      const next = findHeader(rest, headerLength);
      volumes.push({ station, records: [rest.subarray(headerLength, next)] });
      begin += next;
    }
  }
  return volumes;
}

/** Where the next header begins; the file's length if there is none. */
function findHeader(bytes: Uint8Array, from: number): number {
  for (let at = bytes.indexOf(firstOfHeader, from); at >= 0; at = bytes.indexOf(firstOfHeader, at + 1)) {
    if (bytes[at + 1] === 0x52 && isNexrad(bytes.subarray(at, at + 9))) return at;
  }
  return bytes.length;
}

function unpackRecords(
  bytes: Uint8Array<ArrayBuffer>,
  budget: Budget,
): Pick<NexradRecords, 'records' | 'cut'> & { readonly next: number } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const records: Uint8Array<ArrayBuffer>[] = [];
  const room = new Bunzip2Room(budget);
  let unpacked = 0;
  let position = headerLength;
  while (position + controlLength <= bytes.length) {
    if (isNexrad(bytes.subarray(position, position + 9))) {
      room.release();
      return { records, next: position };
    }
    // The length of the last record is negative.
    const length = Math.abs(view.getInt32(position));
    const start = position + controlLength;
    const end = start + length;
    if (length === 0) break;
    if (end > bytes.length) {
      room.release();
      return {
        records,
        next: bytes.length,
        cut: `record ${records.length + 1} needs ${end - bytes.length} bytes more than the file has`,
      };
    }
    const record = bunzip2(bytes.subarray(start, end), Math.min(maxRecordBytes, maxBytes - unpacked), room);
    budget.take(record.length + bytesPerRecord, 'a record of the NEXRAD file');
    records.push(record);
    unpacked += record.length;
    position = end;
  }
  room.release();
  return { records, next: bytes.length };
}

function latin1(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes);
}
