const crcTable = Int32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

/** Adds bytes to a CRC-32 as gzip has it, the lowest bit first: it begins with -1, and ends inverted. Source: RFC 1952, 8 */
export function addToCrc(crc: number, bytes: Uint8Array): number {
  for (let i = 0; i < bytes.length; i++) crc = (crc >>> 8) ^ crcTable[(crc ^ bytes[i]) & 0xff];
  return crc;
}

/** The CRC-32 of bytes, as gzip and ZIP have it. */
export function crc32(bytes: Uint8Array): number {
  return ~addToCrc(-1, bytes) >>> 0;
}
