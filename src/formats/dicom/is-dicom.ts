import { startsWith } from '../base/starts-with.ts';

/** Bytes before the mark of a file. Source: DICOM PS3.10, 7.1 */
export const preambleBytes = 128;

/**
 * Whether bytes begin as a DICOM file: with a preamble of any bytes, or, in old files, with an element of group 2 or 8,
 * whose representation is explicit, or one of the first ones of group 8 with a short text.
 */
export function isDicom(bytes: Uint8Array): boolean {
  if (startsWith(bytes.subarray(preambleBytes, preambleBytes + 4), 'DICM')) return true;
  const [group, second, element, third, a, b, c, d] = bytes;
  if (bytes.length < 16 || second !== 0 || third !== 0) return false;
  if ((group === 2 || group === 8) && /^[A-Z]{2}$/.test(String.fromCharCode(a, b))) return true;
  return (
    group === 8 &&
    [0, 1, 5, 8, 0x12, 0x16, 0x18].includes(element) &&
    a > 0 &&
    a % 2 === 0 &&
    b === 0 &&
    c === 0 &&
    d === 0
  );
}
