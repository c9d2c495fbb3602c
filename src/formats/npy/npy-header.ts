import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { float16 } from '../base/half-floats.ts';
import { floats, numberTypes, viewAs } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import type { PieceReader } from '../base/piece-reader.ts';

const what = 'the NPY header';

export interface NpyHeader {
  readonly type: NumberType;
  readonly littleEndian: boolean;
  /** Whether the first axis is the one whose numbers lie next to each other; else the last one is. */
  readonly isFortran: boolean;
  readonly shape: readonly number[];
  /** Where the samples begin, bytes. */
  readonly end: number;
}

/** NumPy itself refuses longer ones. */
const maxHeaderBytes = 2 ** 16;

const maxAxes = 64;

/** Source: NumPy 2, `numpy.lib.format`, versions 1 to 3. */
export async function readNpyHeader(reader: PieceReader): Promise<NpyHeader> {
  const start = await reader.readStart(12);
  if (start.length < 12) throw corruptFile(what, `got ${start.length} bytes; expected more: the file is cut short`);
  const version = start[6];
  if (version < 1 || version > 3) throw corruptFile(what, `got the version ${version}; expected 1 to 3`);
  const view = new DataView(start.buffer, start.byteOffset, start.length);
  const [from, length] = version === 1 ? [10, view.getUint16(8, true)] : [12, view.getUint32(8, true)];
  if (length > maxHeaderBytes)
    throw corruptFile(what, `got ${length} bytes of description; expected at most ${maxHeaderBytes}`);
  const end = from + length;
  const bytes = await reader.readStart(end);
  if (bytes.length < end) throw corruptFile(what, `got ${bytes.length} bytes; expected ${end}: the file is cut short`);
  return { ...readDescription(new TextDecoder().decode(bytes.subarray(from))), end };
}

/** The description is a dictionary, as Python writes it. */
function readDescription(text: string): Omit<NpyHeader, 'end'> {
  const shape = /'shape'\s*:\s*\(([\d\sL,]*)\)/.exec(text)?.[1];
  const order = /'fortran_order'\s*:\s*(True|False)/.exec(text)?.[1];
  const descr = /'descr'\s*:\s*(?:'([^']{0,40})'|(\[))/.exec(text);
  if (shape === undefined || !order || !descr)
    throw corruptFile(
      what,
      `got "${text.trim().slice(0, 80)}"; expected a dictionary of 'descr', 'fortran_order' and 'shape'`,
    );
  if (descr[2])
    throw unsupportedFile(
      'the NPY file',
      'holds records of several fields; expected an array of numbers: save one field, numpy.save(file, array["field"])',
    );
  const lengths = shape
    .split(',')
    .map((one) => one.replace('L', '').trim())
    .filter((one) => one !== '')
    .map(Number);
  if (lengths.length > maxAxes)
    throw corruptFile(what, `got a shape of ${lengths.length} axes; expected at most ${maxAxes}`);
  checkLengths(what, 'the shape', lengths);
  return { ...readType(descr[1]), isFortran: order === 'True', shape: lengths };
}

const types = new Map<string, NumberType>([
  ['b1', { ...numberTypes.uint8, name: 'bool' }],
  ['i1', numberTypes.int8],
  ['u1', numberTypes.uint8],
  ['i2', numberTypes.int16],
  ['u2', numberTypes.uint16],
  ['i4', numberTypes.int32],
  ['u4', numberTypes.uint32],
  ['i8', numberTypes.int64],
  ['u8', numberTypes.uint64],
  ['f2', float16],
  ['f4', numberTypes.float32],
  ['f8', numberTypes.float64],
  ['c8', floats('complex64', 4, viewAs(Float32Array), true)],
  ['c16', floats('complex128', 8, viewAs(Float64Array), true)],
]);

/** @param descr - such as '<f4': byte order, kind, bytes */
function readType(descr: string): Pick<NpyHeader, 'type' | 'littleEndian'> {
  const [, order, name] = /^([<>|=]?)([a-zA-Z]\d*)/.exec(descr) ?? [];
  const type = types.get(name ?? '');
  if (!type)
    throw unsupportedFile(
      'the NPY file',
      `holds values of the type "${descr}"; expected numbers of 8 to 64 bits: numpy.save(file, array.astype("float32"))`,
    );
  return { type, littleEndian: order !== '>' };
}
