import { VolumeViewError } from '../../core/errors.ts';
import { lumaOf } from '../base/channels.ts';
import { floats, hostIsLittleEndian, niftiTypes, viewAs } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';

/** Colours of 8 bits: their numbers are their brightness. nifti1.h: scl_slope and scl_inter do not belong to them. */
function colors(name: string, channels: number): NumberType {
  let rgb: Uint8Array<ArrayBuffer> | undefined;
  return {
    name,
    bytesPerSample: channels,
    bytesPerNumber: 1,
    read: {
      kind: 'integers',
      view(bytes) {
        rgb = copyColors(bytes, channels);
        return toBrightness(bytes, channels);
      },
    },
    complex: true,
    colors: () => rgb && { rgb, range: [0, 255] },
  };
}

/** Red, green and blue of each voxel. */
function copyColors(bytes: Uint8Array, channels: number): Uint8Array<ArrayBuffer> {
  const rgb = new Uint8Array((3 * bytes.length) / channels);
  for (let at = 0; at < rgb.length; at++) rgb[at] = bytes[Math.floor(at / 3) * channels + (at % 3)];
  return rgb;
}

/** Writes over the bytes, and keeps the part that is then in use. */
function toBrightness(bytes: Uint8Array<ArrayBuffer>, channels: number): Uint8Array<ArrayBuffer> {
  const count = bytes.length / channels;
  for (let i = 0, at = 0; i < count; i++, at += channels) bytes[i] = lumaOf(bytes[at], bytes[at + 1], bytes[at + 2]);
  return bytes.slice(0, count);
}

/** Numbers of a voxel in colours; 0 for other types. */
export const colorsOf = ({ name }: Pick<NumberType, 'name'>): number => (/^RGBA?$/.test(name) ? name.length : 0);

/** What of a type's numbers is not shown, in words; null if nothing is lost. */
export function describeLost(type: Pick<NumberType, 'name' | 'complex'>): string | null {
  if (colorsOf(type) === 4) return 'where the voxels are transparent: they are shown as if they were not';
  return type.complex && colorsOf(type) === 0 ? 'the phase of complex numbers, whose magnitudes are shown' : null;
}

/** Types of colours by their codes: each file has one of its own, which keeps its colours. */
const colorTypes: ReadonlyMap<number, readonly [name: string, channels: number]> = new Map([
  [128, ['RGB', 3]],
  [2304, ['RGBA', 4]],
]);

/** NIfTI's datatype codes that few files have. Source: nifti1.h. */
const rareTypes: ReadonlyMap<number, NumberType> = new Map([
  [32, floats('complex64', 4, viewAs(Float32Array), true)],
  [1536, floats('float128', 16, readBinary128)],
  [1792, floats('complex128', 8, viewAs(Float64Array), true)],
  [2048, floats('complex256', 16, readBinary128, true)],
]);

/** What an error says about codes of other kinds of data. */
const refusedTypes: ReadonlyMap<number, string> = new Map([
  [1, 'one bit per voxel (binary), in an order of bits that the standard leaves open'],
]);

/**
 * The type of a code that is not one of the usual ones. @throws {VolumeViewError} `format/unsupported`,
 * `format/corrupt`
 */
export function readRareType(code: number): NumberType {
  const inColors = colorTypes.get(code);
  if (inColors) return colors(...inColors);
  const type = rareTypes.get(code);
  if (type) return type;
  const refused = refusedTypes.get(code);
  if (refused)
    throw new VolumeViewError('format/unsupported', `the NIfTI file holds ${refused}; convert it to numbers first`);
  const known = [...niftiTypes.keys(), ...rareTypes.keys(), ...colorTypes.keys()];
  known.sort((a, b) => a - b);
  throw new VolumeViewError(
    'format/corrupt',
    `the NIfTI header got datatype ${code}; expected one of ${known.join(', ')}`,
  );
}

/**
 * IEEE 754 binary128 to double: sign, 15 bits of exponent, 112 bits of fraction, of which a double keeps 52. (The
 * standard does not mean x86's 80-bit numbers padded to 128; nibabel refuses those too.)
 */
function readBinary128({ buffer, byteOffset, byteLength }: Uint8Array<ArrayBuffer>): Float64Array {
  const view = new DataView(buffer, byteOffset, byteLength);
  const little = hostIsLittleEndian;
  const values = new Float64Array(byteLength / 16);
  for (let i = 0; i < values.length; i++) {
    const high = view.getUint32(16 * i + (little ? 12 : 0), little);
    const words = [8, 4, 0].map((at) => view.getUint32(16 * i + (little ? at : 12 - at), little));
    const sign = high >>> 31 ? -1 : 1;
    const exponent = (high >>> 16) & 0x7fff;
    const fraction = ((high & 0xffff) + (words[0] + (words[1] + words[2] / 2 ** 32) / 2 ** 32) / 2 ** 32) / 2 ** 16;
    if (exponent === 0x7fff) values[i] = fraction === 0 ? sign * Infinity : NaN;
    else if (exponent === 0) values[i] = 0; // Subnormals, below 2^-16382, become 0 as doubles.
    // In two steps, because 2^exponent alone may overflow or underflow although the product does not.
    else
      values[i] =
        sign * (1 + fraction) * 2 ** Math.floor((exponent - 16383) / 2) * 2 ** Math.ceil((exponent - 16383) / 2);
  }
  return values;
}
