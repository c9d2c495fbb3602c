import { corruptFile } from '../base/file-problem.ts';

/** Bytes of the message header and of the description of the product, with which a graphic product begins. */
export const level3HeadBytes = 120;

/** How far into a file the message may begin: lines of a bulletin, as weather services send them, come before it. */
const farthestStart = 128;

/** A divider, -1, lies before each block. */
const divider = -1;

/** The numbers of a product's description that are used here. Latitude and longitude in degrees, height in metres. */
export interface Level3Message {
  /** Of the product: 94 is base reflectivity. */
  readonly code: number;
  /** Where the message begins, bytes. */
  readonly start: number;
  readonly latitude: number;
  readonly longitude: number;
  readonly height: number;
  /** When the scan began, milliseconds since 1970. */
  readonly time: number;
  /** Degrees; for products of one elevation. */
  readonly elevation: number;
  /** Halfwords 31 to 46 of the message, from which values follow, 32 bytes. */
  readonly levels: DataView<ArrayBuffer>;
  /** The radar's three letters, where the lines of a bulletin say them. */
  readonly station: string;
}

const viewOf = ({ buffer, byteOffset, byteLength }: Uint8Array): DataView<ArrayBuffer> =>
  new DataView(buffer as ArrayBuffer, byteOffset, byteLength);

/** Where a graphic product begins in a file; -1 if there is none. Source: as readLevel3 */
export function findLevel3(bytes: Uint8Array): number {
  const view = viewOf(bytes);
  const last = Math.min(farthestStart, bytes.length - level3HeadBytes);
  for (let at = 0; at <= last; at++) {
    const code = view.getInt16(at);
    if (code < 16 || code > 400 || view.getInt16(at + 18) !== divider || view.getInt16(at + 30) !== code) continue;
    const isPlace = Math.abs(view.getInt32(at + 20)) <= 90_000 && Math.abs(view.getInt32(at + 24)) <= 180_000;
    if (isPlace && view.getInt32(at + 8) >= level3HeadBytes) return at;
  }
  return -1;
}

/** Reads the head of a product. @throws {VolumeViewError} `format/corrupt` */
export function readLevel3Message(bytes: Uint8Array): Level3Message {
  const start = findLevel3(bytes);
  if (start < 0)
    throw corruptFile('the NEXRAD Level III file', 'holds no graphic product; expected its header in the first bytes');
  const view = viewOf(bytes.subarray(start, start + level3HeadBytes));
  const lines = String.fromCharCode(...bytes.subarray(0, start));
  return {
    code: view.getInt16(0),
    start,
    latitude: view.getInt32(20) / 1000,
    longitude: view.getInt32(24) / 1000,
    height: view.getInt16(28) * 0.3048,
    // The first day of 1970 is day 1.
    time: (view.getInt16(40) - 1) * 86_400_000 + view.getInt32(42) * 1000,
    elevation: view.getInt16(58) / 10,
    levels: viewOf(bytes.slice(start + 60, start + 92)),
    station: /[\r\n][A-Z0-9]{3}([A-Z0-9]{3})[\r\n ]*$/.exec(lines)?.[1] ?? '',
  };
}
