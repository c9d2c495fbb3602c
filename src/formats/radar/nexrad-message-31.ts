import { VolumeViewError } from '../../core/errors.ts';
import { badStatus, checkRadial, corruptRadial, partOf, timeOf } from './nexrad-radial.ts';
import type { NexradGates, NexradRadial, NexradSite } from './nexrad-radial.ts';

const headerLength = 32;
const volumeLength = 20;
const radialLength = 18;
const momentLength = 28;

/** Spot blanking: the transmitter was off for this radial. Source: ICD 2620002, table XVII-A */
const radialBlanked = 1;

/** Maximum blocks of a radial: 3 of constants and 7 moments, and some for future ones. */
const maxBlocks = 32;

/**
 * Reads a radial of message 31, "digital radar data generic format": constants of volume, elevation and radial, and a
 * block for each moment, which says itself where its gates lie and how its values are packed.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 * Source: Interface Control Document for the RDA/RPG, 2620002, tables XVII-A to XVII-I
 */
export function readMessage31(body: DataView<ArrayBuffer>): NexradRadial {
  const header = partOf(body, 0, headerLength, 'a header');
  if (header.getUint8(16) !== 0) {
    throw new VolumeViewError(
      'format/unsupported',
      `the NEXRAD file packs its radials one by one (method ${header.getUint8(16)}); expected them as they are`,
    );
  }
  const count = header.getUint16(30);
  if (count > maxBlocks) throw corruptRadial(`${count} blocks`, `at most ${maxBlocks}`);
  const pointers = partOf(body, headerLength, 4 * count, 'pointers');
  const moments = new Map<string, NexradGates>();
  let site: NexradSite | undefined;
  let nyquist = 0;
  for (let i = 0; i < count; i++) {
    const start = pointers.getUint32(4 * i);
    if (start === 0) continue;
    const name = readName(partOf(body, start, 4, 'a block'));
    if (name === 'RVOL') site = readSite(partOf(body, start, volumeLength, 'the volume block'));
    else if (name === 'RRAD') nyquist = partOf(body, start, radialLength, 'the radial block').getInt16(16) / 100;
    else if (/^D[A-Z0-9 ]{3}$/.test(name)) moments.set(name.slice(1).trim(), readMoment(body, start, name));
  }
  const status = header.getUint8(21);
  const isBad = (status & badStatus) !== 0 || (header.getUint8(28) & radialBlanked) !== 0;
  return checkRadial({
    azimuth: header.getFloat32(12),
    elevation: header.getFloat32(24),
    time: timeOf(header.getUint16(8), header.getUint32(4)),
    cut: header.getUint8(22),
    status: status & ~badStatus,
    ...(isBad ? { isBad } : {}),
    moments: isBad ? new Map() : moments,
    ...(nyquist > 0 ? { nyquist } : {}),
    ...(site ? { site } : {}),
  });
}

function readName(block: DataView): string {
  return String.fromCharCode(...[0, 1, 2, 3].map((i) => block.getUint8(i)));
}

function readSite(block: DataView): NexradSite | undefined {
  const [latitude, longitude] = [block.getFloat32(8), block.getFloat32(12)];
  if (!(Math.abs(latitude) <= 90 && Math.abs(longitude) <= 360)) return undefined;
  // The tower's foot above sea level, and the antenna's feedhorn above the foot.
  return { latitude, longitude, height: block.getInt16(16) + block.getUint16(18) };
}

function readMoment(body: DataView<ArrayBuffer>, start: number, name: string): NexradGates {
  const block = partOf(body, start, momentLength, `the block ${name}`);
  const gates = block.getUint16(8);
  const bits = block.getUint8(19);
  if (bits !== 8 && bits !== 16) throw corruptRadial(`${bits} bits a gate in ${name}`, '8 or 16');
  return {
    firstGate: block.getInt16(10),
    gateLength: block.getInt16(12),
    scale: block.getFloat32(20),
    offset: block.getFloat32(24),
    bits,
    codes: partOf(body, start + momentLength, (gates * bits) / 8, `${gates} gates of ${name}`),
  };
}
