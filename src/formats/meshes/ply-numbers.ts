import { corrupt } from './mesh-limits.ts';
import { sizeOf } from './ply-header.ts';
import { TextScanner } from './text-scanner.ts';

/** Reads the next number, of one of PLY's types. @throws {VolumeViewError} `format/corrupt` if there is none */
export type NextNumber = (type: string) => number;

export function textNumbers(bytes: Uint8Array, from: number): NextNumber {
  const scanner = new TextScanner(bytes, from);
  return () => {
    const number = scanner.anyNumber();
    if (Number.isNaN(number))
      throw corrupt('PLY', scanner.isAtEnd ? 'ends early' : `has no number in line ${scanner.line} of its data`);
    return number;
  };
}

export function binaryNumbers(bytes: Uint8Array, from: number, isLittle: boolean): NextNumber {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let at = from;
  return (type) => {
    const place = at;
    at += sizeOf(type);
    if (at > bytes.length) throw corrupt('PLY', 'ends early');
    switch (type) {
      case 'char':
      case 'int8':
        return view.getInt8(place);
      case 'uchar':
      case 'uint8':
        return view.getUint8(place);
      case 'short':
      case 'int16':
        return view.getInt16(place, isLittle);
      case 'ushort':
      case 'uint16':
        return view.getUint16(place, isLittle);
      case 'int':
      case 'int32':
        return view.getInt32(place, isLittle);
      case 'uint':
      case 'uint32':
        return view.getUint32(place, isLittle);
      case 'double':
      case 'float64':
        return view.getFloat64(place, isLittle);
      default:
        return view.getFloat32(place, isLittle);
    }
  };
}
