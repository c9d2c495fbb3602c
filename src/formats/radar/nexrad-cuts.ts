/** Bytes of a volume coverage pattern's header, and of each of its cuts. */
const headLength = 22;
const cutLength = 46;

/**
 * The elevations of a volume coverage pattern, message 5 or 7.
 * @returns degrees, by cut; none if the message is empty, as in old files
 * Source: Interface Control Document for the RDA/RPG, 2620002, tables XI and III-A (angles: 0x8000 is 180 degrees)
 */
export function readCuts(body: DataView<ArrayBuffer>): number[] {
  if (body.byteLength < headLength) return [];
  const count = Math.min(body.getUint16(6), Math.floor((body.byteLength - headLength) / cutLength));
  return Array.from({ length: count }, (_, i) => {
    const angle = (body.getUint16(headLength + i * cutLength) * 180) / 32768;
    return angle > 180 ? angle - 360 : angle;
  });
}
