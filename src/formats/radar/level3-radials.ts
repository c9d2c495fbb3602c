import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { refuseSweep } from './radar-limits.ts';

/** Packets with radials: bytes, and runs of one of sixteen levels. */
const [digital, runs] = [16, 0xaf1f];

/** Bytes before the radials of a packet, and before each of them. */
const [packetHead, radialHead] = [14, 6];

/** Bytes of the symbology block and of its first layer before the first packet. */
const symbologyHead = 16;

/** Radials as a product has them: degrees, and the number of each gate, [radials, gates]. */
export interface Level3Radials {
  readonly azimuths: Float64Array<ArrayBuffer>;
  readonly gates: number;
  /** The number of the first gate: most begin at the radar, with 0. */
  readonly first: number;
  readonly codes: Uint8Array<ArrayBuffer>;
  /** The number of radials that the packet announces, of which fewer may be there. */
  readonly announced: number;
}

/**
 * Reads the radials of a product.
 * @param block - the symbology block, unpacked
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 * Source: ICD 2620001, figures 3-6, 3-10 and 3-11c
 */
export function readLevel3Radials(block: Uint8Array<ArrayBuffer>, budget: Budget): Level3Radials {
  const what = 'the NEXRAD Level III product';
  const view = new DataView(block.buffer, block.byteOffset, block.length);
  if (block.length < symbologyHead + packetHead || view.getInt16(0) !== -1 || view.getInt16(2) !== 1)
    throw corruptFile(
      what,
      `got ${block.length} bytes of symbols without their mark; the file is damaged or cut short`,
    );
  const packet = view.getUint16(symbologyHead);
  if (packet !== digital && packet !== runs)
    throw unsupportedFile(
      what,
      `holds a packet ${packet} first; expected radials, packets 16 and AF1F. NOAA's Weather and Climate Toolkit converts it to NetCDF`,
    );
  const field = (index: number): number => view.getUint16(symbologyHead + 2 * index);
  const [first, gates, announced] = [field(1), field(2), field(6)];
  refuseSweep(what, announced, gates);
  budget.take(announced * (gates + 8), what);
  const codes = new Uint8Array(announced * gates);
  const azimuths: number[] = [];
  let at = symbologyHead + packetHead;
  for (let radial = 0; radial < announced && at + radialHead <= block.length; radial++) {
    const length = view.getUint16(at) * (packet === runs ? 2 : 1);
    const [start, delta] = [view.getUint16(at + 2) / 10, view.getUint16(at + 4) / 10];
    const numbers = block.subarray(at + radialHead, at + radialHead + length);
    if (numbers.length < length) break;
    const row = codes.subarray(radial * gates, (radial + 1) * gates);
    if (packet === runs) unpackRuns(numbers, row);
    else row.set(numbers.subarray(0, gates));
    azimuths.push((start + delta / 2) % 360);
    at += radialHead + length;
  }
  if (azimuths.length === 0) throw corruptFile(what, 'holds no whole radial; the file is cut short');
  return {
    azimuths: Float64Array.from(azimuths),
    gates,
    first,
    codes: codes.subarray(0, azimuths.length * gates),
    announced,
  };
}

/** Each byte is a run: its length, and the level. */
function unpackRuns(numbers: Uint8Array, row: Uint8Array): void {
  let gate = 0;
  for (const byte of numbers) {
    row.fill(byte & 15, gate, gate + (byte >> 4));
    gate += byte >> 4;
  }
}
