import { corruptFile } from '../base/file-problem.ts';

const what = 'the LZ4 data';

/**
 * Unpacks one block of LZ4 into exactly as many bytes as `output` has. Source: lz4_Block_format.md of github.com/lz4/lz4
 * @throws {VolumeViewError} `format/corrupt`
 */
export function unlz4(bytes: Uint8Array, output: Uint8Array): void {
  let [at, out] = [0, 0];
  /** A length whose first four bits are all set goes on in the bytes that follow. */
  const readLength = (first: number): number => {
    let length = first;
    for (let more = first === 15 ? 255 : 0; more === 255; length += more) {
      if (at >= bytes.length) throw corruptFile(what, 'end early');
      more = bytes[at++];
    }
    return length;
  };
  while (at < bytes.length) {
    const token = bytes[at++];
    const literals = readLength(token >> 4);
    if (at + literals > bytes.length || out + literals > output.length)
      throw corruptFile(what, 'have a length that does not fit');
    output.set(bytes.subarray(at, at + literals), out);
    at += literals;
    out += literals;
    if (at === bytes.length) break;
    const distance = bytes[at] + 256 * bytes[at + 1];
    at += 2;
    const length = readLength(token & 15) + 4;
    if (!(distance >= 1 && distance <= out) || out + length > output.length)
      throw corruptFile(what, 'copy from a place that does not exist');
    copyWithin(output, out, distance, length);
    out += length;
  }
  if (out < output.length) throw corruptFile(what, `have ${out} bytes where ${output.length} belong`);
}

/** Repeats what lies `distance` bytes before: what it writes may be read again. */
export function copyWithin(output: Uint8Array, out: number, distance: number, length: number): void {
  if (distance >= length) output.copyWithin(out, out - distance, out - distance + length);
  else for (let i = out; i < out + length; i++) output[i] = output[i - distance];
}
