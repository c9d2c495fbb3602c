import { VolumeViewError } from '../../core/errors.ts';

/** Before each message: 12 bytes of the transmission line, then a header of 16. */
const lineHeader = 12;
const messageHeader = 16;

/** All messages except radials of type 31 (and models, 29) fill a frame of this many bytes, however short they are. */
const frameLength = 2432;

/** A message's type and its content after the header. */
export interface NexradMessage {
  readonly type: number;
  /** Number of this part of a long message, from 1. */
  readonly segment: number;
  readonly body: DataView<ArrayBuffer>;
}

/**
 * Yields the messages of a record, one after another.
 * @param onCut - called if the record ends within a message, with the number of missing bytes
 * @throws {VolumeViewError} `format/corrupt`
 * Source: Interface Control Document for the RDA/RPG, 2620002 (NOAA/NWS Radar Operations Center), table II
 */
export function* splitMessages(
  record: Uint8Array<ArrayBuffer>,
  onCut: (missing: number) => void,
): Generator<NexradMessage> {
  const view = new DataView(record.buffer, record.byteOffset, record.length);
  let position = 0;
  while (position + lineHeader + messageHeader <= record.length) {
    const header = position + lineHeader;
    const type = view.getUint8(header + 3);
    const length = readLength(view, header);
    const isFramed = type !== 31 && type !== 29;
    const end = isFramed ? position + frameLength : header + length;
    // The last frame may lack its padding.
    const needed = isFramed ? Math.min(end, header + Math.max(length, messageHeader)) : end;
    if (needed > record.length) return onCut(needed - record.length);
    if (!isFramed && length < messageHeader) {
      throw new VolumeViewError(
        'format/corrupt',
        `the NEXRAD message at byte ${position} of its record got a length of ${length}; expected at least ${messageHeader}`,
      );
    }
    const body = new DataView(
      record.buffer,
      record.byteOffset + header + messageHeader,
      Math.min(end, record.length) - header - messageHeader,
    );
    yield { type, segment: view.getUint16(header + 14), body };
    position = end;
  }
  if (position < record.length) onCut(lineHeader + messageHeader - (record.length - position));
}

/**
 * Bytes of a message with its header. In messages longer than 65,534 halfwords, the fields that normally count segments
 * hold the length in bytes.
 */
function readLength(view: DataView, header: number): number {
  const halfwords = view.getUint16(header);
  return halfwords === 65535 ? view.getUint32(header + 12) : 2 * halfwords;
}
