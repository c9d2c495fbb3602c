import { corruptFile } from '../base/file-problem.ts';
import { copyWithin } from './unlz4.ts';

const what = 'the BloscLZ data';

/** Distances from here on are written in two more bytes. */
const farDistance = 8191;

/**
 * Unpacks BloscLZ, a kind of FastLZ, into exactly as many bytes as `output` has. Source: the format as c-blosc 1.21 writes it,
 * blosc/blosclz.c of github.com/Blosc/c-blosc
 * @throws {VolumeViewError} `format/corrupt`
 */
export function unblosclz(bytes: Uint8Array, output: Uint8Array): void {
  let [at, out] = [0, 0];
  const next = (): number => {
    if (at >= bytes.length) throw corruptFile(what, 'end early');
    return bytes[at++];
  };
  // The first byte has the version in its upper bits.
  for (let control = next() & 31; ; control = next()) {
    if (control < 32) {
      const literals = control + 1;
      if (at + literals > bytes.length || out + literals > output.length)
        throw corruptFile(what, 'have a length that does not fit');
      output.set(bytes.subarray(at, at + literals), out);
      at += literals;
      out += literals;
    } else {
      let length = (control >> 5) + 2;
      if (length === 9) for (let more = 255; more === 255; length += more) more = next();
      const high = (control & 31) << 8;
      const low = next();
      const distance = low === 255 && high === 31 << 8 ? 1 + farDistance + next() * 256 + next() : 1 + high + low;
      if (distance > out || out + length > output.length)
        throw corruptFile(what, 'copy from a place that does not exist');
      copyWithin(output, out, distance, length);
      out += length;
    }
    if (at >= bytes.length) break;
  }
  if (out < output.length) throw corruptFile(what, `have ${out} bytes where ${output.length} belong`);
}
