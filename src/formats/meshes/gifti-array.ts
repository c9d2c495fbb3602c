import { VolumeViewError } from '../../core/errors.ts';
import { unzlib } from '../codecs/unzlib.ts';
import { decodeBase64 } from './base64.ts';
import { corrupt } from './mesh-limits.ts';
import { TextScanner } from './text-scanner.ts';
import { joinPieces } from '../base/join-pieces.ts';

/** One array of a GIfTI file, as the file has it. */
export interface GiftiArray {
  readonly attributes: ReadonlyMap<string, string>;
  /** The number of values that the file announces. */
  readonly count: number;
  readonly rows: number;
  data: string;
  readonly transforms: Map<string, string>[];
}

const types: Readonly<
  Record<string, { readonly bytes: number; readonly read: (view: DataView, at: number, isLittle: boolean) => number }>
> = {
  NIFTI_TYPE_UINT8: { bytes: 1, read: (view, at) => view.getUint8(at) },
  NIFTI_TYPE_INT32: { bytes: 4, read: (view, at, isLittle) => view.getInt32(at, isLittle) },
  NIFTI_TYPE_UINT32: { bytes: 4, read: (view, at, isLittle) => view.getUint32(at, isLittle) },
  NIFTI_TYPE_FLOAT32: { bytes: 4, read: (view, at, isLittle) => view.getFloat32(at, isLittle) },
  NIFTI_TYPE_FLOAT64: { bytes: 8, read: (view, at, isLittle) => view.getFloat64(at, isLittle) },
};

/** The numbers of an array, three in a row. @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export async function decodeArray(array: GiftiArray): Promise<Float64Array> {
  const { attributes, count, rows } = array;
  const [encoding, order] = [attributes.get('Encoding') ?? '', attributes.get('ArrayIndexingOrder')];
  if (count !== 3 * rows)
    throw corrupt('GIfTI file', `has an array of ${count} numbers in ${rows} rows; expected three in each`);
  const numbers = encoding === 'ASCII' ? readText(array) : await readBytes(array, encoding);
  array.data = '';
  return order === 'ColumnMajorOrder' ? turn(numbers, rows) : numbers;
}

function readText({ data, count }: GiftiArray): Float64Array {
  const bytes = new TextEncoder().encode(data);
  if (bytes.length < 2 * count - 1) throw tooShort();
  const scanner = new TextScanner(bytes);
  return Float64Array.from({ length: count }, () => {
    const number = scanner.anyNumber();
    if (Number.isNaN(number)) throw tooShort();
    return number;
  });
}

async function readBytes({ data, attributes, count }: GiftiArray, encoding: string): Promise<Float64Array> {
  const type = types[attributes.get('DataType') ?? ''];
  if (!type)
    throw new VolumeViewError(
      'format/unsupported',
      `the GIfTI file has numbers of the type "${String(attributes.get('DataType')).slice(0, 40)}"; expected one of ${Object.keys(types).join(', ')}`,
    );
  if (encoding === 'ExternalFileBinary')
    throw new VolumeViewError(
      'format/unsupported',
      'the GIfTI file has its numbers in another file (ExternalFileBinary); expected them in the file itself. Convert it: wb_command -gifti-convert GZIP_BASE64_BINARY in.gii out.gii',
    );
  if (encoding !== 'Base64Binary' && encoding !== 'GZipBase64Binary')
    throw new VolumeViewError(
      'format/unsupported',
      `the GIfTI file has the encoding "${encoding.slice(0, 40)}"; expected ASCII, Base64Binary or GZipBase64Binary`,
    );
  const packed = decodeBase64(data);
  if (!packed) throw corrupt('GIfTI file', 'has data that are no Base64');
  const length = count * type.bytes;
  const bytes = encoding === 'Base64Binary' ? packed : await unpackSome(packed, length);
  if (bytes.length < length) throw tooShort();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const isLittle = attributes.get('Endian') !== 'BigEndian';
  return Float64Array.from({ length: count }, (_, i) => type.read(view, i * type.bytes, isLittle));
}

/** GIfTI's "gzip" data are zlib data. No more is unpacked than the array needs. */
async function unpackSome(packed: Uint8Array<ArrayBuffer>, length: number): Promise<Uint8Array> {
  const pieces: Uint8Array[] = [];
  let sum = 0;
  for await (const piece of unzlib(packed)) {
    pieces.push(piece);
    sum += piece.length;
    if (sum >= length) break;
  }
  return joinPieces(pieces);
}

/** From column-major to row-major order. */
function turn(numbers: Float64Array, rows: number): Float64Array {
  return numbers.map((_, i) => numbers[(i % 3) * rows + Math.floor(i / 3)]);
}

const tooShort = (): VolumeViewError => corrupt('GIfTI file', 'has fewer numbers than it says');
