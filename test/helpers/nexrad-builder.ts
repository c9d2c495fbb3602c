/** A radial of message 31 with one moment of 8 bits. */
export interface BuiltRadial {
  readonly azimuth: number;
  readonly elevation: number;
  readonly cut: number;
  readonly gates: number;
  /** Radial status; if absent 1: in the middle of a cut. */
  readonly status?: number;
  /** Whether spot blanking is set. */
  readonly blanked?: boolean;
  /** The code of each gate; 0 if absent. */
  readonly code?: number;
}

const head = (): Uint8Array => {
  const bytes = new Uint8Array(24);
  bytes.set(new TextEncoder().encode('AR2V0006.001'));
  return bytes;
};

function radialMessage({
  azimuth,
  elevation,
  cut,
  gates,
  status = 1,
  blanked = false,
  code = 0,
}: BuiltRadial): Uint8Array {
  const body = 32 + 4 + 28 + gates;
  const length = Math.ceil((16 + body) / 2) * 2;
  const view = new DataView(new ArrayBuffer(12 + length));
  view.setUint16(12, length / 2);
  view.setUint8(15, 31);
  const at = 28;
  view.setFloat32(at + 12, azimuth);
  view.setUint8(at + 21, status);
  view.setUint8(at + 28, Number(blanked));
  view.setUint8(at + 22, cut);
  view.setFloat32(at + 24, elevation);
  view.setUint16(at + 30, 1);
  view.setUint32(at + 32, 36);
  const block = at + 36;
  new Uint8Array(view.buffer).set(new TextEncoder().encode('DREF'), block);
  view.setUint16(block + 8, gates);
  view.setInt16(block + 10, 1000);
  view.setInt16(block + 12, 100);
  view.setUint8(block + 19, 8);
  view.setFloat32(block + 20, 2);
  view.setFloat32(block + 24, 66);
  new Uint8Array(view.buffer, block + 28, gates).fill(code);
  return new Uint8Array(view.buffer);
}

function join(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** NEXRAD Level II, uncompressed. */
export function buildNexrad(radials: readonly BuiltRadial[]): Uint8Array<ArrayBuffer> {
  return join([head(), ...radials.map(radialMessage)]);
}

/** NEXRAD Level II with a number of records; each record is a bzip2 stream without any block. */
export function buildEmptyRecords(count: number): Uint8Array<ArrayBuffer> {
  const record = [0, 0, 0, 14, 0x42, 0x5a, 0x68, 0x39, 0x17, 0x72, 0x45, 0x38, 0x50, 0x90, 0, 0, 0, 0];
  return join([head(), ...Array.from({ length: count }, () => Uint8Array.from(record))]);
}
